"""What a robot lived through: touches, and the entries of its history."""

import math
from collections.abc import Hashable
from dataclasses import dataclass

from learners.errors import ExperienceError
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True, slots=True)
class Reward:
    """What a learner is given for one touch, as the robot perceives it.

    Attributes:
        value: in [-1, 1]; a caress is positive, a tap negative.
        time: [s] when it was felt.
        giver: who gave it.
        attending: whether the giver attended to the robot as it touched it.
        mood: mood of the giver as the robot perceives it, in [-1, 1].
        approach_began: [s] when the giver was seen setting out towards the robot;
            None: it did not need to walk.
        attention_began: [s] when the giver last began to attend to the robot; None:
            it never did, or nobody saw it.

    Raises:
        ExperienceError: if a number is not finite, out of range or out of order.
    """

    value: float
    time: float
    giver: Hashable
    attending: bool
    mood: float = 0.0
    approach_began: float | None = None
    attention_began: float | None = None

    def __post_init__(self) -> None:
        if not -1.0 <= self.value <= 1.0:  # catches NaN too
            raise ExperienceError(f"reward value {self.value} is not in [-1, 1]")
        if not -1.0 <= self.mood <= 1.0:
            raise ExperienceError(f"mood {self.mood} is not in [-1, 1]")
        if not math.isfinite(self.time):
            raise ExperienceError(f"reward time {self.time} is not finite")
        self._check_began("approach", self.approach_began)
        self._check_began("attention", self.attention_began)

    def _check_began(self, what: str, began: float | None) -> None:
        if began is not None and not (math.isfinite(began) and began <= self.time):
            raise ExperienceError(
                f"{what} began at {began} s, which is not before the touch at "
                f"{self.time} s"
            )


@saved
@dataclass(frozen=True, kw_only=True, slots=True)
class Experience:
    """One entry of the history: the pair (state, action) and what came of it.

    A new entry begins whenever the situation changes, the behavior changes, or a
    behavior is chosen anew (as in Table 1 of the paper).

    Attributes:
        state: the situation, any hashable value.
        action: index of the behavior, 0 .. n_behaviors - 1.
        next_state: the situation of the entry that follows; equal to `state` where
            only the behavior changed.
        time: [s] when the entry began.
        next_time: [s] when it ended.
        rewards: touches felt within the entry, oldest first.
        attended: whether somebody attended to the robot during the entry.
        chosen: False if the behavior just went on while the situation changed.

    Raises:
        ExperienceError: if a time is not finite, the entry ends before it begins, or
            a touch is felt after its end.
    """

    state: Hashable
    action: int
    next_state: Hashable
    time: float
    next_time: float
    rewards: tuple[Reward, ...] = ()
    attended: bool = False
    chosen: bool = True

    def __post_init__(self) -> None:
        if not (math.isfinite(self.time) and math.isfinite(self.next_time)):
            raise ExperienceError(
                f"entry from {self.time} to {self.next_time} s is not finite"
            )
        if self.next_time < self.time:
            raise ExperienceError(
                f"entry ends at {self.next_time} s, before it began at {self.time} s"
            )
        for touch in self.rewards:
            if touch.time > self.next_time:
                raise ExperienceError(
                    f"reward at {touch.time} s comes from the future: the entry "
                    f"ends at {self.next_time} s"
                )
