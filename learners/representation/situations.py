"""Representations by whole situations: with names, canonical, and without names."""

from collections.abc import Hashable
from dataclasses import dataclass
from typing import ClassVar

from learners.representation.parts import Part, Representation
from learners.representation.states import as_renamed, as_state
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True)
class Named(Representation):
    """The situation itself: who plays what, by name; any hashable state will do."""

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The state alone."""
        return (Part(state),)


@saved
@dataclass(frozen=True, kw_only=True)
class Canonical(Representation):
    """One row for all situations that swaps of those present make of each other.

    The same as carrying every update along SwapRoles, closed and at strength 1, in one
    look-up instead of up to n! updates. Whoever is there is told from others by name.
    """

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The representative of the state's class."""
        return (Part(as_state(state).canonical()),)


@saved
@dataclass(frozen=True, kw_only=True)
class Nameless(Representation):
    """One row for all situations alike but for names; strangers meet known rows.

    The same as `Canonical` closed under swaps with people who are not there.
    """

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The state without names."""
        return (Part(as_renamed(state).without_names()),)


@saved
@dataclass(frozen=True, kw_only=True)
class MarkedSituations(Representation):
    """For each person the whole canonical situation, with that person marked.

    The mark is the class of what remains without the person.
    """

    by_person: ClassVar[bool] = True

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The marked situation of everybody who is there."""
        situation = as_state(state)
        whole, people = situation.canonical(), situation.entities
        last = people[-1] if people else None
        # Each person takes the last one's name before leaving, so that what remains has
        # the same names whoever left.
        return tuple(
            Part((whole, situation.swapped(e, last).without(last).canonical()), e)
            for e in people
        )
