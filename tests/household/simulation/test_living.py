"""Whole households: nobody leaves, sinks into anything, or gets stuck."""

import numpy as np
import pytest

from household import household_v0
from household.simulation.simulation import PERSON_RADIUS as PERSON
from household.simulation.simulation import ROBOT_RADIUS as ROBOT

OVERLAP = 0.01  # Nobody overlaps a wall by more than this [m].


def test_nobody_begins_inside_anything_solid_or_anybody_else(shipped_scenario, deepest):
    env = household_v0.parallel_env(shipped_scenario)
    n, robots = len(env.simulation.people.everyone), len(env.possible_agents)
    radius = np.array([PERSON] * n + [ROBOT] * robots)
    for seed in range(5):
        env.reset(seed=seed)
        position = env.simulation.crowd.position
        assert deepest(env.scenario.plan, position, radius) <= OVERLAP
        gap = np.linalg.norm(position[:, None] - position, axis=2)
        touching = radius[:, None] + radius - OVERLAP
        np.fill_diagonal(gap, np.inf)
        assert (gap > touching).all()


def soak(scenario, decisions, deepest):
    """Nobody outdoors, in a wall, or walking on the spot for more than 30 s."""
    env = household_v0.parallel_env(scenario)
    plan = env.scenario.plan
    n, robots = len(env.simulation.people.everyone), len(env.possible_agents)
    radius = np.array([PERSON] * n + [ROBOT] * robots)
    rng = np.random.default_rng(3)
    since, there = np.zeros(n), np.zeros((n, 2))
    for decision in range(decisions):
        if not env.agents:
            env.reset(seed=0 if decision == 0 else None)
            since[:], there[:] = 0.0, env.simulation.crowd.position[:n]
        env.step({a: int(rng.integers(len(env.behaviors))) for a in env.agents})
        position = env.simulation.crowd.position
        assert (position > plan.lower).all()
        assert (position < plan.upper).all()
        assert deepest(plan, position, radius) <= OVERLAP
        walks = np.array([env.simulation.crowd.walks(i) for i in range(n)])
        moved = np.linalg.norm(position[:n] - there, axis=1) > 0.5
        restart = moved | ~walks
        since[restart] = env.time
        there[restart] = position[:n][restart]
        assert (env.time - since <= 30.0).all(), f"decision {decision}"


def test_nobody_leaves_sinks_or_gets_stuck(shipped_scenario, deepest):
    soak(shipped_scenario, 250, deepest)


@pytest.mark.slow
def test_nobody_of_twelve_leaves_sinks_or_gets_stuck_in_100_000_decisions(deepest):
    soak("party", 100_000, deepest)
