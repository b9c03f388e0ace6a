"""The robots of a household: what each is doing and what it has felt."""

import math

import numpy as np
from numpy.typing import NDArray

from household.people.feedback import Cause, Feedback
from household.robots.behavior import Bout
from household.scenario import Scenario

IDLE = Bout(behavior=-1, decision=-1, began=-math.inf, ends=-math.inf)
"""Before the first choice."""


class Robots:
    """All robots, in the order of their names.

    Attributes:
        bouts: What each robot is doing.
        feedback: The touches that each felt in the last step.
        causes: What each of those touches was really about; for evaluation only.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.names = scenario.robot_names
        self._repertoire = scenario.repertoire
        self.begin()

    def begin(self) -> None:
        """Begins a new episode."""
        n = len(self.names)
        self.bouts: list[Bout] = [IDLE] * n
        self.feedback: list[tuple[Feedback, ...]] = [()] * n
        self.causes: list[tuple[Cause, ...]] = [()] * n

    def choose(self, robot: int, behavior: int, decision: int, now: float) -> None:
        """Goes on with a behavior, or begins it anew when it is over or another.

        Args:
            robot: Index of the robot.
            behavior: Index of the behavior.
            decision: Index of this environment step.
            now: [s].
        """
        bout = self.bouts[robot]
        if bout.behavior != behavior or self.is_over(robot, now):
            ends = now + self._repertoire[behavior].duration
            self.bouts[robot] = Bout(behavior, decision, now, ends)

    def is_over(self, robot: int, now: float) -> bool:
        """Whether what a robot was doing is done."""
        return self.bouts[robot].ends <= now + 1e-9

    def cause(self, robot: int, now: float) -> Cause:
        """The bout of a robot as the cause of what people may do about it.

        Args:
            robot: Index of the robot.
            now: When somebody judges the bout [s].
        """
        bout = self.bouts[robot]
        return Cause(self.names[robot], bout.decision, bout.behavior, now)

    def forget_touches(self) -> None:
        """Makes room for the touches of the next step."""
        self.feedback = [()] * len(self.names)
        self.causes = [()] * len(self.names)

    def feel(self, robot: int, feedback: Feedback, cause: Cause) -> None:
        """A touch is felt."""
        self.feedback[robot] += (feedback,)
        self.causes[robot] += (cause,)

    @property
    def behaviors(self) -> NDArray[np.intp]:
        """Index of each robot's behavior, -1 before the first, shape (n,)."""
        return np.array([bout.behavior for bout in self.bouts], dtype=np.intp)

    @property
    def felt(self) -> NDArray[np.float64]:
        """Sum of caresses and of taps felt in this step, (n, 2), both in [0, 1]."""
        felt = np.zeros((len(self.names), 2))
        for robot, touches in enumerate(self.feedback):
            for touch in touches:
                kind = 0 if touch.kind == "caress" else 1
                felt[robot, kind] = min(felt[robot, kind] + touch.strength, 1.0)
        return felt

    def sources(self, since: float) -> list[float]:
        """How loud each robot is at 1 m [dB]; what was over before is silent.

        Args:
            since: Beginning of the period that is listened to [s].
        """
        return [
            0.0 if self.is_over(i, since) else self._repertoire[bout.behavior].loudness
            for i, bout in enumerate(self.bouts)
        ]

    def salience(self, since: float) -> list[float]:
        """How strongly each robot draws the eye; 1 when it does nothing.

        Args:
            since: Beginning of the period that is looked at [s].
        """
        return [
            1.0 if self.is_over(i, since) else self._repertoire[bout.behavior].salience
            for i, bout in enumerate(self.bouts)
        ]

    def left(self, now: float) -> NDArray[np.float64]:
        """Share of each robot's bout that is left, shape (n,), in [0, 1]."""
        return np.array(
            [
                0.0
                if self.is_over(i, now)
                else (bout.ends - now) / (bout.ends - bout.began)
                for i, bout in enumerate(self.bouts)
            ]
        )
