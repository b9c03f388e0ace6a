"""What robots do: bouts of behaviors that take their time, and where they go."""

import math

import numpy as np
import pytest

from household import household_v0
from household.scenario.behavior import Behavior, catalogue
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep

KNOWN = ("still", "spin", "wander", "follow", "retreat", "fetch")


@pytest.fixture
def alone_with(household_of):
    """One robot with these behaviors and somebody on the phone at (1, 2.5)."""

    def make(*behaviors, robot=(6.0, 2.5), **changes):
        step = ScriptStep(place="phone", duration=(900.0, 900.0))
        ann = PersonSpec(name="ann", persona="paper_actor", script=(step,))
        env = household_v0.parallel_env(
            household_of(
                behaviors=behaviors,
                people=(ann,),
                robots=(RobotSpec(position=robot),),
                norms={},
                **changes,
            )
        )
        env.reset(seed=1)
        return env

    return make


def path(env, actions):
    """Where the robot was after each of these actions."""
    return np.array(
        [
            (env.step(action), env.simulation.crowd.position[-1].copy())[1]
            for action in actions
        ]
    )


def test_the_paper_behaviors_and_what_else_a_household_knows_are_shipped():
    paper = {"bark", "play", "sleep", "say_hello"}
    further = {"follow", "vacuum", "fetch", "retreat", "ask"}
    assert paper | further <= set(catalogue())
    assert {behavior.motion for behavior in catalogue().values()} == set(KNOWN)


def test_behaviors_take_the_times_that_the_paper_suggests():
    times = {name: behavior.duration for name, behavior in catalogue().items()}
    assert times["bark"] == 2.0
    assert times["say_hello"] == 3.0
    assert times["play"] == times["sleep"] == 8.0


def test_a_behavior_that_is_chosen_again_goes_on_until_it_is_over(alone_with):
    """A bark takes two seconds: begun at 0, 2 and 4."""
    env = alone_with("bark", "sleep")
    began = []
    for _ in range(6):
        env.step({"robot_0": 0})
        began.append(env.behavior("robot_0").began)
    assert began == [0.0, 0.0, 2.0, 2.0, 4.0, 4.0]
    assert env.behavior_over("robot_0")


def test_another_behavior_interrupts_the_present_one(alone_with):
    env = alone_with("bark", "sleep")
    began = []
    for action in (1, 1, 0, 1):
        env.step({"robot_0": action})
        bout = env.behavior("robot_0")
        began.append((bout.behavior, bout.began, bout.ends))
    assert began == [(1, 0.0, 8.0), (1, 0.0, 8.0), (0, 2.0, 4.0), (1, 3.0, 11.0)]


def test_a_robot_without_an_action_goes_on_with_what_it_does(alone_with):
    env = alone_with("bark", "sleep")
    env.step({"robot_0": 1})
    bout = env.behavior("robot_0")
    for _ in range(7):
        assert not env.behavior_over("robot_0")
        env.step({})
        assert env.behavior("robot_0") == bout
    assert env.behavior_over("robot_0")


@pytest.mark.parametrize("behavior", ["bark", "sleep", "say_hello", "ask", "play"])
def test_most_behaviors_stay_where_they_are(alone_with, behavior):
    env = alone_with(behavior, "vacuum")
    places = path(env, [{"robot_0": 0}] * 10)
    np.testing.assert_allclose(places, [[6.0, 2.5]] * 10, atol=1e-6)


def test_a_dancing_robot_turns(alone_with):
    env = alone_with("play", "sleep")
    headings = []
    for _ in range(4):
        env.step({"robot_0": 0})
        headings.append(env.simulation.crowd.heading[-1])
    np.testing.assert_allclose(np.diff(headings) % (2 * math.pi), math.pi / 2)


