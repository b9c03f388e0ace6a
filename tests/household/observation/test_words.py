"""Observations in words say what the numbers say."""

import pytest

from household import household_v0
from household.observation.encodings import layout


@pytest.fixture
def moment(household_of):
    """Ann on the phone looks at a robot that plays, another one stands elsewhere."""

    def make(observation="features"):
        scenario = household_of(
            behaviors=("play", "sleep"),
            people=[
                {
                    "name": "ann",
                    "script": [
                        {"place": "phone", "duration": [900, 900], "look_at": "robot_0"}
                    ],
                }
            ],
            robots=[{"position": [4.0, 2.5]}, {"position": [7.0, 4.0]}],
            slots={"people": 3, "robots": 4},
            situation={"near": 5.0},
        )
        env = household_v0.parallel_env(scenario, observation)
        env.reset(seed=1)
        for _ in range(5):
            observations, *_ = env.step({"robot_0": 0})
        return env, observations

    return make


def test_features_are_told_field_by_field_and_padding_is_not(moment):
    env, observations = moment()
    me, ann, other = env.describe(observations["robot_0"]).splitlines()
    assert me == "the robot: play, 38% of it left"
    assert ann.startswith("ann: calling, 3.0 m away (x -3.0, y +0.0), attends to it")
    assert ann.endswith(", near it")
    assert other == "another robot: nothing yet, 3.4 m away (x +3.0, y +1.5)"


def test_touches_and_the_end_of_a_behavior_are_told(moment):
    env, observations = moment()
    row, place = observations["robot_1"].copy(), layout(env.scenario)
    assert env.describe(row).splitlines()[0] == "the robot: nothing yet"
    row[place["own_touches"]] = 0.25, 0.5
    row[place["own_behavior"]] = 0, 1
    row[place["person_walks"]] = 1
    row[place["person_offset"]][:2] = -1.0, 0.0
    me, ann, _ = env.describe(row).splitlines()
    assert me == "the robot: sleep, which is over, caressed (0.25), tapped (0.50)"
    assert ann.startswith(
        "ann: calling, walking, 10.0 m away or more (x -10.0, y +0.0)"
    )


def test_observed_situations_are_told_as_well(moment):
    env, observations = moment("situation")
    assert env.describe(observations["robot_0"]) == (
        "ann: calling, attends to it, near it"
    )


def test_every_observation_can_be_told(shipped_scenario):
    for encoding in ("features", "situation"):
        env = household_v0.parallel_env(shipped_scenario, encoding)
        observations, _ = env.reset(seed=1)
        for agent in env.agents:
            told = env.describe(observations[agent]).splitlines()
            assert [
                line.partition(":")[0]
                for line in told
                if line.partition(":")[0] in env.scenario.person_names
            ] == list(env.scenario.person_names)
