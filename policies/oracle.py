"""What only the simulator knows, for the bounds that learners are measured against.

A learner that is to be judged never gets any of this; oracles and a robot that may ask
"why?" do.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import TYPE_CHECKING

from household.compiled.arrays import Floats
from learners.experience import Experience, Reward
from policies.learning import Home, LearningRobot, Observer

if TYPE_CHECKING:
    from household.environment import Household
    from household.feedback import Cause


class OracleObserver(Observer):
    """Watches one robot's household and answers what oracles ask.

    Args:
        env: The household.
        agent: The robot's name.
    """

    def __init__(self, env: Household, agent: str) -> None:
        self._env = env
        self._agent = agent
        self._robot = env.possible_agents.index(agent)
        self._causes: dict[tuple[Hashable, float], float] = {}

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Remembers what the touches of this step are about."""
        felt, causes = self._env.feedback(self._agent), self._env.causes(self._agent)
        for touch, cause in zip(felt, causes, strict=True):
            if cause.robot == self._agent:
                self._causes[touch.giver, touch.time] = self._moment(cause)

    def _moment(self, cause: Cause) -> float:
        """When the pair that a touch is about was in force [s].

        A bout that was judged as it ended is followed by the next one at that moment.
        """
        period = self._env.scenario.decision_period
        lasts = self._env.scenario.repertoire[cause.behavior].duration
        ended = cause.decision * period + lasts <= cause.time
        return cause.time - period / 2 if ended else cause.time

    def cause(self, reward: Reward) -> float | None:
        """When what a touch is about was in force [s]; None: another robot did it."""
        return self._causes.get((reward.giver, reward.time))

    def ask(self, reward: Reward, candidates: tuple[Experience, ...]) -> int | None:
        """Asks the giver "why?"; it points at one of the entries, or at none."""
        moment = self.cause(reward)
        for index, entry in enumerate(candidates):
            if moment is not None and entry.time <= moment < entry.next_time:
                return index
        return None

    def appropriateness(self, state: Hashable) -> Floats:
        """What the people who are there want now, shape (n_behaviors,)."""
        del state  # The simulator knows more of this moment than a situation tells.
        return self._env.simulation.appropriateness(self._robot)

    def average_appropriateness(self, state: Hashable) -> Floats:
        """What average people would want now, shape (n_behaviors,)."""
        del state
        return self._env.simulation.appropriateness(self._robot, on_average=True)

    def provides(self, learner: str, needs: tuple[str, ...]) -> dict[str, object]:
        """What a learner of the catalog needs to know, by the names that it uses.

        Args:
            learner: Its name in the catalog.
            needs: What its recipe needs.
        """
        average = learner == "population_oracle"
        known = {
            "ask": self.ask,
            "cause": self.cause,
            "appropriateness": self.average_appropriateness
            if average
            else self.appropriateness,
        }
        return {need: known[need] for need in needs}