def test_a_robot_walks_no_faster_than_its_half_meter_a_second(alone_with):
    env = alone_with("vacuum", "sleep")
    places = path(env, [{"robot_0": 0}] * 40)
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert steps.max() <= 0.5 + 1e-6
    assert steps.sum() > 5.0
    assert (places > 0.0).all()
    assert (places < (8.0, 5.0)).all()


def test_a_robot_that_follows_comes_to_the_nearest_person_and_stops(alone_with):
    """5 m away at 0.5 m/s: after 9 s it is near, and stays outside of the reach."""
    env = alone_with("follow", "sleep")
    path(env, [{"robot_0": 0}] * 12)
    gap = math.dist(env.simulation.crowd.position[0], env.simulation.crowd.position[1])
    assert 0.4 < gap <= 0.95
    assert not env.simulation.crowd.walks(1)


def test_a_robot_that_retreats_goes_where_nobody_is(alone_with):
    """From beside the phone to the rug."""
    env = alone_with("retreat", "sleep", robot=(2.0, 2.5))
    places = path(env, [{"robot_0": 0}] * 20)
    assert math.dist(places[-1], (7.0, 1.0)) < 0.3


def test_a_robot_that_fetches_goes_away_and_comes_back(alone_with):
    goes = {"goes": Behavior(description="Fetches", duration=60.0, motion="fetch")}
    env = alone_with("goes", "sleep", behavior=goes, robot=(2.2, 2.5), max_cycles=200)
    places = path(env, [{"robot_0": 0}] * 60)
    assert math.dist(places[-1], (1.0, 2.5)) < 1.0


def test_a_robot_that_is_told_to_sleep_stops_where_it_is(alone_with):
    env = alone_with("vacuum", "sleep")
    path(env, [{"robot_0": 0}] * 3)
    there = path(env, [{"robot_0": 1}] * 4)
    np.testing.assert_allclose(there, [there[0]] * 4, atol=0.02)


def test_a_robot_that_is_done_stops(alone_with):
    """One bout of two seconds; nothing else is chosen for a minute."""
    short = {"stroll": Behavior(description="Strolls", duration=2.0, motion="wander")}
    env = alone_with("stroll", "sleep", behavior=short, max_cycles=100)
    places = path(env, [{"robot_0": 0}, *[{}] * 30])
    assert math.dist(places[0], places[1]) > 0.1
    np.testing.assert_allclose(places[3:], [places[3]] * 28, atol=1e-6)


def test_users_define_their_own_behaviors(alone_with):
    own = {
        "whistle": Behavior(
            description="Whistles", duration=4.0, loudness=60.0, salience=2.0
        )
    }
    env = alone_with("whistle", "sleep", behavior=own, robot=(3.0, 2.5))
    env.step({"robot_0": 0})
    # 60 dB at 1 m are 53.98 at 2 m.
    assert env.simulation.senses.relations.level[0, 1] == pytest.approx(53.98, abs=0.01)
    assert env.behavior("robot_0").ends == 4.0


def test_a_robot_never_walks_through_a_wall(household_of, room):
    env = household_v0.parallel_env(
        household_of(
            home=room(walls=((4.0, 0.0, 4.0, 2.0), (4.0, 3.0, 4.0, 5.0))),
            behaviors=("vacuum", "follow", "retreat", "fetch"),
            robots=(RobotSpec(position=(2.5, 2.5)), RobotSpec(position=(6.0, 4.0))),
            norms={},
            max_cycles=300,
        )
    )
    env.reset(seed=1)
    rng = np.random.default_rng(1)
    before = env.simulation.crowd.position.copy()
    crossed = 0
    while env.agents:
        env.step({agent: int(rng.integers(4)) for agent in env.agents})
        after = env.simulation.crowd.position.copy()
        sides = (before[:, 0] < 4.0) != (after[:, 0] < 4.0)
        # Whoever changes sides does so through the gap from y = 2 to y = 3.
        assert (np.abs(after[sides, 1] - 2.5) < 0.6).all()
        crossed += int(sides.sum())
        before = after
    assert crossed > 0
