"""What people think of what robots do: numbers by hand."""

import math

import msgspec
import numpy as np
import pytest

from household import household_v0
from household.activity import Activity
from household.config.toml import shipped
from household.people.appraisal import (
    can_judge,
    heard_strength,
    seen_strength,
)
from household.people.feelings import moved_mood, opinion
from household.people.person import everyone_of
from household.people.traits import traits_of
from household.scenario.behavior import Behavior
from household.scenario.norms import Norm, household_norms, norm_table
from household.scenario.persona import Persona, load_persona
from household.scenario.population import Population, individual, preferences
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep
from household.scenario.validation import load_scenario

PERSONAS = tuple(shipped("persona"))
BEHAVIORS = ("bark", "play", "sleep", "say_hello")
BARK, SLEEP = 0, 1


def mild(**traits):
    """Someone who never touches, and looks only at its own activity."""
    silent = {"praise": 0.0, "sanction": 0.0, "reflex": 0.0}
    blind = {"robot_interest": 0.0, "people_interest": 0.0}
    return Persona(name="mild", **silent, **blind, **traits)


def on_the_phone(persona, **changes):
    step = ScriptStep(place="phone", duration=(900.0, 900.0), **changes)
    return (PersonSpec(name="ann", persona=persona, script=(step,)),)


@pytest.mark.parametrize(
    ("level", "strength"),
    [(0.0, 0.0), (40.0, 0.0), (55.0, 0.5), (70.0, 1.0), (120.0, 1.0)],
)
def test_sounds_count_from_a_quiet_room_to_a_loud_voice(level, strength):
    assert heard_strength(np.array(level)) == pytest.approx(strength)


@pytest.mark.parametrize(
    ("share", "strength"), [(0.0, 0.0), (0.25, 0.5), (0.5, 1.0), (0.9, 1.0)]
)
def test_sights_count_fully_from_half_the_attention(share, strength):
    assert seen_strength(np.array(share)) == pytest.approx(strength)


@pytest.mark.parametrize(
    ("mood", "appraisal", "after"),
    [
        (0.0, 1.0, 0.2),
        (0.0, -1.0, -0.2),
        (0.2, 1.0, 0.36),
        (0.5, -0.5, 0.35),
        (0.5, 0.0, 0.5),
        (1.0, 1.0, 1.0),
        (-1.0, -1.0, -1.0),
    ],
)
def test_a_mood_moves_a_fifth_of_the_way_for_a_full_appraisal(mood, appraisal, after):
    assert moved_mood(mood, appraisal, 0.2) == pytest.approx(after)


@pytest.mark.parametrize(
    ("pleased", "annoyed", "answer"),
    [(0, 0, 6), (100, 0, 10), (0, 100, 1), (8, 0, 9), (0, 8, 2), (50, 50, 6)],
)
def test_an_opinion_is_the_pleased_share_from_one_to_ten(pleased, annoyed, answer):
    """1 + round(9 share): without experience the share is 1/2, 5.5 rounds up."""
    assert opinion(pleased, annoyed) == answer


def test_opinions_rise_with_pleasure_and_fall_with_annoyance():
    rising = [opinion(pleased, 5.0) for pleased in range(50)]
    falling = [opinion(5.0, annoyed) for annoyed in range(50)]
    assert rising == sorted(rising)
    assert falling == sorted(falling, reverse=True)
    assert {*rising, *falling} <= set(range(1, 11))


def test_an_appraisal_is_preference_times_strength(household_of):
    """A bark of 85 dB at 5 m: 71 dB, full strength; calling, absorbed: -1."""
    env = household_v0.parallel_env(household_of(people=on_the_phone(mild())))
    env.reset(seed=1)
    feelings = env.simulation.people.feelings
    env.step({"robot_0": BARK})
    assert feelings.annoyed[0].tolist() == [1.0]
    assert feelings.pleased[0].tolist() == [0.0]
    # The mood fades for a second before anybody can read it.
    assert feelings.mood[0] == pytest.approx(-0.2 * math.exp(-1.0 / 300.0))


