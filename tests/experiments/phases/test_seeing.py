"""Situations with the features of each person beside them."""

import numpy as np

from experiments.phases.seeing import SeeingHome, Slotted
from experiments.phases.world import Residence, World, household

RESIDENCE = Residence(world=World(people=3), home=3, people=(4, 7, 9))


def test_what_is_seen_names_everybody_and_equals_its_situation():
    env = household(RESIDENCE, 50)
    home = SeeingHome(env)
    home.reset(seed=1)
    first = home.situation("robot_0")
    assert first.situation == env.situation("robot_0")
    assert set(first.slots) == set(env.scenario.person_names)
    assert len({slot.shape for slot in first.slots.values()}) == 1
    again = Slotted(env).seen(
        first.situation, np.ones(env.observation_space("robot_0").shape)
    )
    assert again == first
    assert hash(again) == hash(first)


def test_features_follow_what_happens():
    home = SeeingHome(household(RESIDENCE, 50))
    home.reset(seed=1)
    before = home.situation("robot_0").slots
    for _ in range(20):
        home.step({"robot_0": 0})
    after = home.situation("robot_0").slots
    assert any(not np.array_equal(before[name], after[name]) for name in before)
    assert home.time > 0.0
