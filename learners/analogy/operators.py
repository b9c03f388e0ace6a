"""Operators: functions that transform a state into states like it.

Source: section 3.2 of the paper, "Using Analogy to Accelerate Learning".
"""

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Protocol

from learners.errors import check_whole
from learners.representation.states import as_state
from learners.saving import saved


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
        check_whole("keep", self.keep, 0, 10**6)

    def __call__(self, state: Hashable) -> Iterator[Hashable]:
        """All states with one entity left out."""
        whole = as_state(state)
        if len(whole.entities) > self.keep:
            for entity in whole.entities:
                yield whole.without(entity)
