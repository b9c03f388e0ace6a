"""I-SABL: silence is evidence, and what kind of evidence is learned.

Loftin, Peng, MacGlashan, Littman, Taylor, Huang & Roberts (2016), "Learning behaviors
via human-delivered discrete feedback: modeling implicit feedback strategies to speed up
learning", JAAMAS 30. Trainers who mostly reward mean "wrong" by silence; those who
mostly punish mean "right". I-SABL infers the strategy by expectation-maximization,
together with the right behavior of each state.
"""

import math
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from learners.errors import (
    LEAST,
    ParameterError,
    check_range,
    check_whole,
    is_within,
    shown,
)
from learners.learner import Credit
from learners.saving import saved
from learners.sums import added
from learners.tabular.base import CreditedLearner
from learners.tabular.qtable import QTable

_Counts = tuple[float, float, float]  # caresses, taps, silences
_CARESS, _TAP, _SILENCE = range(3)
_KINDS = 3


@saved
@dataclass(eq=False)
class ISabl(CreditedLearner):
    """Posterior over the right behavior of each state, from touches and silences.

    A trainer errs with probability `error`; it keeps silent with probability
    `silence_right` after a right behavior and `silence_wrong` after a wrong one. Values
    are the probability of each behavior to be right. Only silences of entries that
    somebody attended to count (our choice: nobody speaks by not being there).

    Attributes:
        error: probability of a touch of the wrong sign, in (0, 1/2). 0.1: our choice.
        period: entries between two expectation-maximization passes, >= 1; a pass goes
            over all states. 10: our choice.
        prior: strength of the prior on both silences, in pseudo-counts each way, > 0.
        silence_right: mu+, inferred.
        silence_wrong: mu-, inferred.
        table: evidence, counted as visits: caresses, taps and silences of the first
            behavior, then of the second, and so on; values are not used.
        elapsed: entries so far.
    """

    columns: ClassVar[int] = _KINDS
    error: float = field(default=0.1, kw_only=True)
    period: int = field(default=10, kw_only=True)
    prior: float = field(default=2.0, kw_only=True)
    silence_right: float = field(default=0.5, init=False)
    silence_wrong: float = field(default=0.5, init=False)
    elapsed: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_whole("period", self.period, 1, 10**9)
        # Below, a probability of nothing would have no logarithm.
        check_range("prior", self.prior, 1e-3)
        if not (is_within(self.error, LEAST, 0.5) and self.error < 0.5):
            raise ParameterError(f"error is {shown(self.error)}, not in (0, 1/2)")
        self.table = QTable(n_behaviors=_KINDS * self.n_behaviors)

    def check_loaded(self) -> None:
        """Refuse a file in which people never, or always, keep silent.

        Raises:
            LearnerError: if a probability has no logarithm.
        """
        super().check_loaded()
        for name in ("silence_right", "silence_wrong"):
            check_range(name, getattr(self, name), LEAST, 1.0 - LEAST)
        check_whole("elapsed", self.elapsed, 0, 2**63)

    def _values(self, state: Hashable) -> Sequence[float]:
        """Probability of each behavior to be the right one in a state."""
        return self._posterior(_by_behavior(self.memory.visits(state)))

    def _visits(self, state: Hashable) -> Sequence[float]:
        return [added(each) for each in _by_behavior(self.memory.visits(state))]

    def _absorb(self, credits: Sequence[Credit]) -> None:
        for credit in credits:
            for entry, weight in credit.shares:
                if (reward := credit.reward) is not None:
                    cells = self.memory.taught(entry.state, reward.giver)
                    kind = _CARESS if reward.value >= 0.0 else _TAP
                elif entry.attended:
                    cells, kind = self.memory.seen(entry.state).heard, _SILENCE
                else:
                    continue
                for cell in cells:
                    column = _KINDS * entry.action + kind
                    self.memory.move(cell, column, 0.0, 0.0, weight)
        self.elapsed += 1
        if self.elapsed % self.period == 0:
            self._infer_strategy()

    def _likelihoods(self) -> tuple[list[float], list[float]]:
        """Log-probability of caress, tap and silence, if right and if wrong."""
        e, right, wrong = self.error, self.silence_right, self.silence_wrong
        if_right = [
            (1.0 - e) * (1.0 - right),
            e * (1.0 - wrong),
            (1.0 - e) * right + e * wrong,
        ]
        if_wrong = [
            e * (1.0 - right),
            (1.0 - e) * (1.0 - wrong),
            e * right + (1.0 - e) * wrong,
        ]
        return [math.log(p) for p in if_right], [math.log(p) for p in if_wrong]

    def _posterior(self, counts: Sequence[_Counts]) -> list[float]:
        if_right, if_wrong = self._likelihoods()
        # Under the hypothesis "a is right" all others are wrong, so only the gain of a
        # over being wrong itself tells the hypotheses apart.
        gains = [
            added(n * (r - w) for n, r, w in zip(each, if_right, if_wrong, strict=True))
            for each in counts
        ]
        top = max(gains)
        weights = [math.exp(gain - top) for gain in gains]
        total = added(weights)
        return [weight / total for weight in weights]

    def _infer_strategy(self) -> None:
        """One pass: how often was there silence after right, and after wrong?"""
        silent, spoken = [0.0, 0.0], [0.0, 0.0]
        for _, visits in self.table.rows.values():
            counts = _by_behavior(visits)
            for p, (caresses, taps, silences) in zip(
                self._posterior(counts), counts, strict=True
            ):
                for kind, probability in enumerate((p, 1.0 - p)):
                    silent[kind] += probability * silences
                    spoken[kind] += probability * (caresses + taps)
        shares = [
            (self.prior + quiet) / (2.0 * self.prior + quiet + loud)
            for quiet, loud in zip(silent, spoken, strict=True)
        ]
        self.silence_right, self.silence_wrong = shares


def _by_behavior(visits: Sequence[float]) -> list[_Counts]:
    caresses, taps, silences = (visits[kind::_KINDS] for kind in range(_KINDS))
    return list(zip(caresses, taps, silences, strict=True))
