"""Preparing: work of later moments that is done early changes nothing."""

import copy

import numpy as np
import pytest

from household import household_v0


def history(rng, prepare):
    """What happens in an evening; a third of the way in, a copy goes on with it."""
    env = household_v0.parallel_env("evening", max_cycles=240)
    env.reset(seed=3)
    spaces, moments = env.action_spaces, []
    actions = np.random.default_rng(0).integers(
        [space.n for space in spaces.values()], size=(240, len(spaces))
    )
    for decision, row in enumerate(actions.tolist()):
        if prepare:
            for _ in range(rng.integers(4)):
                env.simulation.prepare()
        if decision == 80:
            env = copy.deepcopy(env)
        env.step(dict(zip(spaces, row, strict=True)))
        record, moods = env.simulation.record, env.simulation.moods
        fields = {name: record[name].copy() for name in record.dtype.names}
        moments.append(fields | {"moods": moods.copy()})
    return moments


@pytest.mark.parametrize("seed", range(3))
def test_who_prepares_now_and_then_lives_through_the_same_evening(seed):
    rng = np.random.default_rng(seed)
    usual, prepared = history(rng, prepare=False), history(rng, prepare=True)
    for decision, (one, other) in enumerate(zip(usual, prepared, strict=True)):
        for name, value in one.items():
            np.testing.assert_array_equal(other[name], value, f"{decision}: {name}")


def test_there_is_nothing_to_prepare_before_the_first_episode_or_for_ever():
    env = household_v0.parallel_env("evening")
    assert not env.simulation.prepare()
    env.reset(seed=0)
    for _ in range(20):
        env.step(dict.fromkeys(env.agents, 0))
    times = 0
    while env.simulation.prepare():
        times += 1
        assert times < 100
    assert times > 0