def test_a_bout_is_appraised_once_however_long_it_lasts(household_of):
    env = household_v0.parallel_env(household_of(people=on_the_phone(mild())))
    env.reset(seed=1)
    feelings = env.simulation.people.feelings
    annoyed = []
    for _ in range(6):
        env.step({"robot_0": BARK})
        annoyed.append(feelings.annoyed[0, 0])
    # A bark takes two seconds; then it is another bark.
    assert annoyed == [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]


def judged_at(scenario, actions, seed=1):
    """Each time at which somebody judged a bout: when, who and what it thought."""
    env = household_v0.parallel_env(scenario)
    env.reset(seed=seed)
    found = env.simulation.people.appraisals
    judged = []
    for action in actions:
        env.step({"robot_0": action})
        judged += [
            (env.time, int(i), round(float(found.value[i, 0]), 3))
            for i in found.new[:, 0].nonzero()[0]
        ]
    return env, judged


def glancing(persona, look_for, look_away):
    """Somebody on the phone who looks at the robot for a while, then away, ..."""
    times = {"look_for": (look_for, look_for), "look_away": (look_away, look_away)}
    return on_the_phone(persona, look_at="robot_0", **times)


NEAR = (RobotSpec(position=(2.0, 2.5)),)
WHINE = {"whine": Behavior(description="Whines", duration=12.0, loudness=70.0)}


def whining_at(household_of, persona, **changes):
    """She looks at the robot for 3 s, then away for 6 s, over and over."""
    usual = {
        "behaviors": ("whine", "sleep"),
        "behavior": WHINE,
        "robots": NEAR,
        "people": glancing(persona, 3.0, 6.0),
        "norms": {
            "calling": {"attending": {"whine": -1.0}, "absorbed": {"whine": -0.5}}
        },
    }
    return household_of(**(usual | changes))


def test_a_bout_that_began_unseen_is_judged_when_its_watcher_comes_to_look(
    household_of,
):
    """The whine begins at 4 s, as she looks away, and she looks again from 9 s on."""
    home = whining_at(household_of, mild(only_when_attending=True))
    env, judged = judged_at(home, [SLEEP] * 4 + [0] * 12)
    assert [(who, value) for _, who, value in judged] == [(0, -1.0)]
    ((when, _, _),) = judged
    assert 9.0 <= when <= 11.0
    assert env.simulation.people.feelings.annoyed[0, 0] == 1.0


def test_who_need_not_watch_judges_it_by_ear_at_once_and_only_then(household_of):
    home = whining_at(household_of, mild())
    _, judged = judged_at(home, [SLEEP] * 4 + [0] * 12)
    assert judged == [(5.0, 0, -0.5)]


def test_a_bout_that_is_over_when_its_watcher_comes_to_look_is_never_judged(
    household_of,
):
    """A short one: 4 s to 6 s, while she looks away; then the robot sleeps."""
    home = whining_at(
        household_of,
        mild(only_when_attending=True),
        behavior={"whine": Behavior(description="Whines", duration=2.0, loudness=70.0)},
    )
    _, judged = judged_at(home, [SLEEP] * 4 + [0] * 2 + [SLEEP] * 10)
    assert judged == []


def test_a_bout_heard_too_faintly_to_mind_is_judged_when_it_is_perceived_better(
    household_of,
):
    """41.5 dB at her ear are .05 of full strength: less than she minds. Looking at the
    robot, she sees it with .35 of her attention, which counts .69."""
    murmur = Behavior(description="Murmurs", duration=12.0, loudness=55.48)
    home = whining_at(
        household_of,
        mild(tolerance=0.1),
        behavior={"whine": murmur},
        robots=(RobotSpec(position=(6.0, 2.5)),),
        norms={"calling": {"attending": {"whine": -1.0}, "absorbed": {"whine": -1.0}}},
    )
    _, judged = judged_at(home, [SLEEP] * 4 + [0] * 12)
    ((when, _, value),) = judged
    assert 9.0 <= when <= 11.0
    assert value < -0.5


