"""Fixed shift: people react after a constant delay.

MacGlashan et al. (2017), "Interactive learning from policy-dependent human feedback",
ICML, shift every feedback back by one human delay.
"""

from dataclasses import dataclass

from learners.credit.history import History
from learners.credit.rules import CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import check_range
from learners.experience import Reward
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True)
class FixedShift(CreditRule):
    """All credit to the pair in force a fixed time before the touch.

    Attributes:
        delay: [s], >= 0. 3 s: our choice for a home, where the giver walks.
    """

    delay: float = 3.0

    def __post_init__(self) -> None:
        check_range("delay", self.delay, 0.0)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """1 to the entry in force then."""
        index = history.in_force(reward.time - self.delay)
        return Weighing({index: 1.0}, index)
