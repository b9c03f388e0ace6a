"""Giving feedback: what is perceived -> what is wished, without physics."""

import math

import numpy as np
import pytest

from household import household_v0
from household.feedback import Cause
from household.scenario.persona import Persona
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep
from policies.people.feedback_giving import FeedbackGiving

LIVES = 4000
"""Independent people in whom a chance is counted."""


def bout(value, robot=0, attending=True):
    return (value, robot, attending)


def percept(*bouts, **changes):
    """What somebody perceives, to be made for as many as there are."""
    return changes | {"bouts": bouts}


def certain(**traits):
    """Somebody who reacts to whatever is wholly good or bad."""
    usual = {
        "praise": 1.0,
        "sanction": 1.0,
        "habituation": 0.0,
        "irritability": 0.0,
        "reaction": 0.0,
    }
    return Persona(name="certain", **(usual | traits))


@pytest.fixture
def wishes(percepts):
    """What somebody is out to do after each percept."""

    def found(persona, perceived, seed=0):
        person = FeedbackGiving([persona], 2, [np.random.default_rng(seed)])
        wished = []
        for each in perceived:
            person.consider(percepts(1, 2, **each))
            (wish,) = person.wishes
            wished.append(wish and (wish.kind, wish.robot))
        return wished

    return found


@pytest.fixture
def share(percepts):
    """How often the last percept makes somebody wish to touch, out of many lives.

    Wishes of before are forgotten without time passing.
    """

    def counted(persona, before, last):
        rngs = [np.random.default_rng(seed) for seed in range(LIVES)]
        people = FeedbackGiving([persona] * LIVES, 2, rngs)
        for each in before:
            people.consider(percepts(LIVES, 2, **each))
        # A touch makes room for the next wish in the very moment that it is felt.
        people.consider(percepts(LIVES, 2, **(last | {"touched": True})))
        return sum(wish is not None for wish in people.wishes) / LIVES

    return counted


def chance(p):
    """Equal to a frequency that lies within four standard errors."""
    return pytest.approx(p, abs=4 * math.sqrt(p * (1 - p) / LIVES) + 1e-12)


NOTHING = percept()
DONE = percept(touched=True)
CARESS, TAP = ("caress", 0), ("tap", 0)


@pytest.mark.parametrize(
    ("traits", "perceived", "expected"),
    [
        ({}, [NOTHING], [None]),
        ({}, [percept(bout(1.0))], [CARESS]),
        ({}, [percept(bout(-1.0))], [TAP]),
        ({}, [percept(bout(-1.0, robot=1))], [("tap", 1)]),
        ({"praise": 0.0}, [percept(bout(1.0))], [None]),
        ({"sanction": 0.0}, [percept(bout(-1.0))], [None]),
        # A wish lasts until it is fulfilled; then it is gone.
        ({}, [percept(bout(-1.0)), NOTHING, DONE, NOTHING], [TAP, TAP, None, None]),
        # Who is out to tap does not think better of it on the way.
        ({}, [percept(bout(-1.0)), percept(bout(1.0))], [TAP, TAP]),
        ({}, [percept(bout(-1.0)), percept(bout(-1.0, robot=1))], [TAP, TAP]),
        # The touch is done, and the next fault is there already.
        (
            {},
            [percept(bout(-1.0)), percept(bout(-1.0, robot=1), touched=True)],
            [TAP, ("tap", 1)],
        ),
        # Of two at once the first counts.
        ({}, [percept(bout(-1.0), bout(1.0, robot=1))], [TAP]),
        # Patience of two seconds: the third is too long.
        (
            {"patience": 2.0},
            [percept(bout(-1.0)), *[NOTHING] * 3],
            [TAP, TAP, TAP, None],
        ),
        ({}, [percept(bout(-1.0, attending=False))], [TAP]),
        ({"mistakes": 1.0}, [percept(bout(-1.0))], [CARESS]),
        ({"mistakes": 1.0}, [percept(bout(1.0))], [TAP]),
        # Who is myopic touches for what the robot did last, whatever it came for ...
        ({"myopia": 0.9}, [percept(bout(-1.0)), percept(bout(0.2))], [TAP, CARESS]),
        # ... unless that is hardly worth it, or another robot did it.
        ({"myopia": 0.9}, [percept(bout(-1.0)), percept(bout(0.1))], [TAP, TAP]),
        (
            {"myopia": 0.9},
            [percept(bout(-1.0)), percept(bout(1.0, robot=1))],
            [TAP, TAP],
        ),
        ({"myopia": 0.9}, [percept(bout(1.0)), DONE, NOTHING], [CARESS, None, None]),
    ],
)
def test_what_is_perceived_makes_what_is_wished(wishes, traits, perceived, expected):
    assert wishes(certain(**traits), perceived) == expected