@pytest.mark.parametrize(
    ("value", "attending", "traits", "judged"),
    [
        (-0.99, True, {"tolerance": 1.0}, False),
        (-1.0, True, {"tolerance": 1.0}, True),
        (0.2, False, {"tolerance": 0.1}, True),
        (0.0, True, {"tolerance": 0.0}, False),
        (-1.0, False, {"only_when_attending": True}, False),
        (-1.0, True, {"only_when_attending": True}, True),
    ],
)
def test_what_is_judged_is_strong_enough_and_watched_where_that_matters(
    value, attending, traits, judged
):
    (row,) = traits_of([mild(**traits)])
    assert can_judge(value, attending, row) == judged


def test_what_is_neither_seen_nor_heard_is_not_appraised(household_of):
    """She turns her back to a robot that sleeps, which she would like."""
    env = household_v0.parallel_env(household_of(people=on_the_phone(mild())))
    env.reset(seed=1)
    feelings = env.simulation.people.feelings
    for _ in range(10):
        env.step({"robot_0": SLEEP})
    assert feelings.pleased[0].tolist() == [0.0]
    assert feelings.mood[0] == 0.0


def test_what_is_seen_faintly_counts_by_the_share_of_the_attention(household_of):
    """A sleeping robot 5 m away: 0.6 / (1 + 25 / 9) = 0.1588; of 0.4588 in all,
    0.3462, below attending; twice that, 0.6923, times 0.4 is 0.2769."""
    people = on_the_phone(mild(), look_at="robot_0")
    env = household_v0.parallel_env(household_of(people=people))
    env.reset(seed=1)
    feelings = env.simulation.people.feelings
    env.step({"robot_0": SLEEP})
    share = 0.6 / (1 + 25 / 9) / (0.3 + 0.6 / (1 + 25 / 9))
    assert share == pytest.approx(0.3462, abs=1e-4)
    attending = bool(env.simulation.senses.relations.attends[0, 1])
    table = norm_table(household_norms(), ("bark", "sleep"))
    liked = table[Activity.CALLING, int(attending), SLEEP]
    assert feelings.pleased[0, 0] == pytest.approx(2 * share * liked, abs=1e-3)


def test_appropriateness_is_what_people_prefer_times_how_they_would_perceive_it(
    household_of,
):
    """One hears a bark at full strength, of sleep she sees nothing."""
    env = household_v0.parallel_env(household_of(people=on_the_phone(mild())))
    env.reset(seed=1)
    env.step({"robot_0": SLEEP})
    np.testing.assert_allclose(env.appropriateness("robot_0"), [-1.0, 0.0])


def test_appropriateness_is_the_mean_over_all_people(household_of):
    """Both hear the bark fully; Ann minds it and Bob rather likes it: -1 and 0.5."""
    ann = on_the_phone(mild())[0]
    bob = PersonSpec(
        name="bob",
        persona=mild(),
        script=(ScriptStep(place="rug", duration=(900.0, 900.0)),),
    )
    norms = {
        "calling": {"absorbed": {"bark": -1.0}},
        "playing": {"absorbed": {"bark": 0.5}},
    }
    env = household_v0.parallel_env(
        household_of(
            people=(ann, bob), robots=(RobotSpec(position=(6.0, 2.5)),), norms=norms
        )
    )
    env.reset(seed=1)
    env.step({"robot_0": SLEEP})
    assert env.appropriateness("robot_0")[BARK] == pytest.approx(-0.25)


def test_a_mood_fades_with_its_time_constant(household_of):
    persona = mild(mood_recovery=10.0)
    env = household_v0.parallel_env(household_of(people=on_the_phone(persona)))
    env.reset(seed=1)
    env.step({"robot_0": BARK})
    after = env.simulation.people.feelings.mood[0]
    for _ in range(10):
        env.step({"robot_0": SLEEP})
    assert env.simulation.people.feelings.mood[0] == pytest.approx(after / math.e)


def test_robots_misread_moods_around_the_truth(household_of):
    env = household_v0.parallel_env(
        household_of(people=on_the_phone(mild()), max_cycles=2000)
    )
    env.reset(seed=1)
    read = []
    while env.agents:
        env.step({"robot_0": SLEEP})
        read.append(env.simulation.moods[0, 0])
    # The mood is 0: mean and deviation of 2000 draws with a deviation of 0.2.
    assert abs(np.mean(read)) < 4 * 0.2 / math.sqrt(2000)
    assert np.std(read) == pytest.approx(0.2, rel=0.1)


