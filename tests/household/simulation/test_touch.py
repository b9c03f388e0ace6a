"""Touches: how long the way to the robot takes, and what the robot learns of it."""

import math

import msgspec
import pytest

from household import household_v0
from household.feedback import Cause
from household.observation.encodings import layout
from household.scenario.behavior import Behavior
from household.scenario.persona import Persona
from household.scenario.scenario import (
    PerceptionModel,
    PersonSpec,
    RobotSpec,
    ScriptStep,
)

BARK, SLEEP = 0, 1
ON_THE_PHONE = (ScriptStep(place="phone", duration=(900.0, 900.0)),)
NORMS = {"calling": {"attending": {"bark": -1.0}, "absorbed": {"bark": -1.0}}}
REACH = 0.8
STEERING = 0.2
EXACT = PerceptionModel(notice_delay=0.0, notice_noise=0.0)


def person(name="ann", start=None, script=ON_THE_PHONE, **traits):
    """Someone who sanctions every fault for certain, at once, and looks at nothing
    else."""
    usual = {
        "reaction": 0.0,
        "sanction": 1.0,
        "praise": 1.0,
        "robot_interest": 0.0,
        "people_interest": 0.0,
        "reflex": 0.0,
    }
    persona = Persona(name="strict_actor", **(usual | traits))
    return PersonSpec(name=name, persona=persona, start=start, script=script)


@pytest.fixture
def barked_at(household_of):
    """A bark, at the very beginning or later; gives the environment and all touches.

    The robot notices at once and exactly when somebody comes.
    """

    def play(steps=20, robot=(6.0, 2.5), people=None, at=0, **changes):
        usual = {
            "people": people or (person(),),
            "robots": (RobotSpec(position=robot),),
            "norms": NORMS,
            "perception": EXACT,
        }
        scenario = household_of(**(usual | changes))
        env = household_v0.parallel_env(scenario)
        env.reset(seed=1)
        felt = []
        for step in range(steps):
            _, rewards, _, _, infos = env.step(
                {"robot_0": BARK if step == at else SLEEP}
            )
            touches = env.feedback("robot_0")
            assert rewards["robot_0"] == sum(touch.value for touch in touches)
            assert infos["robot_0"]["taps"] + infos["robot_0"]["caresses"] == len(
                touches
            )
            for touch in touches:
                assert step < touch.time <= step + 1
                gap = math.dist(
                    env.simulation.crowd.position[0], env.simulation.crowd.position[-1]
                )
                assert len(scenario.people) > 1 or gap <= REACH + 1e-6
            felt += touches
        return env, felt

    return play


@pytest.mark.parametrize("x", [2.5, 4.0, 6.0, 7.5])
@pytest.mark.parametrize("speed", [1.2, 0.7])
def test_the_way_from_the_phone_to_the_robot_is_the_delay_of_the_tap(
    barked_at, x, speed
):
    """She is at x = 1, sets out after the first second, and reaches out 0.8 m."""
    _, felt = barked_at(robot=(x, 2.5), people=(person(walking_speed=speed),))
    (tap,) = felt
    walked = (x - 1.0 - REACH) / speed
    assert 1.0 + walked <= tap.time + 1e-6
    assert tap.time <= 1.0 + walked + 1.5 * STEERING
    assert tap.kind == "tap"
    assert tap.giver == "ann"
    assert tap.approach_began == 1.0


def test_the_time_to_react_comes_before_the_way(barked_at):
    """Two seconds more, in which she stays where she is; the cause is what it was."""
    slow = person(reaction=2.0, haste=0.0, reaction_spread=0.0)
    _, (soon,) = barked_at()
    env, (late,) = barked_at(people=(slow,))
    assert late.time == pytest.approx(soon.time + 2.0)
    assert late.approach_began == soon.approach_began + 2.0
    env, felt = barked_at(steps=3, people=(slow,))
    assert felt == []
    assert math.dist(env.simulation.crowd.position[0], (1.0, 2.5)) < 1e-6


