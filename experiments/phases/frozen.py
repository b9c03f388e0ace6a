"""What robots that no longer learn would do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from experiments.phases.seeing import Slotted, observes
from experiments.scoring.moments import Sight
from experiments.scoring.policies import Policy, of_learner, of_robots

if TYPE_CHECKING:
    import numpy as np

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
            else of_learner(robot.learner, rng)
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
