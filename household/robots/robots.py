"""The robots of a household: what each is doing and what it has felt."""

import math

import numpy as np

from household.compiled.arrays import Floats, Indices, Zeros, new_zeros
from household.compiled.jit import FLOAT, FLOATS, bind, compiled
from household.feedback import Cause, Feedback, reward
from household.robots.bout import Bout
from household.scenario.scenario import Scenario
from household.state import Stateful

MOMENT = 1e-9
"""By how much times may miss each other through rounding [s]."""

IDLE = Bout(behavior=-1, decision=-1, began=-math.inf, ends=-math.inf)
"""Before the first choice."""


class Robots(Stateful):
    """All robots, in the order of their names.

    Args:
        scenario: Names them and says what they can do.
        zeros: Makes the arrays that others see: `behaviors`, `begun` and
            `rewards`.

    Attributes:
        bouts: What each robot is doing.
        behaviors: Index of each robot's behavior, -1 before the first, shape (n,).
        begun: The decision at which each began its bout, -1 before the first, (n,).
        left: Share of each robot's bout that was left when they last were shown, shape
            (n,), in [0, 1].
        touched: Whether any robot felt a touch in the last step.
        felt: Sum of caresses and of taps felt in it, (n, 2), both in [0, 1].
        feedback: The touches that each felt in it.
        rewards: The reward of each for it, shape (n,).
        causes: What each of those touches was really about; for evaluation only.
    """

    STATE = (
        "bouts",
        "behaviors",
        "begun",
        "_began",
        "_ends",
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
        self.behaviors: Indices = zeros("behavior", (n,), np.intp)
        self.begun: Indices = zeros("begun", (n,), np.intp)
        self.rewards: Floats = zeros("reward", (n,))
        self._began, self._ends = np.zeros(n), np.zeros(n)
        self.left, self.felt = np.zeros(n), np.zeros((n, 2))
        self._show = bind(
            _show,
            self.left,
            self.behaviors,
            self._began,
            self._ends,
            np.array([b.salience for b in scenario.repertoire]),
            np.array([b.loudness for b in scenario.repertoire]),
            then=(FLOAT, FLOAT, FLOATS, FLOATS),
        )
        self.begin()

    def begin(self) -> None:
        """Begins a new episode."""
        self.bouts: list[Bout] = [IDLE] * len(self.names)
        self.behaviors[:], self.begun[:] = IDLE.behavior, IDLE.decision
        self._began[:], self._ends[:] = IDLE.began, IDLE.ends
        self.left[:] = 0.0
        self._untouched()

    def choose(self, robot: int, behavior: int, decision: int, now: float) -> None:
        """Goes on with a behavior, or begins it anew when it is over or another.

        Args:
            robot: Index of the robot.
            behavior: Index of the behavior.
            decision: Index of this environment step.
            now: [s].
        """
        if self.bouts[robot].behavior != behavior or self.is_over(robot, now):
            ends = now + self._durations[behavior]
            self.bouts[robot] = Bout(behavior, decision, now, ends)
            self.behaviors[robot], self.begun[robot] = behavior, decision
            self._began[robot], self._ends[robot] = now, ends

    def is_over(self, robot: int, now: float) -> bool:
        """Whether what a robot was doing is done."""
        return self.bouts[robot].ends <= now + MOMENT

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
        if self.touched:
            self._untouched()

    def _untouched(self) -> None:
        self.touched = False
        self.feedback: list[tuple[Feedback, ...]] = [()] * len(self.names)
        self.causes: list[tuple[Cause, ...]] = [()] * len(self.names)
        self.felt[:], self.rewards[:] = 0.0, 0.0

    def feel(self, robot: int, feedback: Feedback, cause: Cause) -> None:
        """A touch is felt."""
        self.touched = True
        self.feedback[robot] += (feedback,)
        self.causes[robot] += (cause,)
        self.rewards[robot] = reward(self.feedback[robot])
        kind = 0 if feedback.kind == "caress" else 1
        total = self.felt[robot, kind] + feedback.strength
        self.felt[robot, kind] = min(total, 1.0)

    def show(self, since: float, now: float, salience: Floats, source: Floats) -> None:
        """Tells how robots appear to those who look and listen, and what is `left`.

        What was over before is silent, and draws the eye no more than a person does.

        Args:
            since: Beginning of the period that is looked and listened to [s].
            now: Its end [s].
            salience: How strongly each draws the eye; filled in at its end, as people
                come before robots.
            source: How loud each is at 1 m [dB]; likewise.
        """
        self._show(since, now, salience, source)


@compiled
def _show(
    left: Floats,
    behavior: Indices,
    began: Floats,
    ends: Floats,
    saliences: Floats,
    loudness: Floats,
    since: float,
    now: float,
    salience: Floats,
    source: Floats,
) -> None:
    first = len(salience) - len(behavior)
    for i in range(len(behavior)):
        over = ends[i] <= since + MOMENT
        salience[first + i] = 1.0 if over else saliences[behavior[i]]
        source[first + i] = 0.0 if over else loudness[behavior[i]]
        lasts = ends[i] > now + MOMENT
        left[i] = (ends[i] - now) / (ends[i] - began[i]) if lasts else 0.0
