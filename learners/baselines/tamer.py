"""TAMER: predict the human's feedback itself, and do what it predicts best.

Knox & Stone (2009), "Interactively shaping agents via human reinforcement: the TAMER
framework", K-CAP. No discounting, no bootstrapping: a person already judges with the
future in mind. The tabular model is a linear one with an indicator per pair.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

from learners.baselines.delay_density import DelayDensity
from learners.credit.rules import CreditRule
from learners.errors import check_range
from learners.experience import Experience
from learners.exploration import Estimates, Exploration, Greedy
from learners.learner import Credit
from learners.saving import saved
from learners.tabular.base import CreditedLearner
from learners.tabular.qtable import QTable


@saved
@dataclass(eq=False)
class Tamer(CreditedLearner):
    """A model H(state, behavior) of feedback, learned by gradient descent.

    A touch h is compared with what was predicted for all that it may be about,
    H = sum of c_i * H(s_i, a_i), and each pair moves by rate * c_i * (h - H). Steps
    without feedback are not learned from.

    Attributes:
        credit: the delay density.
        exploration: greedy, as in the paper.
        step: learning rate, in [0, 1]. 0.2: our choice.
        model: H, and how much feedback is behind each value.
    """

    credit: CreditRule = field(default_factory=DelayDensity, kw_only=True)
    exploration: Exploration = field(default_factory=Greedy, kw_only=True)
    step: float = field(default=0.2, kw_only=True)
    model: QTable = field(init=False, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("step", self.step, 0.0, 1.0)
        self.model = QTable(n_behaviors=self.n_behaviors)

    def estimates(self, state: Hashable) -> Estimates:
        """Predicted feedback for each behavior."""
        return Estimates(*self.model.row(state))

    def _absorb(self, credits: Sequence[Credit]) -> None:
        for credit in credits:
            if credit.reward is not None:
                self._descend(credit.reward.value, credit.shares)

    def _descend(self, felt: float, shares: Sequence[tuple[Experience, float]]) -> None:
        predicted = sum(w * self.model.values(e.state)[e.action] for e, w in shares)
        error = felt - predicted
        for entry, weight in shares:
            value = self.model.values(entry.state)[entry.action]
            self.model.move(
                entry.state, entry.action, value + error, self.step * weight, weight
            )
