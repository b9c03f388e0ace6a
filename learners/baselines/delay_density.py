"""TAMER's credit: how likely is a human delay of so many seconds?

Knox & Stone (2009), "Interactively shaping agents via human reinforcement: the TAMER
framework", K-CAP: a feedback is shared among past steps by the probability, under a
gamma density of human delay, that it was meant for them.
"""

import math
from dataclasses import dataclass

from learners.credit.history import History
from learners.credit.rules import LEAST_WEIGHT, CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import check_positive, check_whole
from learners.experience import Reward
from learners.saving import saved
from learners.sums import added

MOST_SHAPE = 100
"""Powers of a delay stay numbers."""

_SURELY = 746.0
"""Scales after which a density is over: exp(-746) is nothing for floating point."""


@saved
@dataclass(frozen=True, kw_only=True)
class DelayDensity(CreditRule):
    """Credit by a gamma density of delay, integrated over each entry.

    Normalized over the history, so that every touch counts once.

    Attributes:
        shape: of the gamma density, a whole number >= 1. 2, as in the paper.
        scale: [s] of the gamma density, > 0. The paper's 0.28 s is for key presses of
            people who sit and watch; 1.5 s, a mean of 3 s, is our choice for people
            who walk.
    """

    shape: int = 2
    scale: float = 1.5

    def __post_init__(self) -> None:
        check_whole("shape", self.shape, 1, MOST_SHAPE)
        check_positive("scale", self.scale)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """Each entry's probability of being meant; the likeliest is designated."""
        latest = history.in_force(reward.time)
        masses = {
            index: self._mass(reward.time, entry.time, entry.next_time)
            for index, entry in enumerate(history.entries[: latest + 1])
        }
        total = added(masses.values())
        if total <= 0.0:
            return Weighing({latest: 1.0}, latest)
        shares = {index: mass / total for index, mass in masses.items()}
        weights = {i: share for i, share in shares.items() if share >= LEAST_WEIGHT}
        return Weighing(weights, max(weights, key=weights.__getitem__))

    def _mass(self, felt: float, begin: float, end: float) -> float:
        mass = self.cumulative(felt - begin) - self.cumulative(felt - min(end, felt))
        return max(mass, 0.0)  # Rounding can make nothing less than that.

    def cumulative(self, delay: float) -> float:
        """Probability of a delay up to so many seconds (Erlang distribution)."""
        x = max(delay, 0.0) / self.scale
        if x > _SURELY:
            return 1.0
        terms = added(x**k / math.factorial(k) for k in range(self.shape))
        return 1.0 - math.exp(-x) * terms
