"""Heuristics that designate the pair a reward is about.

Source: section 3.1 of the paper ("heuristics are modeled as functions that designate a
recent state-action pair for reward"); which ones is our choice.
"""

from dataclasses import dataclass
from typing import Protocol

from learners.credit.history import History
from learners.errors import check_positive, check_range
from learners.experience import Reward
from learners.saving import saved


class Heuristic(Protocol):
    """Names one entry of the history."""

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of the entry that the reward is about.

        Raises:
            ExperienceError: if the history is empty.
        """
        ...


@saved
@dataclass(frozen=True, kw_only=True)
class MostRecent:
    """The pair in force when the touch was felt."""

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of that entry."""
        return history.in_force(reward.time)


@saved
@dataclass(frozen=True, kw_only=True)
class FixedDelay:
    """The pair in force a fixed time before the touch.

    Attributes:
        delay: [s], >= 0. 3 s: our choice, about the walk across a room.
    """

    delay: float = 3.0

    def __post_init__(self) -> None:
        check_range("delay", self.delay, 0.0)

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of that entry."""
        return history.in_force(reward.time - self.delay)


@saved
@dataclass(frozen=True, kw_only=True)
class BeforeApproach:
    """The pair in force just before the giver made up its mind to come over.

    That is some time before it was seen setting out, or before the touch if it did not
    come walking, as people take a moment to react and robots to notice. What the robot
    chose at that very moment cannot be what moved the giver; then it is the pair
    before.

    Attributes:
        reaction: [s] how far to look back, >= 0. 1 s: people react after 1.01 s in the
            median (CHARM, arXiv 2506.13079). 0: what was in force when the giver was
            seen setting out is what moved it.
    """

    reaction: float = 1.0

    def __post_init__(self) -> None:
        check_range("reaction", self.reaction, 0.0)

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of that entry."""
        came = reward.approach_began
        moved = (reward.time if came is None else came) - self.reaction
        index = history.in_force(moved)
        entry = history.entries[index]
        chosen_then = came is not None and entry.chosen and entry.time >= moved
        return history.before(moved) if chosen_then else index


@saved
@dataclass(frozen=True, kw_only=True)
class AttentionShift:
    """The pair in force when the giver last began to attend to the robot.

    The shift itself begins a new entry (the situation changes), so the pair is the one
    just before it. A shift long ago is about something else: then, or if none was
    seen, it is the pair in force at the touch.

    Attributes:
        reach: [s] how long ago a shift may be, > 0. 15 s: our choice, the longest walk
            through a home at 1.2 m/s.
        notice: [s] how far to look back from when the shift was noticed, >= 0. 1 s: a
            turn of the head is noticed half a second late, hardly ever a second.
    """

    reach: float = 15.0
    notice: float = 1.0

    def __post_init__(self) -> None:
        check_positive("reach", self.reach)
        check_range("notice", self.notice, 0.0)

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of that entry."""
        noticed = reward.attention_began
        if noticed is None or reward.time - noticed > self.reach:
            return history.in_force(reward.time)
        return history.before(noticed - self.notice)
