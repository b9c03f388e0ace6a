"""Analogy: experience with one situation serves situations like it.

Source: section 3.2 of the paper, "Using Analogy to Accelerate Learning".
"""

from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import combinations
from typing import Protocol, Self, TypeGuard, TypeVar

from learners.errors import StateError, check_range
from learners.experience import Experience, Reward
from learners.saving import DERIVED, saved
from learners.tabular.qtable import QTable


class State(Hashable, Protocol):
    """What analogy asks of a state."""

    @property
    def entities(self) -> tuple[Hashable, ...]:
        """The actors it tells of, ordered."""
        ...

    def swapped(self, e1: Hashable, e2: Hashable) -> Self:
        """The same with two actors in each other's place."""
        ...

    def without(self, e: Hashable) -> Self:
        """The same without one actor and all its relations."""
        ...

    def canonical(self) -> Self:
        """One representative of all states that swaps can make of it."""
        ...


def is_state(state: Hashable) -> TypeGuard[State]:
    """Whether a state follows the protocol."""
    return _follows(type(state))


@cache  # far quicker than looking at every state anew
def _follows(kind: type) -> bool:
    asked = ("entities", "swapped", "without", "canonical")
    return all(hasattr(kind, name) for name in asked)


def as_state(state: Hashable) -> State:
    """The state, checked to follow the protocol.

    Raises:
        StateError: if it does not.
    """
    if is_state(state):
        return state
    raise StateError(
        f"analogy needs entities, swapped, without and canonical of a state; "
        f"{type(state).__name__} lacks them"
    )


class Operator(Protocol):
    """op(state) -> {another state, ...}; users add their own, any callable will do."""

    def __call__(self, state: Hashable) -> Iterable[Hashable]:
        """The analogs that this operator makes of a state."""
        ...


@saved
@dataclass(frozen=True, kw_only=True)
class SwapRoles:
    """Exchanges the entities that play two roles, for every two entities.

    Their attention relations go along.

    Source: section 3.2 of the paper, SwapRoles([r1, e1], [r2, e2]).
    """

    def __call__(self, state: Hashable) -> Iterator[Hashable]:
        """All states with two entities exchanged."""
        whole = as_state(state)
        for e1, e2 in combinations(whole.entities, 2):
            yield whole.swapped(e1, e2)


@saved
@dataclass(frozen=True, kw_only=True)
class RemoveEntity:
    """The same situation without one entity: fewer relations, more general.

    Source: section 3.2 of the paper, RemoveEntity().

    Attributes:
        keep: entities that must remain, >= 0. 1: our choice; what an empty home
            teaches is not about people.
    """

    keep: int = 1

    def __post_init__(self) -> None:
        check_range("keep", self.keep, 0)

    def __call__(self, state: Hashable) -> Iterator[Hashable]:
        """All states with one entity left out."""
        whole = as_state(state)
        if len(whole.entities) > self.keep:
            for entity in whole.entities:
                yield whole.without(entity)


@saved
@dataclass(kw_only=True, eq=False)
class Analogy:
    """How the table is read and written for a state; this one knows no analogs.

    Subclasses change where an update goes (`spread`) and what a state reads
    (`values`), never the table itself.
    """

    def values(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Values of a state as this analogy sees them, length n_behaviors."""
        return table.values(state)

    def visits(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Visits behind those values, length n_behaviors."""
        return table.visits(state)

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """Rows that an update of a state goes to, with its strength in [0, 1] there."""
        return ((state, 1.0),)

    def observe(self, entry: Experience, reward: Reward | None, weight: float) -> None:
        """Take note of what was credited to an entry, before the table changes.

        Args:
            entry: the credited entry.
            reward: the touch; None if the entry passed in silence.
            weight: its eligibility.
        """


MEMO_SIZE = 1 << 16
"""Most states that are kept with what was worked out of them."""

_T = TypeVar("_T")


def remember(memo: dict[Hashable, _T], state: Hashable, known: _T, most: int) -> None:
    """Note what is known of a state; all is forgotten when `most` are noted."""
    # Forgetting all at once is rare enough to be cheaper than keeping an order.
    if len(memo) >= most:
        memo.clear()
    memo[state] = known


@saved
@dataclass(kw_only=True, eq=False)
class Propagation(Analogy):
    """Carries every update to the analogs that operators list (as in the paper).

    Operators are applied to their own results up to `depth` times, nearest analogs
    first. An analog reached in d steps takes the update at strength ** d.

    Attributes:
        operators: the operators.
        strength: how much of a step an analog takes per application, in [0, 1]. 1:
            "what is true for e1 will be true for e2". Source: our choice; the paper
            has none.
        depth: how often operators are applied, >= 1. 1 suffices for two actors; n - 1
            closes SwapRoles over n actors.
        limit: most analogs an update is carried to, >= 0. 5040 = 7!: the closure for
            seven actors; beyond, take `Canonical`. Source: our choice.
    """

    operators: tuple[Operator, ...] = (SwapRoles(),)
    strength: float = 1.0
    depth: int = 1
    limit: int = 5040
    _memo: dict[Hashable, tuple[tuple[Hashable, float], ...]] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        check_range("strength", self.strength, 0.0, 1.0)
        check_range("depth", self.depth, 1)
        check_range("limit", self.limit, 0)

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """The state itself, then its analogs, nearest first."""
        known = self._memo.get(state)
        if known is None:
            known = tuple(self._closure(state).items())
            remember(self._memo, state, known, MEMO_SIZE // len(known))
        return known

    def _closure(self, state: Hashable) -> dict[Hashable, float]:
        reached: dict[Hashable, float] = {state: 1.0}
        frontier: list[Hashable] = [state]
        for distance in range(1, self.depth + 1):
            found = self._new_analogs(frontier, reached)
            frontier = found[: self.limit + 1 - len(reached)]
            reached |= dict.fromkeys(frontier, self.strength**distance)
        return reached

    def _new_analogs(
        self, states: list[Hashable], reached: dict[Hashable, float]
    ) -> list[Hashable]:
        found = (a for s in states for op in self.operators for a in op(s))
        return [a for a in dict.fromkeys(found) if a not in reached]


@saved
@dataclass(kw_only=True, eq=False)
class Canonical(Analogy):
    """One row per class of states that swaps make of each other.

    The same as `Propagation` of SwapRoles, closed and at strength 1, in one look-up
    instead of up to n! updates.
    """

    _memo: dict[Hashable, Hashable] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )

    def key(self, state: Hashable) -> Hashable:
        """The representative of a state's class.

        Raises:
            StateError: if the state has no canonical form.
        """
        known = self._memo.get(state)
        if known is None:
            known = as_state(state).canonical()
            remember(self._memo, state, known, MEMO_SIZE)
        return known

    def values(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Values of the state's class."""
        return table.values(self.key(state))

    def visits(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Visits of the state's class."""
        return table.visits(self.key(state))

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """The representative alone."""
        return ((self.key(state), 1.0),)