def test_household_norms_value_every_shipped_paper_behavior_within_bounds():
    table = norm_table(household_norms(), BEHAVIORS)
    assert table.shape == (len(Activity), 2, 4)
    assert (np.abs(table) <= 1.0).all()
    assert (table[Activity.CALLING, :, 0] == -1.0).all()
    assert (table[:, :, 0] < 0.0).all()


def test_without_heterogeneity_everybody_shares_the_norms():
    norms = norm_table(household_norms(), BEHAVIORS)
    for index, name in enumerate(PERSONAS):
        persona = load_persona(name)
        liked = preferences(norms, persona, BEHAVIORS, Population(), 0.0, index)
        np.testing.assert_array_equal(liked, norms)
        assert individual(persona, Population(), 0.0, index) == persona


def test_heterogeneity_scales_how_far_people_depart_from_the_norms():
    norms = norm_table(household_norms(), BEHAVIORS)
    persona = Persona(name="plain")
    full, half = (
        preferences(norms, persona, BEHAVIORS, Population(), h, 0) for h in (1.0, 0.5)
    )
    np.testing.assert_allclose(half, (norms + full) / 2)
    assert np.abs(full - norms).max() > 0.5


def test_at_full_heterogeneity_people_differ_and_their_own_taste_holds():
    norms = norm_table(household_norms(), BEHAVIORS)
    fond = Persona(name="fond", preferences={"calling": Norm(absorbed={"bark": 0.9})})
    one, other = (
        preferences(norms, fond, BEHAVIORS, Population(), 1.0, i) for i in (0, 1)
    )
    assert one[Activity.CALLING, 0, 0] == other[Activity.CALLING, 0, 0] == 0.9
    assert not np.array_equal(one, other)


def test_adding_people_to_a_population_leaves_the_others_as_they_were():
    norms = norm_table(household_norms(), BEHAVIORS)
    population = Population(seed=5, clusters=3, clusteredness=0.5)
    plain = Persona(name="plain")
    first = preferences(norms, plain, BEHAVIORS, population, 0.7, 0)
    preferences(norms, plain, BEHAVIORS, population, 0.7, 1)
    again = preferences(norms, plain, BEHAVIORS, population, 0.7, 0)
    np.testing.assert_array_equal(first, again)


def test_a_person_with_a_number_is_the_same_wherever_it_lives():
    def lives_with(*numbers):
        people = tuple(
            PersonSpec(name=f"p{number}", number=number) for number in numbers
        )
        scenario = msgspec.structs.replace(
            load_scenario("evening"), people=people, heterogeneity=0.7
        )
        return {each.name: each for each in everyone_of(scenario)}

    one, other = lives_with(17, 4), lives_with(3, 17)
    np.testing.assert_array_equal(one["p17"].preferences, other["p17"].preferences)
    assert one["p17"].persona == other["p17"].persona
    assert not np.array_equal(one["p17"].preferences, one["p4"].preferences)


def test_people_of_one_cluster_share_its_taste():
    norms = norm_table(household_norms(), BEHAVIORS)
    population = Population(seed=5, clusters=2, clusteredness=1.0)
    tastes = {
        preferences(
            norms, Persona(name="plain"), BEHAVIORS, population, 1.0, i
        ).tobytes()
        for i in range(20)
    }
    assert len(tastes) == 2


def test_at_least_eight_personas_are_shipped_and_each_says_what_it_is():
    assert len(PERSONAS) >= 8
    for name in PERSONAS:
        persona = load_persona(name)
        assert persona.name == name
        assert len(persona.description) > 20


def test_every_shipped_persona_sanctions_more_readily_than_it_praises_or_says_why():
    """Paper, 3.1: people tend to sanction faults and rarely reward; but some do not."""
    readier = {
        name
        for name in PERSONAS
        if load_persona(name).praise > load_persona(name).sanction
    }
    assert readier <= {"warm", "child", "praising"}
