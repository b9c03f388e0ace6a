"""Uniform window: a touch is about anything in the seconds before it.

Warnell, Waytowich, Lawhern & Stone (2018), "Deep TAMER: interactive agent shaping in
high-dimensional state spaces", AAAI, credit a window of 0.2 to 4 s uniformly.
"""

from dataclasses import dataclass

from learners.credit.history import History
from learners.credit.rules import CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import ParameterError, check_range
from learners.experience import Reward
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True)
class UniformWindow(CreditRule):
    """Equal credit per second to whatever went on in a window before the touch.

    Attributes:
        nearest: [s] end of the window before the touch, >= 0.
        furthest: [s] its beginning before the touch, > nearest.
    """

    nearest: float = 0.2
    furthest: float = 4.0

    def __post_init__(self) -> None:
        check_range("nearest", self.nearest, 0.0)
        check_range("furthest", self.furthest, 0.0)
        if not self.furthest > self.nearest:
            raise ParameterError(
                f"the window from {self.furthest} to {self.nearest} s ago is empty"
            )

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """The share of the window that each entry fills; none if before the history."""
        begin, end = reward.time - self.furthest, reward.time - self.nearest
        weights: dict[int, float] = {}
        for index in range(history.in_force(begin), history.in_force(end) + 1):
            entry = history.entries[index]
            overlap = min(entry.next_time, end) - max(entry.time, begin)
            # Rounding can make it more than 1, or nothing of the shortest of entries.
            share = min(overlap / (self.furthest - self.nearest), 1.0)
            if share > 0.0:
                weights[index] = share
        most = max(weights, key=weights.__getitem__, default=None)
        return Weighing(weights, most)