def test_who_is_within_reach_touches_without_a_walk(barked_at):
    _, (tap,) = barked_at(robot=(1.7, 2.5))
    assert tap.time == pytest.approx(1.0 + STEERING)
    assert tap.approach_began is None


def test_a_bark_is_tapped_once_and_not_again_in_silence(barked_at):
    _, felt = barked_at(steps=60)
    assert [touch.kind for touch in felt] == ["tap"]


def test_attention_began_when_she_turned_to_the_robot(barked_at):
    """At 2 s she is 3.8 m away: 0.6 / 2.604 of 0.3 more is 0.434, above 0.4."""
    _, (tap,) = barked_at()
    assert tap.attention_began == 2.0
    assert tap.attending


def test_who_does_not_attend_tells_no_time_of_attention(barked_at):
    """Within reach she touches at once, before her head has turned."""
    _, (tap,) = barked_at(robot=(1.7, 2.5))
    assert not tap.attending
    assert tap.attention_began is None


def test_a_robot_behind_a_wall_is_not_touched_through_it(barked_at, room):
    """0.76 m as the crow flies; round the wall it is more than 2 m."""
    thin = msgspec.structs.replace(
        room(walls=((1.38, 1.0, 1.38, 4.0),)), wall_thickness=0.02
    )
    env, (tap,) = barked_at(robot=(1.76, 2.5), home=thin)
    assert tap.time > 1.0 + 2.0 / 1.2
    # Round the end of the wall she first goes away from it.
    assert tap.approach_began == 3.0
    assert env.feedback("robot_0") == ()


def test_patience_bounds_the_way(barked_at):
    """4.2 m take 3.5 s; after 2 s she turns back to the phone."""
    env, felt = barked_at(people=(person(patience=2.0),))
    assert felt == []
    assert math.dist(env.simulation.crowd.position[0], (1.0, 2.5)) < 0.3


def test_after_the_tap_she_goes_back_to_the_phone(barked_at):
    env, felt = barked_at()
    assert len(felt) == 1
    assert math.dist(env.simulation.crowd.position[0], (1.0, 2.5)) < 0.3
    assert env.situation("robot_0").plays == (("ann", "calling"),)


def test_on_her_way_she_plays_no_role(barked_at):
    env, felt = barked_at(steps=3)
    assert felt == []
    assert env.situation("robot_0").plays == (("ann", "unknown"),)


def test_the_true_cause_is_the_bark_and_stays_out_of_the_touch(household_of):
    scenario = household_of(people=(person(),), norms=NORMS)
    env = household_v0.parallel_env(scenario)
    env.reset(seed=1)
    # She is touched off by the third decision, judges it at its end, and comes when the
    # robot sleeps.
    for step in range(12):
        env.step({"robot_0": BARK if step == 2 else SLEEP})
        if env.feedback("robot_0"):
            break
    assert env.causes("robot_0") == (Cause("robot_0", 2, BARK, 3.0),)
    assert not hasattr(env.feedback("robot_0")[0], "cause")


def test_a_touch_is_as_strong_as_what_was_heard(household_of):
    """69 dB at 1 m are 55 dB at 5 m, halfway between noticed and full."""
    whine = Behavior(description="Whines", duration=2.0, loudness=68.9794)
    env = household_v0.parallel_env(
        household_of(
            behaviors=("whine", "sleep"),
            behavior={"whine": whine},
            max_cycles=200,
            people=(person(),),
            norms={"calling": {"absorbed": {"whine": -0.8}}},
        )
    )
    env.reset(seed=1)
    strengths = []
    for step in range(200):
        env.step({"robot_0": SLEEP if step % 20 else 0})
        strengths += [touch.strength for touch in env.feedback("robot_0")]
    # Half as loud as full, 0.8 as bad as can be: 0.4; that is also how often.
    assert 1 <= len(strengths) < 10
    assert strengths == pytest.approx([0.4] * len(strengths), abs=1e-4)


