"""Playing behaviors out: from one and the same state, what would really follow?

Used in two ways: as the reference that comes nearest to a ceiling, and to check how far
the verdict that `appropriateness` foretells is from what people then think.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from experiments.scoring.moments import Floats, moment
from experiments.scoring.scores import new_verdicts

if TYPE_CHECKING:
    from household.environment import Household


def played_out(env: Household, agent: str) -> Floats:
    """Returns what people would think of each behavior, were it begun now.

    Each behavior is held to its end while the other robots go on with what they do. The
    household is left as it was.

    Args:
        env: In an episode.
        agent: The robot.

    Returns:
        The mean over all people of their verdicts on the bout, shape (n_behaviors,).
    """
    start, robot = env.checkpoint(), env.possible_agents.index(agent)
    n_people = len(env.scenario.people)
    verdicts = np.zeros(len(env.behaviors))
    for behavior in range(len(verdicts)):
        actions = {agent: behavior}
        while env.agents:
            env.step(actions)
            verdicts[behavior] += new_verdicts(env, robot) / n_people
            if env.behavior_over(agent):
                break
            actions = {}
        env.restore(start)
    return verdicts


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """How far foretold verdicts are from those that followed."""

    moments: int
    """How many moments were played out."""

    error: float
    """Mean absolute difference of foretold and real verdicts, which are in [-1, 1]."""

    agreement: float
    """Share of the moments in which the same behavior is best."""

    loss: float
    """What the foretold best is short of the real best, in units of the probe score."""


def deviation(
    env: Household, seed: int, moments: int, rng: np.random.Generator
) -> Deviation | None:
    """Plays behaviors out at some moments of a reference walk.

    Args:
        env: The household.
        seed: Of the walk.
        moments: How many moments to play out; the first that matter.
        rng: Draws what the robots do in between.

    Returns:
        None if no moment mattered.
    """
    foretold: list[Floats] = []
    real: list[Floats] = []
    observations, _ = env.reset(seed=seed)
    while env.agents and len(real) < moments:
        actions: dict[str, int] = {}
        for agent in env.agents:
            if env.behavior_over(agent):
                now = moment(env, agent, observations[agent])
                # One robot in turn: what another one begins now would be judged, too.
                if now.matters and not actions and len(real) < moments:
                    foretold.append(now.truth)
                    real.append(played_out(env, agent))
                actions[agent] = int(rng.integers(len(env.behaviors)))
        observations, *_ = env.step(actions)
    return _compared(foretold, real) if real else None


def _compared(foretold: Sequence[Floats], real: Sequence[Floats]) -> Deviation:
    said, came = np.array(foretold), np.array(real)
    chosen, rows = said.argmax(axis=1), np.arange(len(came))
    spread = came.max(axis=1) - came.mean(axis=1)
    # Where nothing that people would have thought differs, nothing is lost.
    lost = np.divide(
        came.max(axis=1) - came[rows, chosen],
        spread,
        out=np.zeros(len(came)),
        where=spread > 0.0,
    )
    return Deviation(
        moments=len(came),
        error=float(np.abs(said - came).mean()),
        agreement=float(np.mean(chosen == came.argmax(axis=1))),
        loss=float(lost.mean()),
    )