def test_a_myopic_touch_is_as_strong_as_the_last_appraisal_and_about_that_bout(
    percepts,
):
    person = FeedbackGiving([certain(myopia=0.9)], 2, [np.random.default_rng(0)])
    person.consider(percepts(1, 2, bouts=((-1.0, 0, True),), time=12.0))
    person.consider(percepts(1, 2, bouts=((0.5, 0, True),), time=15.0))
    (wish,) = person.wishes
    assert (wish.kind, wish.strength, wish.cause.time) == ("caress", 0.5, 15.0)
    assert person.changed.tolist() == [True]


def test_what_comes_to_mind_before_a_myopic_person_has_reacted_counts(percepts):
    slow = certain(myopia=0.9, reaction=60.0, haste=0.0, reaction_spread=0.0)
    person = FeedbackGiving([slow], 1, [np.random.default_rng(0)])
    wished = []
    for value in (-1.0, 1.0, *[0.0] * 59):
        bouts = ((value, 0, True),) if value else ()
        person.consider(percepts(1, 1, bouts=bouts))
        wished.append(person.wishes[0] and person.wishes[0].kind)
    assert wished == [None] * 60 + ["caress"]


@pytest.mark.parametrize(
    ("mistakes", "doubt", "value", "wrong"),
    [
        (0.2, 0.0, -1.0, 0.2),
        (0.0, 1.0, 1.0, 1 / (1 + math.exp(2))),
        (0.0, 1.0, 0.2, 1 / (1 + math.exp(0.4))),
        (0.0, 0.5, -0.5, 1 / (1 + math.exp(2))),
        (0.0, 1e-9, -0.1, 0.0),
        # Both at once is right again.
        (0.3, 1.0, 1.0, 0.3 + 0.4 / (1 + math.exp(2))),
    ],
)
def test_touches_are_wrong_by_mistake_and_the_fainter_the_more_by_doubt(
    percepts, mistakes, doubt, value, wrong
):
    sure = {"praise": 1e9, "sanction": 1e9}  # whatever is felt is told
    persona = certain(mistakes=mistakes, doubt=doubt, **sure)
    rngs = [np.random.default_rng(seed) for seed in range(LIVES)]
    people = FeedbackGiving([persona] * LIVES, 1, rngs)
    people.consider(percepts(LIVES, 1, bouts=(bout(value),)))
    told = [wish.kind == "caress" for wish in people.wishes]
    assert np.mean(np.array(told) != (value > 0.0)) == chance(wrong)


def test_a_wish_is_as_strong_as_the_appraisal_and_carries_its_cause(percepts):
    """Blamed for what another did: the touch goes to one, its cause is the other."""
    person = FeedbackGiving([certain()], 2, [np.random.default_rng(0)])
    calm, fault = (0.0, 0, False), (-0.9999, 0, True)
    person.consider(percepts(1, 2, bouts=(calm, fault), time=12.0))
    (wish,) = person.wishes
    assert (wish.robot, wish.kind, wish.strength) == (0, "tap", 0.9999)
    assert wish.cause == Cause("robot_1", 7, 0, 12.0)


