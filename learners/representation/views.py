"""Representations by views: each person by itself, as if nobody else were there.

A view is what one person stands for in a situation: its role and its relations to
robots. In a home of many people nearly every whole situation is new, but few views are.
"""

from collections.abc import Collection, Hashable, Iterator
from dataclasses import dataclass
from typing import ClassVar

from learners.representation.parts import Part, Representation
from learners.representation.states import View, as_viewed
from learners.saving import saved

PERCEIVING = frozenset({"attends", "hears"})
"""Relations by which a person perceives a robot."""


@saved
@dataclass(frozen=True, kw_only=True)
class Views(Representation):
    """Everybody's view, summed up: what each person would give is learned apart.

    Where the situation says who hears the robot, the silence of those who neither hear
    nor attend to it says nothing.

    Attributes:
        relations: those that a view consists of; others are left out.
    """

    by_person: ClassVar[bool] = True
    relations: tuple[str, ...] = ("plays", "attends")

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The view of each, by person."""
        return tuple(
            Part(view, person, perceives)
            for person, view, perceives in self._viewed(state)
        )

    def _viewed(self, state: Hashable) -> Iterator[tuple[Hashable, View, bool]]:
        whole = as_viewed(state).views()
        hearing = any(name == "hears" for _, view in whole for name, _ in view)
        for person, view in whole:
            names = {name for name, _ in view}
            perceives = not hearing or not PERCEIVING.isdisjoint(names)
            yield person, _limited(view, names, self.relations), perceives


@saved
@dataclass(frozen=True, kw_only=True)
class AudibleViews(Views):
    """The views of those alone who could perceive the robot: who attend to or hear it.

    Asks for situations that say who hears the robot; in others only those count who
    attend to it.
    """

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The view of each who perceives the robot, by person."""
        return tuple(
            Part(_limited(view, names, self.relations), person)
            for person, view in as_viewed(state).views()
            if not PERCEIVING.isdisjoint(names := {name for name, _ in view})
        )


@saved
@dataclass(frozen=True, kw_only=True)
class PersonViews(Views):
    """Everybody's view with the name in it: nothing is carried from one to another."""

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The view of each, told apart by person whatever the pooling."""
        return tuple(
            Part((person, view), person, perceives)
            for person, view, perceives in self._viewed(state)
        )


@saved
@dataclass(frozen=True, kw_only=True)
class ViewSet(Views):
    """Which views there are, whoever and however many have them; one row for each set.

    It cannot tell whose view a touch is about.
    """

    by_person: ClassVar[bool] = False

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The set alone."""
        return (Part(frozenset(view for _, view, _ in self._viewed(state))),)


def _limited(view: View, names: Collection[str], relations: tuple[str, ...]) -> View:
    """A view without the relations that are not asked for; itself if all are."""
    if all(name in relations for name in names):
        return view
    return tuple(pair for pair in view if pair[0] in relations)
