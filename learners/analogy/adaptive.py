"""Adaptive analogy: learns from agreement between actors how far to trust a swap."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

from learners.analogy.operators import Canonical, as_state
from learners.errors import check_positive, check_range
from learners.experience import Experience, Reward
from learners.saving import saved
from learners.tabular.qtable import QTable
from learners.tabular.updates import pooled

_Sums = list[float]


@saved
@dataclass(kw_only=True, eq=False)
class AdaptiveAnalogy(Canonical):
    """Partial pooling between actors, by how far they turned out to agree.

    Every update goes to the state's own row and to a row of its class under swaps. A
    state reads its own value, drawn towards its class's by `updates.pooled`: strongly
    where it has felt few touches itself and people are known to agree, not at all
    where they are known to differ.

    Trust is the slope of a touch on what analogous states (the same class, other
    states) were told about the same behavior: 1 if people agree, 0 if one says nothing
    about the other, and no less. It is learned for everybody together, and for each
    giver around that. A state is trusted as far as the least typical of its people.
    Silence under attention, where others touched, is weak evidence that people differ.

    Source: section 3.2 of the paper asks for "what is true for e1 is true for e2";
    trusting it in part, and learning how far, is our choice, after partial pooling
    (Gelman & Hill 2007, chapter 12).

    Attributes:
        prior_trust: trust before any evidence, in [0, 1]. 0.5: our choice, midway
            between no analogy and a blind one.
        prior_weight: how many comparisons the prior is worth, > 0; the trust in all
            is worth as many to the trust in one giver. 2: our choice, so that a
            handful of touches overrules it.
        noise: variance of one touch over the variance of tastes, > 0. 0.5: our
            choice; touches are mostly meant.
        silence: what a silence under attention counts as a comparison, in [0, 1]. 0.1:
            our choice; people mostly keep silent.
    """

    prior_trust: float = 0.5
    prior_weight: float = 2.0
    noise: float = 0.5
    silence: float = 0.1
    _told: dict[Hashable, dict[int, _Sums]] = field(
        default_factory=dict, init=False, repr=False
    )  # row -> behavior -> touches, sum of their values
    _agreed: dict[Hashable, _Sums] = field(
        default_factory=dict, init=False, repr=False
    )  # giver -> sum of value * prediction, sum of prediction ** 2
    _agreed_all: _Sums = field(
        default_factory=lambda: [0.0, 0.0], init=False, repr=False
    )

    def __post_init__(self) -> None:
        check_range("prior_trust", self.prior_trust, 0.0, 1.0)
        check_positive("prior_weight", self.prior_weight)
        check_positive("noise", self.noise)
        check_range("silence", self.silence, 0.0, 1.0)

    def class_row(self, state: Hashable) -> Hashable:
        """Row of the state's class; apart from the representative's own row."""
        return ("class", self.key(state))

    def trust_in(self, giver: Hashable) -> float:
        """How far a swap with this actor is to be trusted, in [0, 1]."""
        everybody = _slope(self._agreed_all, self.prior_trust, self.prior_weight)
        return self._slope_of(self._agreed.get(giver), everybody)

    def trust(self, state: Hashable) -> float:
        """How far the analogs of a state are to be trusted, in [0, 1]."""
        everybody = _slope(self._agreed_all, self.prior_trust, self.prior_weight)
        known = [self._agreed.get(e) for e in as_state(state).entities]
        return min(
            (self._slope_of(agreed, everybody) for agreed in known), default=everybody
        )

    def values(self, table: QTable, state: Hashable) -> Sequence[float]:
        """The state's own values, drawn towards its class's."""
        trust = self.trust(state)
        told = self._told.get(state, {})
        both = zip(
            table.values(state), table.values(self.class_row(state)), strict=True
        )
        return [
            pooled(own, told.get(action, _NOTHING)[0], shared, trust, self.noise)
            for action, (own, shared) in enumerate(both)
        ]

    def visits(self, table: QTable, state: Hashable) -> Sequence[float]:
        """The state's own visits, and of its class's as many as it is trusted."""
        trust = self.trust(state)
        both = zip(
            table.visits(state), table.visits(self.class_row(state)), strict=True
        )
        return [own + trust * (shared - own) for own, shared in both]

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """The state's own row and its class's."""
        return ((state, 1.0), (self.class_row(state), 1.0))

    def observe(self, entry: Experience, reward: Reward | None, weight: float) -> None:
        """Compare a touch, or a silence, with what analogous states were told."""
        if reward is None and not entry.attended:
            return
        prediction = self._others(entry.state, entry.action)
        weight = min(weight, 1.0)
        if reward is None:
            if prediction is not None:
                self._agreed_all[1] += self.silence * weight * prediction**2
            return
        if prediction is not None:
            agreed = self._agreed.setdefault(reward.giver, [0.0, 0.0])
            for sums in (agreed, self._agreed_all):
                sums[0] += weight * reward.value * prediction
                sums[1] += weight * prediction**2
        for row in (entry.state, self.class_row(entry.state)):
            behaviors = self._told.setdefault(row, {})
            told = behaviors.setdefault(entry.action, [0.0, 0.0])
            told[0] += weight
            told[1] += weight * reward.value

    def _slope_of(self, agreed: _Sums | None, everybody: float) -> float:
        if agreed is None:
            return everybody
        return _slope(agreed, everybody, self.prior_weight)

    def _others(self, state: Hashable, action: int) -> float | None:
        """Mean of what the other states of the class were told; None if nothing."""
        shared = self._told.get(self.class_row(state), {}).get(action)
        if shared is None:
            return None
        own = self._told.get(state, {}).get(action, _NOTHING)
        touches = shared[0] - own[0]
        return (shared[1] - own[1]) / touches if touches > _LEAST_TOUCHES else None


_NOTHING = (0.0, 0.0)  # touches, sum of their values
_LEAST_TOUCHES = 1e-9  # below, the difference is rounding


def _slope(sums: Sequence[float], prior: float, weight: float) -> float:
    slope = (weight * prior + sums[0]) / (weight + sums[1])
    return min(max(slope, 0.0), 1.0)