def test_a_wish_changes_when_it_is_formed_and_when_it_ends(percepts):
    """Of two people one is out to tap; a fault on its way changes nothing."""
    rngs = [np.random.default_rng(i) for i in range(2)]
    people = FeedbackGiving([certain(), certain(sanction=0.0)], 2, rngs)
    fault, later = (bout(-1.0),), (bout(-1.0, robot=1),)
    wished, changed = [], []
    for what in ({"bouts": fault}, {"bouts": later}, {"touched": True}, {}):
        people.consider(percepts(2, 2, **what))
        wished.append(people.wishes[0])
        changed.append(people.changed.tolist())
        assert people.wishes[1] is None
    assert wished[0] == wished[1] is not None
    assert wished[2:] == [None, None]
    assert changed == [[True, False], [False, False], [True, False], [False, False]]


def delays(percepts, persona, value=-1.0, period=1.0, most=200):
    """How many periods many people take to react to a bout, in seconds."""
    rngs = [np.random.default_rng(seed) for seed in range(LIVES)]
    people = FeedbackGiving([persona] * LIVES, 1, rngs)
    taken = np.full(LIVES, np.nan)
    appraised = percepts(LIVES, 1, bouts=(bout(value),), period=period)
    calm = percepts(LIVES, 1, period=period)
    for k in range(most):
        people.consider(calm if k else appraised)
        taken[people.changed & np.isnan(taken)] = k * period
    return taken


@pytest.mark.parametrize(("value", "median"), [(-1.0, 0.75), (0.5, 1.08), (0.1, 1.43)])
def test_people_react_as_fast_as_those_who_taught_a_robot_arm(percepts, value, median):
    """CHARM: strong ratings .75 s, weaker ones 1.2 s, those of 0 1.54 s."""
    taken = delays(percepts, certain(reaction=1.54), value, 0.01, 900)
    reacted = taken[~np.isnan(taken)]
    # The standard error of the logarithm's median.
    error = 0.48 * math.sqrt(math.pi / 2 / len(reacted))
    assert np.median(reacted) == pytest.approx(median, rel=4 * error + 0.01)
    if abs(value) == 1.0:
        assert np.std(np.log(reacted)) == pytest.approx(0.48, rel=0.1)


def test_who_decides_once_a_second_reacts_at_the_nearest_second(percepts):
    """Half a second in the median, hardly spread: below that at once, above a second
    later."""
    swift = certain(reaction=0.4, haste=0.0, reaction_spread=0.01)
    slow = certain(reaction=0.6, haste=0.0, reaction_spread=0.01)
    assert set(delays(percepts, swift, most=3)) == {0.0}
    assert set(delays(percepts, slow, most=3)) == {1.0}


def test_rounding_to_decisions_makes_reactions_neither_later_nor_earlier(percepts):
    persona = certain(reaction=3.0, haste=0.0)
    mean = 3.0 * math.exp(0.48**2 / 2)
    assert np.mean(delays(percepts, persona)) == pytest.approx(mean, rel=0.04)


def test_the_touch_is_for_the_bout_that_was_judged_however_late_it_comes(percepts):
    """A fault at 12 s, 2 s of reaction; by then it plays, which pleases as much."""
    late = certain(reaction=2.0, haste=0.0, reaction_spread=0.0)
    person = FeedbackGiving([late], 1, [np.random.default_rng(0)])
    wished = []
    for k, value in enumerate((-1.0, 1.0, 1.0, 1.0)):
        what = percepts(1, 1, bouts=(bout(value),), time=12.0 + k)
        person.consider(what)
        wished.append(person.wishes[0])
    assert wished[:2] == [None, None]
    assert wished[2] == wished[3]
    assert (wished[2].kind, wished[2].cause.time) == ("tap", 12.0)


def test_patience_counts_from_the_reaction(wishes):
    late = certain(reaction=3.0, haste=0.0, reaction_spread=0.0, patience=2.0)
    wished = wishes(late, [percept(bout(-1.0)), *[NOTHING] * 6])
    assert wished == [None, None, None, TAP, TAP, TAP, None]


