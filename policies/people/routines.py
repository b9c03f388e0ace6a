"""Routines: what people do when no robot interrupts them, as time passes."""

from collections.abc import Sequence
from typing import Annotated, NamedTuple, Protocol

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import bind, compiled
from household.state import Stateful


class Routine(Protocol):
    """What one person does: a script or a schedule.

    Attributes:
        lasts: Time to be spent in the present place [s].
        until: When that ends at the latest [s].
        look_lasts: Time there until the look is to be turned [s].
    """

    lasts: float
    until: float
    look_lasts: float

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""

    @property
    def look(self) -> int:
        """Index of the entity to look at, or `OWN_ACTIVITY`."""

    def turn_look(self) -> None:
        """Looks somewhere else, as ``look_lasts`` is over."""

    def go_on(self, now: float) -> None:
        """Goes on to what comes next."""


class TimeLeft(NamedTuple):
    """The time that everybody has left for what it does.

    Attributes:
        here: In the present place, shape (n_people,) [s].
        look: With the present look, shape (n_people,) [s].
        until: When to go on at the latest, shape (n_people,) [s].
        over: Whose time is over, shape (n_people,).
    """

    here: Annotated[Floats, "n_people"]
    look: Annotated[Floats, "n_people"]
    until: Annotated[Floats, "n_people"]
    over: Annotated[Mask, "n_people"]


class Routines(Stateful):
    """What everybody does.

    Args:
        routines: One for each person; asked only when a time of its is over.

    Attributes:
        place: Index of the activity region that each is to be in, shape (n_people,).
        look: Index of the entity that each is to look at, or `OWN_ACTIVITY`, (n,).
    """

    STATE = ("_routines", "place", "look", "_left")

    def __init__(self, routines: Sequence[Routine]) -> None:
        self._routines = routines
        self.place = np.array([each.place for each in routines], dtype=np.intp)
        self.look = np.array([each.look for each in routines], dtype=np.intp)
        self._left = TimeLeft(
            here=np.array([each.lasts for each in routines]),
            look=np.array([each.look_lasts for each in routines]),
            until=np.array([each.until for each in routines]),
            over=np.zeros(len(routines), np.bool_),
        )
        self._pass_time = bind(_pass_time, self._left)

    def advance(
        self, now: float, period: float, arrived: Mask, target: Indices
    ) -> None:
        """Lets time pass; what is not spent in the own place counts by the clock only.

        Args:
            now: Time since the episode began [s].
            period: Time since the last call [s].
            arrived: Who was in its place, shape (n_people,).
            target: The robot that each is out to touch instead, or `NOBODY`, (n,).
        """
        if self._pass_time(now, period, arrived, target):
            for i in self._left.over.nonzero()[0].tolist():
                self._go_on(i, now)

    def _go_on(self, i: int, now: float) -> None:
        """Does with one person what is due."""
        routine, left = self._routines[i], self._left
        if left.look[i] <= 0.0:
            routine.turn_look()
            left.look[i] = routine.look_lasts
        if left.here[i] <= 0.0 or now >= left.until[i]:
            routine.go_on(now)
            left.here[i], left.until[i] = routine.lasts, routine.until
            left.look[i] = routine.look_lasts
        self.place[i], self.look[i] = routine.place, routine.look


@compiled
def _pass_time(
    left: TimeLeft,
    now: float,
    period: float,
    arrived: Annotated[Mask, "n_people"],
    target: Annotated[Indices, "n_people"],
) -> bool:
    """Takes time from what is left; returns whether anybody's is over."""
    anybody = False
    for i in range(len(target)):
        if arrived[i] and target[i] == NOBODY:
            left.here[i] -= period
            left.look[i] -= period
        is_over = left.here[i] <= 0.0 or left.look[i] <= 0.0 or now >= left.until[i]
        left.over[i] = is_over
        anybody |= is_over
    return anybody
