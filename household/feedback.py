"""Feedback: touches, and what they are about."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

Kind = Literal["caress", "tap"]


@dataclass(frozen=True, slots=True)
class Cause:
    """What a touch is really about; for evaluation, never for learners.

    Attributes:
        robot: The robot whose behavior called for it.
        decision: The environment step at which the bout in question was begun.
        behavior: Index of that behavior.
        time: When the giver judged it [s]; what is meant is the bout in the situation
            of that moment, which may have changed since the bout was begun.
    """

    robot: str
    decision: int
    behavior: int
    time: float


@dataclass(frozen=True, slots=True, repr=False)
class Feedback:
    """A touch as the robot feels it, with what it saw of the giver.

    Attributes:
        giver: Who touched.
        kind: A caress praises, a tap sanctions.
        strength: In (0, 1].
        time: When it was felt [s].
        mood: The giver's mood as the robot perceives it, in [-1, 1].
        attending: Whether the giver attended to the robot.
        approach_began: When the robot noticed that the giver came [s]: it walked and
            got nearer; None if it did not come walking.
        attention_began: When it noticed that the giver turned to it [s]; None if the
            giver does not attend to it. Both are late and not exact, as the scenario's
            ``notice_delay`` and ``notice_noise`` say.
    """

    giver: str
    kind: Kind
    strength: float
    time: float
    mood: float
    attending: bool
    approach_began: float | None
    attention_began: float | None

    @property
    def value(self) -> float:
        """Positive for a caress, negative for a tap, in [-1, 1]."""
        return self.strength if self.kind == "caress" else -self.strength

    def __repr__(self) -> str:
        attending = "attending" if self.attending else "not attending"
        came = self.approach_began
        how = "without a walk" if came is None else f"came from {came:.1f} s on"
        return (
            f"Feedback({self.giver}: {self.kind} of {self.strength:.2f} at "
            f"{self.time:.1f} s, {attending}, mood {self.mood:+.2f}, {how})"
        )


def reward(touches: Iterable[Feedback]) -> float:
    """A robot's reward for a step: the sum of the touches that it felt.

    Args:
        touches: In the order in which it felt them.
    """
    # Not `sum`, whose last digit depends on the version of Python.
    total = 0.0
    for touch in touches:
        total += touch.value
    return total
