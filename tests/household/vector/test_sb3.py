"""Many homes for Stable-Baselines3, where it is installed."""

import numpy as np
import pytest

from household import vector
from household.errors import HouseholdError

pytest.importorskip("stable_baselines3", reason="the extra `sb3` is not installed")


@pytest.fixture
def env():
    from household.vector.sb3 import HouseholdVecEnv

    homes = vector.make("evening", homes=2, seed=1, max_cycles=10)
    env = HouseholdVecEnv(homes)
    yield env
    env.close()


def test_every_robot_is_an_environment(env):
    assert env.num_envs == 4
    assert env.reset().shape == (4, *env.observation_space.shape)


def test_the_end_of_an_episode_is_told_as_its_algorithms_expect(env):
    env.reset()
    for step in range(10):
        observations, _, ends, infos = env.step(np.zeros(4, dtype=np.int64))
        assert ends.tolist() == [step == 9] * 4
    assert all(info["TimeLimit.truncated"] for info in infos)
    for info, now in zip(infos, observations, strict=True):
        assert (info["terminal_observation"] != now).any()


def test_masks_leave_only_the_present_behavior_until_it_is_over(env):
    env.reset()
    assert np.stack(env.env_method("action_masks")).all()
    env.step(np.array([0, 1, 2, 0]))
    masks = np.stack(env.env_method("action_masks"))
    assert masks.sum(axis=1).tolist() == [1, 1, 1, 1]
    assert env.has_attr("action_masks")


def test_the_same_seed_gives_the_same_homes(env):
    env.seed(3)
    first = env.reset()
    env.seed(3)
    np.testing.assert_array_equal(first, env.reset())
    assert (env.reset() != first).any()


def test_homes_cannot_be_changed_from_outside(env):
    with pytest.raises(HouseholdError, match="cannot be changed"):
        env.set_attr("behaviors", ())
    with pytest.raises(HouseholdError, match="action_masks"):
        env.env_method("explode")
