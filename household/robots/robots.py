"""The robots of a household: what each is doing and what it has felt."""

import math
from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Zeros, new_zeros
from household.compiled.jit import bind, compiled
from household.feedback import Cause, Feedback, reward
from household.robots.bout import Bout, Bouts
from household.scenario.scenario import Scenario
from household.state import Stateful

MOMENT = 1e-9
"""How far apart two equal times may be through rounding [s]."""

IDLE = Bout(behavior=-1, decision=-1, began=-math.inf, ends=-math.inf)
"""Before the first choice."""


class Prominence(NamedTuple):
    """How behaviors appear to those who look and listen.

    Attributes:
        salience: How strongly each behavior draws the eye, shape (n_behaviors,).
        loudness: Its sound level at 1 m, shape (n_behaviors,) [dB].
    """

    salience: Annotated[Floats, "n_behaviors"]
    loudness: Annotated[Floats, "n_behaviors"]


class Robots(Stateful):
    """All robots, in the order of their names.

    Args:
        scenario: Names them and says what they can do.
        zeros: Makes the arrays that are recorded: behaviors, when they were begun, and
            rewards.

    Attributes:
        bouts: What each robot is doing.
        present: The same as arrays.
        left: Share of each robot's bout that was still to come when `show` was last
            called, shape (n,), in [0, 1].
        touched: Whether any robot felt a touch in the last step.
        felt: How strongly each was caressed and tapped in that step, shape (n, 2), both
            in [0, 1].
        feedback: The touches that each felt in that step.
        rewards: The reward of each for them, shape (n,).
        causes: What each of those touches was really about; for evaluation only.
    """

    STATE = (
        "bouts",
        "present",
        "left",
        "touched",
        "felt",
        "feedback",
        "rewards",
        "causes",
    )

    def __init__(self, scenario: Scenario, zeros: Zeros = new_zeros) -> None:
        self.names = scenario.robot_names
        self._durations = [b.duration for b in scenario.repertoire]
        n = len(self.names)
        self.present = Bouts(
            behavior=zeros("behavior", (n,), np.intp),
            decision=zeros("begun", (n,), np.intp),
            began=np.zeros(n),
            ends=np.zeros(n),
        )
        self.rewards: Floats = zeros("reward", (n,))
        self.left, self.felt = np.zeros(n), np.zeros((n, 2))
        prominence = Prominence(
            np.array([b.salience for b in scenario.repertoire]),
            np.array([b.loudness for b in scenario.repertoire]),
        )
        self._show = bind(_show, self.present, self.left, prominence)
        self.begin()

    def begin(self) -> None:
        """Begins a new episode."""
        self.bouts: list[Bout] = [IDLE] * len(self.names)
        for array, value in zip(self.present, IDLE, strict=True):
            array[:] = value
        self.left[:] = 0.0
        self._untouched()

    def choose(self, robot: int, behavior: int, decision: int, now: float) -> None:
        """Goes on with the present bout if it is of that behavior, or begins one.

        Args:
            robot: Index of the robot.
            behavior: Index of the behavior.
            decision: Index of this environment step.
            now: [s].
        """
        if self.bouts[robot].behavior != behavior or self.is_over(robot, now):
            ends = now + self._durations[behavior]
            self.bouts[robot] = Bout(behavior, decision, now, ends)
            present = self.present
            present.behavior[robot], present.decision[robot] = behavior, decision
            present.began[robot], present.ends[robot] = now, ends

    def is_over(self, robot: int, now: float) -> bool:
        """Whether the latest bout of a robot is over."""
        return self.bouts[robot].ends <= now + MOMENT

    def cause(self, robot: int, now: float) -> Cause:
        """The present bout of a robot, as the cause of touches that follow from it.

        Args:
            robot: Index of the robot.
            now: When somebody appraises the bout [s].
        """
        bout = self.bouts[robot]
        return Cause(self.names[robot], bout.decision, bout.behavior, now)

    def forget_touches(self) -> None:
        """Begins a step in which no robot has felt a touch yet."""
        if self.touched:
            self._untouched()

    def _untouched(self) -> None:
        self.touched = False
        self.feedback: list[tuple[Feedback, ...]] = [()] * len(self.names)
        self.causes: list[tuple[Cause, ...]] = [()] * len(self.names)
        self.felt[:], self.rewards[:] = 0.0, 0.0

    def feel(self, robot: int, feedback: Feedback, cause: Cause) -> None:
        """A robot feels a touch.

        Args:
            robot: Index of the robot.
            feedback: The touch.
            cause: What it is really about.
        """
        self.touched = True
        self.feedback[robot] += (feedback,)
        self.causes[robot] += (cause,)
        self.rewards[robot] = reward(self.feedback[robot])
        kind = 0 if feedback.kind == "caress" else 1
        total = self.felt[robot, kind] + feedback.strength
        self.felt[robot, kind] = min(total, 1.0)

    def show(self, since: float, now: float, salience: Floats, source: Floats) -> None:
        """Finds out how robots appear to those who look and listen, and what is `left`.

        A robot whose bout was over before the period is silent, and draws the eye no
        more than a person does.

        Args:
            since: Beginning of the period in which they look and listen [s].
            now: Its end [s].
            salience: How strongly each of the people and robots draws the eye, shape
                (n,); set for the robots, which come last.
            source: Sound level of each at 1 m, shape (n,) [dB]; set likewise.
        """
        self._show(since, now, salience, source)


@compiled
def _show(
    bouts: Bouts,
    left: Annotated[Floats, "n_robots"],
    prominence: Prominence,
    since: float,
    now: float,
    salience: Annotated[Floats, "n"],
    source: Annotated[Floats, "n"],
) -> None:
    """See `Robots.show`."""
    first = len(salience) - len(left)
    for i in range(len(left)):
        began, ends = bouts.began[i], bouts.ends[i]
        over, behavior = ends <= since + MOMENT, bouts.behavior[i]
        salience[first + i] = 1.0 if over else prominence.salience[behavior]
        source[first + i] = 0.0 if over else prominence.loudness[behavior]
        left[i] = (ends - now) / (ends - began) if ends > now + MOMENT else 0.0
