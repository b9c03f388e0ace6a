"""Adaptive analogy: learns from agreement between actors how far to trust a swap."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from learners.analogy.carrying import Analogy
from learners.errors import check_range
from learners.experience import Experience, Reward
from learners.pooling.agreement import Agreement, Sums, check_sums
from learners.pooling.partial import pooled
from learners.representation.states import as_state
from learners.saving import DERIVED, saved
from learners.tabular.memory import MEMO_SIZE, Memory, remember


@saved
@dataclass(kw_only=True, eq=False)
class AdaptiveAnalogy(Agreement, Analogy):
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

    between_named_situations: ClassVar[bool] = True
    silence: float = 0.1
    _told: dict[Hashable, dict[int, Sums]] = field(
        default_factory=dict, init=False, repr=False
    )  # row -> behavior -> touches, sum of their values
    _classes: dict[Hashable, Hashable] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("silence", self.silence, 0.0, 1.0)

    def check_loaded(self) -> None:
        """Refuse touches that nobody can have given.

        Raises:
            SavedFileError: if their number is below 0.
        """
        super().check_loaded()
        for told in self._told.values():
            check_sums(told.values(), 0)

    def class_row(self, state: Hashable) -> Hashable:
        """Row of the state's class; apart from the representative's own row.

        Raises:
            StateError: if the state has no canonical form.
        """
        known = self._classes.get(state)
        if known is None:
            known = ("class", as_state(state).canonical())
            remember(self._classes, state, known, MEMO_SIZE)
        return known

    def trust(self, state: Hashable) -> float:
        """How far the analogs of a state are to be trusted, in [0, 1]."""
        in_all = self.trust_in_all()
        return min(
            (self._trust_in(e, in_all) for e in as_state(state).entities),
            default=in_all,
        )

    def values(self, memory: Memory, state: Hashable) -> Sequence[float]:
        """The state's own values, drawn towards its class's."""
        trust = self.trust(state)
        told = self._told.get(state, {})
        both = zip(
            memory.values(state), memory.values(self.class_row(state)), strict=True
        )
        return [
            pooled(own, told.get(action, _NOTHING)[0], shared, trust, self.noise)
            for action, (own, shared) in enumerate(both)
        ]

    def visits(self, memory: Memory, state: Hashable) -> Sequence[float]:
        """The state's own visits, and of its class's as many as it is trusted."""
        trust = self.trust(state)
        both = zip(
            memory.visits(state), memory.visits(self.class_row(state)), strict=True
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
            self._compare(reward.giver, weight * reward.value, prediction, weight)
        for row in (entry.state, self.class_row(entry.state)):
            behaviors = self._told.setdefault(row, {})
            told = behaviors.setdefault(entry.action, [0.0, 0.0])
            told[0] += weight
            told[1] += weight * reward.value

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
