"""Doings: what people are about when no robot interrupts them, as time passes."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import FLOAT, INDICES, MASK, bind, compiled
from household.state import Stateful


class Doing(Protocol):
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


class Doings(Stateful):
    """What everybody does.

    Args:
        doings: One for each person; asked only when a time of its is over.

    Attributes:
        place: Index of the activity region that each is to be in, shape (n,).
        look: Index of the entity that each is to look at, or `OWN_ACTIVITY`, (n,).
    """

    STATE = ("_doings", "place", "look", "_left", "_until", "_look_left")

    def __init__(self, doings: Sequence[Doing]) -> None:
        self._doings = doings
        self.place = np.array([doing.place for doing in doings], dtype=np.intp)
        self.look = np.array([doing.look for doing in doings], dtype=np.intp)
        self._left = np.array([doing.lasts for doing in doings])
        self._until = np.array([doing.until for doing in doings])
        self._look_left = np.array([doing.look_lasts for doing in doings])
        self._over = np.zeros(len(doings), np.bool_)
        self._pass_time = bind(
            _pass_time,
            self._left,
            self._until,
            self._look_left,
            self._over,
            then=(FLOAT, FLOAT, MASK, INDICES),
        )

    def play(self, now: float, period: float, arrived: Mask, wanted: Indices) -> None:
        """Lets time pass; what is not spent in the own place counts by the clock only.

        Args:
            now: Time since the episode began [s].
            period: Time since the last call [s].
            arrived: Who was in its place, shape (n,).
            wanted: The robot that each is out to touch instead, or `NOBODY`, (n,).
        """
        if self._pass_time(now, period, arrived, wanted):
            for i in self._over.nonzero()[0].tolist():
                self._go_on(i, now)

    def _go_on(self, i: int, now: float) -> None:
        """Does with one person what is due."""
        doing = self._doings[i]
        if self._look_left[i] <= 0.0:
            doing.turn_look()
            self._look_left[i] = doing.look_lasts
        if self._left[i] <= 0.0 or now >= self._until[i]:
            doing.go_on(now)
            self._left[i], self._until[i] = doing.lasts, doing.until
            self._look_left[i] = doing.look_lasts
        self.place[i], self.look[i] = doing.place, doing.look


@compiled
def _pass_time(
    left: Floats,
    until: Floats,
    look_left: Floats,
    over: Mask,
    now: float,
    period: float,
    arrived: Mask,
    wanted: Indices,
) -> bool:
    """Takes time from what is ``left``; returns whether anybody's is ``over``."""
    anybody = False
    for i in range(len(left)):
        if arrived[i] and wanted[i] == NOBODY:
            left[i] -= period
            look_left[i] -= period
        over[i] = left[i] <= 0.0 or look_left[i] <= 0.0 or now >= until[i]
        anybody |= over[i]
    return anybody
