"""Moments that policies are scored on, drawn by a walk that none of them produced.

Touches alone are a biased score: a robot that nobody looks at gets no taps, and a
policy changes what is looked at. A probe set is the same for every policy: the moments
at which a robot chooses while it behaves at random and holds each behavior to its end.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from household.environment import Household

Floats = npt.NDArray[np.float64]

MATTERS = 0.02
"""A moment is in a probe set if some behavior's verdict is at least this far from 0 and
the best one at least this far above their mean: else nobody would perceive the robot,
or it makes no difference what it does. Verdicts are in [-1, 1]; our choice."""


@dataclass(frozen=True, kw_only=True)
class Sight:
    """What a robot may know as it chooses."""

    agent: str
    """Name of the robot."""

    situation: Hashable
    """The situation as it sees it."""

    observation: object
    """Its observation, as the environment encodes it (features, unless asked for)."""

    n_behaviors: int
    """How many behaviors it can choose from."""


@dataclass(frozen=True, kw_only=True)
class Moment(Sight):
    """A sight with what only the simulator knows: for references, not for policies."""

    truth: Floats
    """Verdict of the people present on each behavior, shape (n_behaviors,), [-1, 1]."""

    expected: Floats
    """The same for a reference that does not know who is who, shape (n_behaviors,)."""

    @property
    def matters(self) -> bool:
        """Whether it makes a difference here what the robot does."""
        spread = self.truth.max() - self.truth.mean()
        return bool(np.abs(self.truth).max() >= MATTERS and spread >= MATTERS)

    def sight(self) -> Sight:
        """What a policy under test gets to see."""
        return Sight(
            agent=self.agent,
            situation=self.situation,
            observation=self.observation,
            n_behaviors=self.n_behaviors,
        )


@dataclass(frozen=True, kw_only=True)
class ProbeSet:
    """The moments that policies are scored on in one household."""

    moments: tuple[Moment, ...]
    """Those that matter, in the order of the walk."""

    share: float
    """What share of all moments of the walk that is."""


def moment(env: Household, agent: str, observation: object) -> Moment:
    """Returns this moment of an episode, as one robot is in it."""
    robot = env.possible_agents.index(agent)
    return Moment(
        agent=agent,
        situation=env.situation(agent),
        observation=observation,
        n_behaviors=len(env.behaviors),
        truth=env.simulation.appropriateness(robot),
        expected=env.simulation.appropriateness(robot, on_average=True),
    )


def reference_walk(
    env: Household, seed: int, steps: int | None = None
) -> Iterator[Moment]:
    """Walks through an episode; robots draw behaviors and hold them to their end.

    Args:
        env: The household.
        seed: Of the episode and of the draws.
        steps: Steps at most; None: the whole episode.

    Yields:
        Each moment at which a robot chooses, before it does.
    """
    rng = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(1,)))
    observations, _ = env.reset(seed=seed)
    while env.agents and (steps is None or env.decision < steps):
        actions = {}
        for agent in env.agents:
            if env.behavior_over(agent):
                yield moment(env, agent, observations[agent])
                actions[agent] = int(rng.integers(len(env.behaviors)))
        observations, *_ = env.step(actions)


def probe_set(
    env: Household, seeds: Sequence[int], steps: int | None = None
) -> ProbeSet:
    """Returns the moments of several walks through one household that matter.

    Args:
        env: The household.
        seeds: One for each walk.
        steps: Steps of each walk at most.
    """
    walked = [each for seed in seeds for each in reference_walk(env, seed, steps)]
    kept = tuple(each for each in walked if each.matters)
    return ProbeSet(moments=kept, share=len(kept) / max(len(walked), 1))
