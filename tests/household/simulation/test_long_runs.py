"""A million decisions: no memory is lost, nobody gets lost, nobody stands for nothing.

The figures are printed: run with `pytest -m slow -s`.
"""

import gc
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from household import household_v0
from household.home.sources.generator import generate
from household.home.standing import standing_room
from household.simulation.simulation import PERSON_RADIUS as PERSON
from household.simulation.simulation import ROBOT_RADIUS as ROBOT

OVERLAP = 0.01
"""Nobody overlaps a wall by more than this [m]."""

LOOK_EVERY = 10
"""Decisions between looks: they cost more than a decision."""

GROWTH = 5.0
"""[MB]"""

PATIENCE = 60.0
"""How long somebody may walk on the spot with nobody near [s]."""

NEAR = 0.7
"""Where another body is a reason to wait: 0.2 m of room between two people [m]."""

WARM = 0.1
"""Share of the decisions after which whatever is kept has been met."""


@dataclass
class Walkers:
    """Who walks on the spot, since when, and whether anybody was in the way."""

    env: object
    n: int

    def __post_init__(self):
        self.since, self.there = np.zeros(self.n), np.zeros((self.n, 2))
        self.longest = 0.0

    def look(self):
        crowd, now = self.env.simulation.crowd, self.env.time
        position = crowd.position
        apart = np.linalg.norm(position[: self.n, None] - position, axis=2)
        apart[np.arange(self.n), np.arange(self.n)] = np.inf
        hindered = (apart < NEAR).any(axis=1)
        moved = np.linalg.norm(position[: self.n] - self.there, axis=1) > 0.5
        anew = moved | hindered | ~crowd.walking[: self.n]
        self.since[anew] = now
        self.there[anew] = position[: self.n][anew]
        self.longest = max(self.longest, float((now - self.since).max()))


def memory():
    """What this process holds [MB]."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096 / 1e6


def live(env, decisions, deepest):
    """Lives so long with random choices; returns growth and longest standstill."""
    plan, n = env.scenario.plan, len(env.scenario.people)
    radius = np.array([PERSON] * n + [ROBOT] * len(env.possible_agents))
    rng, behaviors = np.random.default_rng(3), len(env.behaviors)
    walkers, warm, before = Walkers(env, n), round(decisions * WARM), 0.0
    env.reset(seed=0)
    for decision in range(decisions):
        chosen = rng.integers(behaviors, size=len(env.agents)).tolist()
        seen, rewards, *_ = env.step(dict(zip(env.agents, chosen, strict=True)))
        if decision % LOOK_EVERY == 0:
            position = env.simulation.crowd.position
            assert (position > plan.lower).all()
            assert (position < plan.upper).all()
            assert deepest(plan, position, radius) <= OVERLAP, decision
            assert all(np.isfinite(each).all() for each in seen.values())
            assert np.isfinite(list(rewards.values())).all()
            walkers.look()
        if decision == warm:
            before = memory()
    return memory() - before, walkers.longest


def crowded_home():
    """A generated home of 16 rooms for 64 people and 16 robots."""
    plan = generate(5, rooms=16, room_area=25.0, clutter=0.3)
    spots = standing_room(plan, 16, np.random.default_rng(0))
    return household_v0.parallel_env(
        "evening",
        home=plan,
        people=[{"name": f"p{i}"} for i in range(64)],
        robots=[{"position": spot} for spot in spots],
        max_cycles=10**9,
    )


def party():
    return household_v0.parallel_env("party", max_cycles=10**9)


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="Linux's own figures")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "decisions"), [(party, 1_000_000), (crowded_home, 1_000_000)]
)
def test_a_long_run_keeps_its_memory_and_everybody_on_the_move(
    make, decisions, deepest
):
    growth, longest = live(make(), decisions, deepest)
    print(f"\n{make.__name__}: {decisions} decisions, {growth:.1f} MB, {longest:.0f} s")
    assert growth < GROWTH
    assert longest <= PATIENCE


@pytest.mark.parametrize("make", [party, crowded_home])
def test_nobody_walks_on_the_spot_with_nobody_in_the_way(make, deepest):
    _, longest = live(make(), 150, deepest)
    assert longest <= PATIENCE
