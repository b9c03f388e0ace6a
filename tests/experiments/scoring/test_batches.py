"""Episodes as plain arrays: what a robot saw, did and felt, step by step."""

import numpy as np
import pytest

from experiments.scoring.batches import lived
from experiments.scoring.policies import at_random
from household import household_v0


@pytest.fixture(scope="module")
def home():
    return household_v0.parallel_env("evening", max_cycles=80)


@pytest.fixture(scope="module")
def batches(home):
    return list(lived(home, at_random(np.random.default_rng(3)), seed=5))


def test_each_robot_has_an_episode_of_its_own(home, batches):
    assert [batch.agent for batch in batches] == home.possible_agents
    for batch in batches:
        length = home.observation_space(batch.agent).shape[0]
        assert batch.observations.shape == (81, length)
        assert batch.actions.shape == batch.rewards.shape == (80,)
        assert batch.truncations.tolist() == [False] * 79 + [True]
        assert batch.infos["action_mask"].shape == (81, len(home.behaviors))


def test_the_same_actions_give_the_same_episode(home, batches):
    observations, _ = home.reset(seed=5)
    for t in range(80):
        for batch in batches:
            np.testing.assert_array_equal(
                batch.observations[t], observations[batch.agent]
            )
        observations, rewards, *_ = home.step(
            {batch.agent: int(batch.actions[t]) for batch in batches}
        )
        assert rewards == {batch.agent: batch.rewards[t] for batch in batches}


def test_no_behavior_is_interrupted(batches):
    for batch in batches:
        masks = batch.infos["action_mask"][:-1]
        assert masks[np.arange(80), batch.actions].all()
        assert len(set(batch.actions.tolist())) > 2


def test_touches_are_in_the_infos(batches):
    felt = sum(b.infos["caresses"].sum() + b.infos["taps"].sum() for b in batches)
    assert felt > 0
