"""COACH: feedback judges the policy, so it moves the policy.

MacGlashan, Ho, Loftin, Peng, Wang, Roberts, Taylor & Littman (2017), "Interactive
learning from policy-dependent human feedback", ICML: feedback estimates the advantage
of a behavior under the current policy and weighs the policy gradient. The paper's
real-time form has a constant human delay and an eligibility trace.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

from learners.credit.history import History
from learners.credit.rules import LEAST_WEIGHT, CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import check_positive, check_range
from learners.experience import Reward
from learners.exploration import Exploration, Softmax, softmax
from learners.learner import Credit
from learners.saving import saved
from learners.tabular.base import CreditedLearner
from learners.tabular.cells import Cell


@saved
@dataclass(frozen=True, kw_only=True)
class DelayedTrace(CreditRule):
    """Credit fades by a factor per entry back, from a fixed delay before the touch.

    Attributes:
        delay: [s] human delay, >= 0. 0: our choice; a home's delays are not constant.
        decay: lambda, how much is left per entry back, in [0, 1]. 0.35: our choice.
    """

    delay: float = 0.0
    decay: float = 0.35

    def __post_init__(self) -> None:
        check_range("delay", self.delay, 0.0)
        check_range("decay", self.decay, 0.0, 1.0)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """The trace; the entry in force at the delay is the designated one."""
        newest = history.in_force(reward.time - self.delay)
        weights = {newest - back: self.decay**back for back in range(newest + 1)}
        kept = {i: weight for i, weight in weights.items() if weight >= LEAST_WEIGHT}
        return Weighing(kept, newest)


@saved
@dataclass(eq=False)
class Coach(CreditedLearner):
    """A softmax policy that moves along feedback * gradient of log pi(a | s).

    The gradient is taken at the policy of the moment the touch is felt, not of the
    moment it is about (our choice: they differ little within a walk). Silence is no
    feedback and moves nothing.

    Attributes:
        credit: the delayed trace.
        exploration: the policy itself: a draw from softmax at temperature 1.
        step: learning rate, > 0. 0.5: our choice.
        table: theta(state, behavior), and the feedback behind it.
    """

    credit: CreditRule = field(default_factory=DelayedTrace, kw_only=True)
    exploration: Exploration = field(
        default_factory=lambda: Softmax(temperature=1.0), kw_only=True
    )
    step: float = field(default=0.5, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_positive("step", self.step)

    def policy(self, state: Hashable) -> list[float]:
        """Probability of every behavior in a state."""
        return softmax(self._values(state), 1.0)

    def _absorb(self, credits: Sequence[Credit]) -> None:
        for credit in credits:
            if (reward := credit.reward) is not None:
                for entry, weight in credit.shares:
                    policy = self.policy(entry.state)
                    for cell in self.memory.taught(entry.state, reward.giver):
                        size = self.step * weight * reward.value
                        self._climb(cell, entry.action, policy, size)

    def _climb(
        self, cell: Cell, action: int, policy: Sequence[float], size: float
    ) -> None:
        for behavior, probability in enumerate(policy):
            chosen = float(behavior == action)
            target = cell.row.values[behavior] + (chosen - probability)
            self.memory.move(cell, behavior, target, size, chosen)
