"""The three scores: probe, lived, touches.

The probe score compares choices on moments that no policy has produced; the lived score
and the touches are what becomes of a policy's own episodes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from experiments.scoring.moments import Moment, moment

if TYPE_CHECKING:
    from household.environment import Household

Choose = Callable[[Moment], int]


def probe_score(choices: Sequence[int], moments: Sequence[Moment]) -> float:
    """Returns how good choices are, from random (0) to the best possible (1).

    Args:
        choices: A behavior for each moment.
        moments: From a probe set.

    Returns:
        The mean over moments of (verdict of the choice - mean verdict) / (best - mean);
        NaN without moments.
    """
    if not moments:
        return float("nan")
    truth = np.array([each.truth for each in moments])
    chosen = truth[np.arange(len(moments)), list(choices)]
    mean = truth.mean(axis=1)
    return float(((chosen - mean) / (truth.max(axis=1) - mean)).mean())


@dataclass(frozen=True, kw_only=True)
class Lived:
    """What became of an episode, over all robots."""

    minutes: float
    """Length of the episode, times the number of robots [min]."""

    bouts: int
    """Behaviors begun."""

    verdicts: float
    """Sum of what people privately thought of the bouts that they perceived."""

    caresses: int
    """Touches that were positive."""

    taps: int
    """Touches that were negative."""

    reward: float
    """Sum of all touches."""

    opinion: float
    """Mean answer of people to the questionnaire at the end, 1 to 10."""

    @property
    def per_minute(self) -> float:
        """Verdicts in a robot's minute."""
        return self.verdicts / self.minutes

    @property
    def per_bout(self) -> float:
        """Verdicts on a bout."""
        return self.verdicts / max(self.bouts, 1)


def live(env: Household, choose: Choose, seed: int, steps: int | None = None) -> Lived:
    """Lets a policy live through an episode; it chooses when a behavior is over.

    Args:
        env: The household.
        choose: The policy; all robots share it.
        seed: Of the episode.
        steps: Steps at most; None: the whole episode.
    """
    observations, _ = env.reset(seed=seed)
    bouts, verdicts, caresses, taps, reward = 0, 0.0, 0, 0, 0.0
    robots = env.possible_agents
    while env.agents and (steps is None or env.decision < steps):
        actions = {
            agent: choose(moment(env, agent, observations[agent]))
            for agent in env.agents
            if env.behavior_over(agent)
        }
        bouts += len(actions)
        observations, rewards, *_ = env.step(actions)
        verdicts += new_verdicts(env)
        reward += sum(rewards.values())
        for touch in (touch for agent in robots for touch in env.feedback(agent)):
            caresses += touch.kind == "caress"
            taps += touch.kind == "tap"
    answers = [answer for agent in robots for answer in env.opinion(agent).values()]
    return Lived(
        minutes=env.time / 60.0 * len(robots),
        bouts=bouts,
        verdicts=verdicts,
        caresses=caresses,
        taps=taps,
        reward=reward,
        opinion=float(np.mean(answers)),
    )


def new_verdicts(env: Household, robot: int | None = None) -> float:
    """Returns the sum of what people thought of the bouts that they just judged.

    Args:
        env: After a step.
        robot: Index of the robot that is judged; None: all of them.
    """
    judged = env.simulation.people.appraisals
    values = np.where(judged.new, judged.value, 0.0)
    return float(values.sum() if robot is None else values[:, robot].sum())
