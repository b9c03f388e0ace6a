"""Policy shaping (Advise): touches are votes on whether a behavior is right.

Griffith, Subramanian, Scholz, Isbell & Thomaz (2013), "Policy shaping: integrating
human feedback with reinforcement learning", NIPS. With no reward but the touches
themselves, the policy is the feedback policy alone.
"""

import math
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

from learners.errors import ParameterError, is_within, shown
from learners.exploration import draw
from learners.learner import Credit
from learners.saving import saved
from learners.sums import added
from learners.tabular.base import CreditedLearner


@saved
@dataclass(eq=False)
class Advise(CreditedLearner):
    """Counts caresses minus taps, D(s, a), and draws from the policy they imply.

    Pr(a is right) is proportional to C^D(s, a) * (1 - C)^(sum of D over the others).
    A touch counts by its value and eligibility. Silence does not count.

    Attributes:
        consistency: C, how often a touch is meant as it is felt, in (1/2, 1). 0.9: our
            choice.
        table: D(s, a), and the touches behind it.
    """

    consistency: float = field(default=0.9, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        known = is_within(self.consistency, 0.5, 1.0)
        if not (known and 0.5 < self.consistency < 1.0):
            raise ParameterError(
                f"consistency is {shown(self.consistency)}, not in (1/2, 1)"
            )

    def _values(self, state: Hashable) -> Sequence[float]:
        """Probability of each behavior to be the right one."""
        votes = super()._values(state)
        # C^D (1 - C)^(S - D) is, up to a factor, (C / (1 - C))^D.
        odds = math.log(self.consistency / (1.0 - self.consistency))
        top = max(votes)
        weights = [math.exp(odds * (each - top)) for each in votes]
        total = added(weights)
        return [weight / total for weight in weights]

    def act(self, state: Hashable) -> int:
        """A draw from the feedback policy; `exploration` has no part in it."""
        return draw(self._values(state), self.rng)

    def _absorb(self, credits: Sequence[Credit]) -> None:
        for credit in credits:
            if (reward := credit.reward) is not None:
                for entry, weight in credit.shares:
                    for cell in self.memory.taught(entry.state, reward.giver):
                        votes = cell.row.values[entry.action] + weight * reward.value
                        self.memory.move(cell, entry.action, votes, 1.0, weight)