def test_a_new_wish_has_all_its_patience(wishes):
    fault, calm = percept(bout(-1.0)), [NOTHING] * 10
    wished = wishes(certain(patience=3.0), [*calm, fault, *[NOTHING] * 3])
    assert wished[-4:] == [TAP] * 4


@pytest.mark.parametrize("value", [1.0, 0.5])
def test_the_chance_of_praise_is_the_readiness_times_how_polite_it_was(share, value):
    assert share(certain(praise=0.6), [], percept(bout(value))) == chance(0.6 * value)


def test_praise_for_what_goes_on_becomes_rarer_by_the_same_share(share):
    """Habituation of one half: 1, 1/2, 1/4, 1/8."""
    polite = percept(bout(1.0), pleasing=True)
    for n in range(4):
        frequency = share(certain(habituation=0.5), [polite] * n, polite)
        assert frequency == chance(0.5**n)


def test_what_is_half_as_polite_is_got_used_to_half_as_fast(share):
    half = percept(bout(0.5), pleasing=True)
    polite = percept(bout(1.0), pleasing=True)
    assert share(certain(habituation=0.5), [half], polite) == chance(0.75)


def test_people_get_used_to_each_robot_on_its_own(share):
    polite = [percept(bout(1.0), pleasing=True)] * 5
    other = percept(bout(1.0, robot=1), pleasing=True)
    assert share(certain(habituation=0.9), polite, other) == 1.0


def test_without_what_pleases_the_wish_to_praise_recovers(share):
    """From 1/4, one time constant brings back 1 - 1/e of what is missing."""
    persona = certain(habituation=0.5, recovery=50.0)
    polite = percept(bout(1.0), pleasing=True)
    rest = [percept(period=10.0)] * 4
    last = percept(bout(1.0), period=10.0)
    expected = 1.0 - 0.75 * math.exp(-1.0)
    assert share(persona, [polite, polite, *rest], last) == chance(expected)


def test_while_what_pleases_goes_on_the_wish_to_praise_does_not_recover(share):
    persona = certain(habituation=0.5, recovery=1.0)
    polite = percept(bout(1.0), pleasing=True)
    going_on = percept(pleasing=True)
    assert share(persona, [polite, *[going_on] * 50], polite) == chance(0.5)


@pytest.mark.parametrize(
    ("fault", "after"),
    [
        (-1.0, 0.5),
        # Half as bad: half of the people sanction it, with half of the effect.
        (-0.5, 0.5 * 0.25),
    ],
)
def test_a_fault_that_was_sanctioned_makes_politeness_welcome_again(
    share, fault, after
):
    """Wholly used to it; contrast of one half brings back half of the wish."""
    persona = certain(habituation=1.0, contrast=0.5, recovery=1e9)
    polite, bad = percept(bout(1.0), pleasing=True), percept(bout(fault))
    assert share(persona, [polite], polite) == 0.0
    assert share(persona, [polite, DONE, bad], polite) == chance(after)


def test_a_fault_that_nobody_sanctions_does_not_make_politeness_welcome(share):
    persona = certain(habituation=1.0, contrast=1.0, recovery=1e9, sanction=0.0)
    polite, bad = percept(bout(1.0), pleasing=True), percept(bout(-1.0))
    assert share(persona, [polite, DONE, *[bad] * 5], polite) == 0.0


def test_who_gave_up_on_the_way_has_sanctioned_nothing(share):
    persona = certain(habituation=1.0, contrast=1.0, recovery=1e9, patience=2.0)
    polite, bad = percept(bout(1.0), pleasing=True), percept(bout(-1.0))
    given_up = [bad, *[NOTHING] * 3]
    assert share(persona, [polite, DONE, *given_up], polite) == 0.0


def test_a_caress_does_not_make_politeness_welcome(share):
    persona = certain(habituation=1.0, contrast=1.0, recovery=1e9)
    polite = percept(bout(1.0), pleasing=True)
    assert share(persona, [polite, DONE], polite) == 0.0


