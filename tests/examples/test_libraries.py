"""The examples with training libraries train, where the library is installed."""

import math

import pytest

from household import household_v0
from household.scenario.family import draw

NEEDS = {
    "ppo": ("torch", 16 * 128),
    "stable_baselines3_ppo": ("sb3_contrib", 16 * 128),
    "torchrl_ppo": ("torchrl", 16 * 128),
    "rllib_ppo": ("ray.rllib", 4096),
}
"""Example -> what it imports, and the fewest steps after which it has a curve."""


@pytest.fixture(params=NEEDS)
def trained(request, run_functions):
    """What came of a short run of each example: policy and learning curve."""
    package, steps = NEEDS[request.param]
    pytest.importorskip(package, reason=f"{package} is not installed")
    return run_functions(request.param)["train"](steps)


@pytest.fixture
def home():
    return household_v0.parallel_env(draw("quiet_work", 0), max_cycles=30)


def test_what_was_trained_lives_in_a_home_that_it_never_saw(trained, home):
    policy, curve = trained
    assert curve
    assert all(hours > 0.0 and math.isfinite(reward) for hours, reward in curve)
    observations, _ = home.reset(seed=0)
    while home.agents:
        action = policy(observations["robot_0"], "robot_0")
        assert action in range(len(home.behaviors))
        observations, *_ = home.step({"robot_0": action})
