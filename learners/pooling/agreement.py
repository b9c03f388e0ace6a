"""Agreement: learning from what people do how much one of them says about another."""

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field

from learners.errors import SavedFileError, check_positive, check_range, shown

Sums = list[float]

MOST_SUM = 1e30
"""Of a sum in a file: no number of touches comes to it."""


@dataclass(kw_only=True, eq=False)
class Agreement:
    """How far people agree: the slope of what one does on what others did.

    1 if people agree, 0 if one says nothing about the other, and no less. It is learned
    for everybody together, and for each person around that.

    Attributes:
        prior_trust: trust before any evidence, in [0, 1]. 0.5: our choice, midway
            between no pooling and a blind one.
        prior_weight: how much the prior weighs, > 0, in squared predictions; the trust
            in all weighs as much in the trust in one person.
        noise: variance of one observation over the variance of tastes, > 0.
    """

    prior_trust: float = 0.5
    prior_weight: float = 2.0
    noise: float = 0.5
    _agreed: dict[Hashable, Sums] = field(default_factory=dict, init=False, repr=False)
    _agreed_all: Sums = field(
        default_factory=lambda: [0.0, 0.0], init=False, repr=False
    )  # sum of value * prediction, sum of prediction ** 2

    def __post_init__(self) -> None:
        check_range("prior_trust", self.prior_trust, 0.0, 1.0)
        check_positive("prior_weight", self.prior_weight)
        check_positive("noise", self.noise)

    def check_loaded(self) -> None:
        """Refuse sums that no comparisons add up to.

        Raises:
            SavedFileError: if they are no pairs, or squares sum up to less than 0.
        """
        check_sums([self._agreed_all, *self._agreed.values()], 1)

    def trust_in_all(self) -> float:
        """How far people agree at large, in [0, 1]; as much is a stranger trusted."""
        return _slope(self._agreed_all, self.prior_trust, self.prior_weight)

    def trust_in(self, person: Hashable) -> float:
        """How far this person agrees with others, in [0, 1]."""
        return self._trust_in(person, self.trust_in_all())

    def _trust_in(self, person: Hashable, in_all: float) -> float:
        agreed = self._agreed.get(person)
        if agreed is None:
            return in_all
        return _slope(agreed, in_all, self.prior_weight)

    def _compare(
        self, person: Hashable, value: float, prediction: float, weight: float
    ) -> None:
        """Take note of what a person did, and of what was to be expected of others."""
        agreed = self._agreed.setdefault(person, [0.0, 0.0])
        for sums in (agreed, self._agreed_all):
            sums[0] += value * prediction
            sums[1] += weight * prediction**2


def check_sums(pairs: Iterable[Sequence[float]], positive: int) -> None:
    """Refuse pairs of sums from a file, one of which cannot be below 0.

    Raises:
        SavedFileError: if they are no pairs, or that one is below 0.
    """
    for pair in pairs:
        if len(pair) != 2 or pair[positive] < 0.0 or max(map(abs, pair)) > MOST_SUM:
            raise SavedFileError(f"a pair of sums is {shown(pair)}, which it cannot be")


def _slope(sums: Sequence[float], prior: float, weight: float) -> float:
    slope = (weight * prior + sums[0]) / (weight + sums[1])
    return min(max(slope, 0.0), 1.0)
