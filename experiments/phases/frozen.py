"""What robots that no longer learn would do."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from experiments.phases.seeing import Slotted, observes
from experiments.scoring.moments import Sight
from experiments.scoring.policies import Policy, of_learner, of_robots

if TYPE_CHECKING:
    from household.environment import Household
    from learners.learner import Learner
    from policies.learning import LearningRobot


def policy_of(
    robots: Mapping[str, LearningRobot], rng: np.random.Generator, env: Household
) -> Policy:
    """What robots that no longer learn would do."""
    return of_robots(
        {
            agent: _looking(robot.learner, env)
            if observes(robot.learner)
            else of_learner(cast("Learner", _Remembering(robot.learner)), rng)
            for agent, robot in robots.items()
        }
    )


def _looking(learner: Learner, env: Household) -> Policy:
    """What a learner that looks at the features would do."""
    slotted = Slotted(env)

    def greedy(sight: Sight) -> int:
        seen = slotted.seen(sight.situation, sight.observation)
        return int(learner.q_values(seen).argmax())

    def deployed(sight: Sight) -> int:
        return learner.act(slotted.seen(sight.situation, sight.observation))

    return Policy(greedy=greedy, deployed=deployed)


class _Remembering:
    """A learner that no longer learns, and is asked for each situation only once."""

    def __init__(self, learner: Learner) -> None:
        self._learner = learner
        self._values: dict[Hashable, Any] = {}
        self._estimates: dict[Hashable, Any] = {}
        self.act = learner.act
        self.exploration = getattr(learner, "exploration", None)

    def q_values(self, state: Hashable) -> Any:  # noqa: ANN401 - as the learner's
        """Its values, remembered."""
        if state not in self._values:
            self._values[state] = self._learner.q_values(state)
        return self._values[state]

    def estimates(self, state: Hashable) -> Any:  # noqa: ANN401 - as the learner's
        """Its estimates, remembered."""
        if state not in self._estimates:
            self._estimates[state] = self._learner.estimates(state)  # type: ignore[attr-defined]
        return self._estimates[state]