def test_two_who_mind_both_tap_and_the_reward_is_the_sum(household_of):
    """Both stand within reach, so that both touch in the second step."""
    bob = person("bob", start=(2.0, 2.9))
    env = household_v0.parallel_env(
        household_of(
            people=(person(), bob),
            robots=(RobotSpec(position=(1.4, 3.0)),),
            norms=NORMS | {"unknown": NORMS["calling"]},
        )
    )
    env.reset(seed=1)
    rewards = []
    for step in range(3):
        observations, reward, *_ = env.step({"robot_0": SLEEP if step else BARK})
        rewards.append(reward["robot_0"])
    assert rewards == [0.0, -2.0, 0.0]
    assert env.observation_space("robot_0").contains(observations["robot_0"])


@pytest.mark.parametrize(
    ("robot", "seen"),
    [
        # All the way to the rug she gets nearer: nobody can see that she now means it.
        ((6.0, 4.5), 3.0),
        # From this one she goes away, until she turns round.
        ((0.6, 4.5), 6.0),
    ],
)
def test_who_is_on_the_way_elsewhere_is_seen_coming_since_it_visibly_gets_nearer(
    household_of, robot, seen
):
    """She walks from the phone to the rug when the robot barks, and turns to it."""
    walk = (
        ScriptStep(place="phone", duration=(3.0, 3.0)),
        ScriptStep(place="rug", duration=(900.0, 900.0)),
    )
    unknown = {"unknown": {"absorbed": {"bark": -1.0}, "attending": {"bark": -1.0}}}
    env = household_v0.parallel_env(
        household_of(
            people=(person(script=walk),),
            robots=(RobotSpec(position=robot),),
            norms=unknown,
            perception=EXACT,
        )
    )
    env.reset(seed=1)
    for step in range(20):
        env.step({"robot_0": BARK if step == 5 else SLEEP})
        if env.feedback("robot_0"):
            break
    (tap,), (cause,) = env.feedback("robot_0"), env.causes("robot_0")
    assert cause.decision == 5
    # The bark was judged at 6 s; she has been walking since about 3 s.
    assert cause.time == 6.0
    assert tap.approach_began == seen


def test_what_a_robot_sees_of_her_coming_tells_nothing_of_when_she_judged_it(
    barked_at,
):
    """One makes up her mind at 1 s and takes two seconds to set out; the other judges a
    later bark and sets out at once. They walk alike, and are seen to."""
    slow = person(reaction=2.0, haste=0.0, reaction_spread=0.0)
    _, (one,) = barked_at(people=(slow,), perception=PerceptionModel())
    _, (other,) = barked_at(at=2, perception=PerceptionModel())
    assert one.time == other.time
    assert one.approach_began == other.approach_began
    assert one.approach_began not in (1.0, 3.0)


def test_an_approach_to_a_robot_that_moves_away_began_where_it_began(household_of):
    flee = Behavior(description="Strolls off", duration=20.0, motion="wander")
    env = household_v0.parallel_env(
        household_of(
            behaviors=("bark", "stroll"),
            behavior={"stroll": flee},
            people=(person(),),
            norms=NORMS,
            perception=EXACT,
        )
    )
    env.reset(seed=2)
    taps = []
    for step in range(25):
        env.step({"robot_0": 1 if step else BARK})
        taps += env.feedback("robot_0")
    assert [tap.approach_began for tap in taps] == [1.0]


def test_mistakes_turn_a_tap_into_a_caress(barked_at):
    _, (touch,) = barked_at(people=(person(mistakes=1.0),))
    assert touch.kind == "caress"
    assert touch.value == 1.0


def test_what_was_felt_is_observed_and_gone_a_step_later(household_of):
    env = household_v0.parallel_env(
        household_of(
            people=(person(),), robots=(RobotSpec(position=(1.7, 2.5)),), norms=NORMS
        )
    )
    env.reset(seed=1)
    place = layout(env.scenario)["own_touches"]
    seen = []
    for step in range(4):
        observations, *_ = env.step({"robot_0": SLEEP if step else BARK})
        seen.append(observations["robot_0"][place].tolist())
    assert seen == [[0.0, 0.0], [0.0, 1.0], [0.0, 0.0], [0.0, 0.0]]
