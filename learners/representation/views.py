"""Representations by views: each person by itself, as if nobody else were there.

A view is what one person stands for in a situation: its role and its relations to
robots. In a home of many people nearly every whole situation is new, but few views are.
"""

from collections.abc import Hashable
from dataclasses import dataclass
from functools import lru_cache
from typing import ClassVar, NamedTuple

from learners.errors import ParameterError, shown
from learners.representation.parts import Part, Representation
from learners.representation.states import View, as_viewed
from learners.saving import saved

PERCEIVING = frozenset({"attends", "hears"})
"""Relations by which a person perceives a robot."""


class Look(NamedTuple):
    """What a representation makes of one view.

    Attributes:
        view: its relations without those that are left out.
        perceives: whether the person perceives a robot.
        hears: whether the person hears one.
    """

    view: View
    perceives: bool
    hears: bool


@lru_cache(maxsize=1 << 12)  # there are few views, and they are met again and again
def look(view: View, relations: tuple[str, ...]) -> Look:
    """Look at a view, at some of its relations alone."""
    names = {name for name, _ in view}
    return Look(
        view=tuple(pair for pair in view if pair[0] in relations),
        perceives=not PERCEIVING.isdisjoint(names),
        hears="hears" in names,
    )


@lru_cache(maxsize=1 << 12)  # before an entry, after it, and at the choice between
def is_alone(state: Hashable) -> bool:
    """Whether nobody perceives a robot, as far as the situation says.

    Raises:
        StateError: if it is no situation of views.
    """
    views = as_viewed(state).views()
    return not any(look(view, ()).perceives for _, view in views)


def _check_names(what: str, given: object) -> None:
    """Refuse what is no tuple of names of relations."""
    names = given if isinstance(given, tuple) else (None,)
    if not all(isinstance(each, str) for each in names):
        raise ParameterError(f"{what} are {shown(given)}, no names")


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

    def __post_init__(self) -> None:
        _check_names("relations", self.relations)

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The view of each, by person."""
        views = as_viewed(state).views()
        looks = [look(view, self.relations) for _, view in views]
        # Whether the situation says who hears the robot is seen where somebody does.
        all_perceive = not any(each.hears for each in looks)
        return tuple(
            Part(each.view, person, all_perceive or each.perceives)
            for (person, _), each in zip(views, looks, strict=True)
        )


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
            Part(each.view, person)
            for person, view in as_viewed(state).views()
            if (each := look(view, self.relations)).perceives
        )


@saved
@dataclass(frozen=True, kw_only=True)
class NestedViews(AudibleViews):
    """Audible views in full and, beside them, with fewer relations.

    What few relations tell is soon learned, and serves where a view is new; what only
    the full view tells is learned as well. What is read is the mean of all levels
    (coarse coding: Sutton & Barto 2018, "Reinforcement learning", section 9.5.3).

    Attributes:
        coarser: the relations of each further level.
    """

    coarser: tuple[tuple[str, ...], ...] = (("plays",),)

    def __post_init__(self) -> None:
        super().__post_init__()
        levels = self.coarser if isinstance(self.coarser, tuple) else (self.coarser,)
        for level in levels:
            _check_names("relations of a coarser level", level)

    @property
    def n_levels(self) -> int:
        """The full views and the coarser ones."""
        return 1 + len(self.coarser)

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The views of each who perceives the robot: in full, then the coarser ones."""
        levels = self.relations, *self.coarser
        return tuple(
            # With its level, as a view may lack what is left out elsewhere.
            Part((level, each.view), person)
            for person, view in as_viewed(state).views()
            for level, relations in enumerate(levels)
            if (each := look(view, relations)).perceives
        )


@saved
@dataclass(frozen=True, kw_only=True)
class PersonViews(Views):
    """Everybody's view with the name in it: nothing is carried from one to another."""

    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The view of each, told apart by person whatever the pooling."""
        return tuple(
            Part((person, view), person, perceives)
            for view, person, perceives in super().parts(state)
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
        return (Part(frozenset(part.key for part in super().parts(state))),)
