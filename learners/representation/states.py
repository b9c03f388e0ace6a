"""What representations and analogies ask of a state."""

from collections.abc import Hashable
from functools import cache
from typing import Protocol, Self, TypeGuard

from learners.errors import StateError

Relation = tuple[str, Hashable]
"""Name of a relation, and what an entity stands in it to: ("plays", "reading")."""

View = tuple[Relation, ...]
"""What is true of one entity when nobody else is looked at, its own name left out."""


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


class ViewedState(Hashable, Protocol):
    """What views ask of a state."""

    def views(self) -> tuple[tuple[Hashable, View], ...]:
        """Every actor with its view, ordered by actor.

        The relations of a view are ordered. Among them, "plays" leads to the role, and
        "attends" and "hears" to the robots that the actor attends to and would hear.
        """
        ...


class RenamedState(Hashable, Protocol):
    """What a representation without names asks of a state."""

    def without_names(self) -> Hashable:
        """The same whoever plays the roles: names are dealt out by role."""
        ...


def is_state(state: Hashable) -> TypeGuard[State]:
    """Whether a state offers what analogy asks of it."""
    return not _lacks(type(state), State)


def as_state(state: Hashable) -> State:
    """The state, checked to offer what analogy asks of it.

    Raises:
        StateError: if it does not.
    """
    if is_state(state):
        return state
    raise _refusal(state, "analogy", State)


def as_viewed(state: Hashable) -> ViewedState:
    """The state, checked to offer what views ask of it.

    Raises:
        StateError: if it does not.
    """
    if _lacks(type(state), ViewedState):
        raise _refusal(state, "a representation by views", ViewedState)
    return state  # type: ignore[return-value] # just checked


def as_renamed(state: Hashable) -> RenamedState:
    """The state, checked to offer itself without names.

    Raises:
        StateError: if it does not.
    """
    if _lacks(type(state), RenamedState):
        raise _refusal(state, "a representation without names", RenamedState)
    return state  # type: ignore[return-value] # just checked


@cache  # far quicker than looking at every state anew
def _lacks(kind: type, protocol: type) -> tuple[str, ...]:
    return tuple(name for name in _asked(protocol) if not hasattr(kind, name))


@cache
def _asked(protocol: type) -> tuple[str, ...]:
    return tuple(name for name in vars(protocol) if not name.startswith("_"))


def _refusal(state: Hashable, what: str, protocol: type) -> StateError:
    return StateError(
        f"{what} needs {', '.join(_asked(protocol))} of a state; "
        f"{type(state).__name__} lacks {', '.join(_lacks(type(state), protocol))}"
    )
