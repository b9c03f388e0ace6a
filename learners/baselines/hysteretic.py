"""Hysteretic Q-learning: quick to believe good news, slow to believe bad.

Matignon, Laurent & Le Fort-Piat (2007), "Hysteretic Q-learning: an algorithm for
decentralized reinforcement learning in cooperative multi-agent teams", IROS. Forgetting
is bad news, so it too comes slowly.
"""

from dataclasses import dataclass, field

from learners.errors import check_range
from learners.qlearner import QLearner
from learners.saving import saved
from learners.tabular.rates import AsynchronousRate, Rate


@saved
@dataclass(eq=False)
class Hysteretic(QLearner):
    """Q-learning with a factor on the rate by the sign of the error (equation 3).

    Attributes:
        rate: asynchronous by default.
        increase: factor where the value was too low, in [0, 1].
        decrease: factor where it was too high, in [0, 1]. 0.1: our choice, a
            tenth of the other.
    """

    rate: Rate = field(default_factory=AsynchronousRate, kw_only=True)
    increase: float = field(default=1.0, kw_only=True)
    decrease: float = field(default=0.1, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("increase", self.increase, 0.0, 1.0)
        check_range("decrease", self.decrease, 0.0, 1.0)

    def _pace(self, value: float, target: float) -> float:
        return self.increase if target >= value else self.decrease
