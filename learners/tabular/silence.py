"""Silent steps: how a learner learns from entries in which nobody touched the robot."""

from dataclasses import dataclass, field

from learners.errors import ParameterError, check_range, shown
from learners.learner import Credit
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True)
class SilentSteps:
    """What is made of the silence of an entry.

    In the paper silence is a reward of 0 that is learned at once, and one count of a
    pair's updates sets the rate of touches and of silence alike. Both can be otherwise,
    alone or together.

    A touch that has to be walked for comes after its entry is over. Silence that is
    *held back* is learned later: once `wait` seconds have passed after the entry, at
    the end of an entry at which nobody is seen on the way to the robot. It is never
    learned if a touch turns out to be about that entry above all, or if the episode
    ends before.

    Attributes:
        apart: whether updates by touches and by silence are counted apart, so that
            silence does not use up the rate of touches.
        held: whether silence is held back.
        wait: [s] least time for which it is, >= 0. 2 s: a person reacts after 1 s (the
            median of 4,967 touches of a robot arm by 46 people, CHARM, arXiv
            2506.13079), and a robot looks once a second. Of effect only if held.
    """

    apart: bool = False
    held: bool = False
    wait: float = 2.0

    def __post_init__(self) -> None:
        for name in ("apart", "held"):
            if not isinstance(getattr(self, name), bool):
                value = shown(getattr(self, name))
                raise ParameterError(f"{name} is {value}, not true or false")
        check_range("wait", self.wait, 0.0)


@saved
@dataclass(eq=False)
class Waiting:
    """Silence that is held back.

    Attributes:
        credits: whose time has not come, oldest first; none of a touch.
    """

    credits: list[Credit] = field(default_factory=list)

    def due(
        self, credits: tuple[Credit, ...], now: float, *, approached: bool, wait: float
    ) -> list[Credit]:
        """What is to be learned now: all touches, and silence whose time has come.

        Args:
            credits: of the newest entry.
            now: [s] when that ended.
            approached: whether somebody was seen on the way to the robot then.
            wait: [s] how long silence is held back at least.
        """
        touches = [each for each in credits if each.reward is not None]
        touched = [each.designated for each in touches]
        self.credits += [each for each in credits if each.reward is None]
        self.credits = [each for each in self.credits if each.designated not in touched]
        if approached:
            return touches
        is_due = [_ended(each) + wait <= now for each in self.credits]
        silent = [each for each, due in zip(self.credits, is_due, strict=True) if due]
        self.credits = self.credits[len(silent) :]  # ends are in order of time
        return silent + touches


def _ended(credit: Credit) -> float:
    """[s] when the entry ended that the silence is about."""
    return max(entry.next_time for entry, _ in credit.shares)