def test_faults_are_sanctioned_as_readily_however_often_they_come(share):
    fault = percept(bout(-1.0))
    persona = certain(sanction=0.5, habituation=1.0)
    assert share(persona, [fault] * 5, fault) == chance(0.5)


def test_a_politer_person_taps_less(share):
    fault = percept(bout(-1.0))
    strict, polite = (share(certain(sanction=s), [], fault) for s in (0.9, 0.3))
    assert strict == chance(0.9)
    assert polite == chance(0.3)


@pytest.mark.parametrize(("mood", "p"), [(-1.0, 0.6), (0.0, 0.4), (1.0, 0.2)])
def test_a_bad_mood_sanctions_more_and_a_good_one_less(share, mood, p):
    persona = certain(sanction=0.4, irritability=0.5)
    assert share(persona, [], percept(bout(-1.0), mood=mood)) == chance(p)


def test_moods_do_not_change_praise(share):
    persona = certain(praise=0.4, irritability=1.0)
    for mood in (-1.0, 1.0):
        assert share(persona, [], percept(bout(1.0), mood=mood)) == chance(0.4)


def test_sanction_outweighs_praise_by_default(share):
    fault, polite = percept(bout(-1.0)), percept(bout(1.0))
    persona = Persona(name="default", reaction=0.0)
    assert share(persona, [], fault) > 1.5 * share(persona, [], polite)


def test_what_was_judged_before_shifts_no_draws_of_later(wishes):
    """Mistakes fall at the same moments after a busy time and after a quiet one."""
    busy = percept(bout(-0.5), bout(0.5, robot=1), touched=True)
    faults = [percept(bout(-1.0), touched=True)] * 40
    person = certain(mistakes=0.5)
    after = [wishes(person, [each] * 10 + faults)[10:] for each in (busy, NOTHING)]
    assert after[0] == after[1]
    assert {TAP, CARESS} == set(after[0])


def test_in_the_household_too_a_politer_person_taps_less(household_of):
    """60 barks in ten minutes: all of them, half and a tenth, within 3 deviations."""
    taps = []
    for sanction in (1.0, 0.5, 0.1):
        step = ScriptStep(place="phone", duration=(900.0, 900.0))
        ann = PersonSpec(name="ann", persona=certain(sanction=sanction), script=(step,))
        env = household_v0.parallel_env(
            household_of(
                people=(ann,), robots=(RobotSpec(position=(1.7, 2.5)),), max_cycles=600
            )
        )
        env.reset(seed=1)
        taps.append(0)
        while env.agents:
            *_, infos = env.step({"robot_0": 0 if env.decision % 10 < 2 else 1})
            taps[-1] += infos["robot_0"]["taps"]
    assert taps[0] == 60
    assert 30 - 12 <= taps[1] <= 30 + 12
    assert 0 < taps[2] <= 6 + 7


def test_who_did_not_see_it_blames_the_loudest(household_of):
    """Two robots behind her back; the far one whispers, the near one barks."""
    step = ScriptStep(place="phone", duration=(900.0, 900.0))
    quiet = {"robot_interest": 0.0, "people_interest": 0.0, "reflex": 0.0}
    ann = PersonSpec(name="ann", persona=certain(**quiet), script=(step,))
    env = household_v0.parallel_env(
        household_of(
            behaviors=("bark", "say_hello", "sleep"),
            people=(ann,),
            robots=(RobotSpec(position=(2.5, 2.5)), RobotSpec(position=(2.5, 3.5))),
            norms={"calling": {"absorbed": {"say_hello": -1.0}}},
        )
    )
    env.reset(seed=1)
    felt = {agent: [] for agent in env.possible_agents}
    causes = []
    for step in range(12):
        # Only the greeting is a fault; the bark next to it is louder.
        env.step({"robot_0": 0 if step < 2 else 2, "robot_1": 1 if step < 2 else 2})
        for agent in env.possible_agents:
            felt[agent] += env.feedback(agent)
            causes += env.causes(agent)
    assert [len(touches) for touches in felt.values()] == [1, 0]
    assert [cause.robot for cause in causes] == ["robot_1"]
