"""Fifty steps in a household: everything finite, everybody inside, nobody in a wall."""

import faulthandler
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields
from typing import Any

import numpy as np

from household import household_v0
from household.home.enclosure import is_outdoors, outdoors
from household.scenario.scenario import Scenario
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.simulation.snapshot import snapshot

STEPS = 50

OVERLAP = 0.01
"""By how much a body may reach into a wall or a piece of furniture [m]."""

HANG = 300.0
"""After so long something hangs, however busy the machine [s]."""


@contextmanager
def no_hanging() -> Iterator[None]:
    """Ends the process, and shows where it was, if what is inside never ends."""
    faulthandler.dump_traceback_later(HANG, exit=True, file=sys.__stderr__)
    try:
        yield
    finally:
        faulthandler.cancel_dump_traceback_later()


def live(scenario: Scenario, seed: int, deepest: Any) -> float:
    """Lives through fifty steps of a scenario.

    Args:
        scenario: That was accepted.
        seed: Of the episode and of the robots' choices.
        deepest: How far bodies overlap walls and furniture [m].

    Returns:
        The longest time that one of the steps took the processor [s].
    """
    kind = ("features", "situation")[seed % 2]
    env = household_v0.parallel_env(scenario, observation=kind)
    open_air = outdoors(scenario.plan, scenario.plan.wall_segments)
    rng, longest = np.random.default_rng(seed), 0.0
    observations, infos = env.reset(seed=seed)
    check_moment(env, open_air, deepest)
    for _ in range(STEPS):
        if not env.agents:
            observations, infos = env.reset()
        actions = {a: int(rng.integers(len(env.behaviors))) for a in env.agents}
        spent = time.process_time()
        observations, rewards, *_, infos = env.step(actions)
        longest = max(longest, time.process_time() - spent)
        assert np.isfinite(list(rewards.values())).all()
        check_moment(env, open_air, deepest)
    check_told(env, observations, infos)
    return longest


def check_moment(env: Any, open_air: Any, deepest: Any) -> None:
    """Everything is finite, every body on the floor of the home, attention shared."""
    plan, crowd = env.scenario.plan, env.simulation.crowd
    people = len(env.scenario.people)
    radius = np.full(len(crowd.position), ROBOT_RADIUS)
    radius[:people] = PERSON_RADIUS
    assert np.isfinite(env.state()).all()
    attention = env.simulation.senses.relations.attention
    assert (attention >= 0.0).all()
    assert (attention.sum(axis=1) <= 1.0).all()
    shown = snapshot(env.simulation)
    for field in fields(shown):
        values = np.asarray(getattr(shown, field.name))
        assert values.dtype.kind != "f" or not np.isnan(values).any(), field.name
    assert (crowd.position > plan.lower).all()
    assert (crowd.position < plan.upper).all()
    assert not any(is_outdoors(plan, open_air, spot) for spot in crowd.position)
    assert deepest(plan, crowd.position, radius) <= OVERLAP


def check_told(env: Any, observations: Any, infos: Any) -> None:
    """What can be asked of a household has answers."""
    for agent in env.possible_agents:
        assert env.observation_space(agent).contains(observations[agent])
        assert env.describe(observations[agent])
        assert np.isfinite(env.appropriateness(agent)).all()
        assert np.abs(env.appropriateness(agent)).max() <= 1.0
        assert all(1 <= value <= 10 for value in env.opinion(agent).values())
        assert str(env.situation(agent))
        assert infos[agent]["action_mask"].any()
    before = env.state()
    env.restore(env.checkpoint())
    assert env.state().tobytes() == before.tobytes()
