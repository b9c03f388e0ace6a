"""TAMER: predict the human's feedback itself, and do what it predicts best.

Knox & Stone (2009), "Interactively shaping agents via human reinforcement: the TAMER
framework", K-CAP. No discounting, no bootstrapping: a person already judges with the
future in mind. The tabular model is a linear one with an indicator per pair.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from learners.baselines.delay_density import DelayDensity
from learners.credit.rules import CreditRule
from learners.errors import check_range
from learners.exploration import Exploration, Greedy
from learners.learner import Credit
from learners.saving import saved
from learners.sums import added
from learners.tabular.base import CreditedLearner
from learners.tabular.cells import Cell


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
        table: H, and how much feedback is behind each value.
    """

    credit: CreditRule = field(default_factory=DelayDensity, kw_only=True)
    exploration: Exploration = field(default_factory=Greedy, kw_only=True)
    step: float = field(default=0.2, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("step", self.step, 0.0, 1.0)

    def _absorb(self, credits: Sequence[Credit]) -> None:
        for credit in credits:
            if credit.reward is not None:
                giver = credit.reward.giver
                shares = [
                    (cell, entry.action, weight)
                    for entry, weight in credit.shares
                    for cell in self.memory.taught(entry.state, giver)
                ]
                self._descend(credit.reward.value, shares)

    def _descend(self, felt: float, shares: Sequence[tuple[Cell, int, float]]) -> None:
        read = added(w * self.memory.value(cell, b) for cell, b, w in shares)
        error = felt - read / self.memory.n_levels
        for cell, behavior, weight in shares:
            target = cell.row.values[behavior] + error
            self.memory.move(cell, behavior, target, self.step * weight, weight)
