"""What a robot lived through: touches, and the entries of its history."""

from collections.abc import Hashable
from dataclasses import dataclass

from learners.errors import LATEST, ExperienceError, check_hashable, is_within, shown
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
        approach_began: [s] when the giver was seen setting out towards the robot,
            some time after it had; None: it did not come walking.
        attention_began: [s] when the giver was last seen turning to the robot, some
            time after it had; None: it does not attend, or nobody saw it.

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
        if not is_within(self.value, -1.0, 1.0):
            raise ExperienceError(f"reward value {shown(self.value)} is not in [-1, 1]")
        if not is_within(self.mood, -1.0, 1.0):
            raise ExperienceError(f"mood {shown(self.mood)} is not in [-1, 1]")
        _check_time("reward time", self.time)
        check_hashable("the giver", self.giver)
        self._check_began("approach", self.approach_began)
        self._check_began("attention", self.attention_began)

    def _check_began(self, what: str, began: float | None) -> None:
        if began is not None and not is_within(began, -LATEST, self.time):
            raise ExperienceError(
                f"{what} began at {shown(began)} s, which is not before the touch at "
                f"{self.time} s"
            )


def _check_time(what: str, time: float) -> None:
    if not is_within(time, -LATEST, LATEST):
        raise ExperienceError(
            f"{what} {shown(time)} s is not finite, or beyond {LATEST:.0e} s"
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
        approached: whether somebody was seen on the way to the robot as it ended.

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
    approached: bool = False

    def __post_init__(self) -> None:
        _check_time("the beginning of an entry,", self.time)
        _check_time("the end of an entry,", self.next_time)
        check_hashable("the state", self.state)
        check_hashable("the next state", self.next_state)
        if self.next_time < self.time:
            raise ExperienceError(
                f"entry ends at {self.next_time} s, before it began at {self.time} s"
            )
        if not isinstance(self.rewards, tuple):
            raise ExperienceError(f"rewards are {shown(self.rewards)}, no tuple")
        for touch in self.rewards:
            if not isinstance(touch, Reward):
                raise ExperienceError(f"{shown(touch)} is no reward")
            if touch.time > self.next_time:
                raise ExperienceError(
                    f"reward at {touch.time} s comes from the future: the entry "
                    f"ends at {self.next_time} s"
                )
