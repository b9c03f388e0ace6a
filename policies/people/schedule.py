"""Schedules: what people do by chance, as a semi-Markov chain over places."""

from bisect import bisect
from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from household.people.mind import OWN_ACTIVITY
from household.state import Stateful


@dataclass(frozen=True, slots=True)
class Stop:
    """One place of a schedule.

    Attributes:
        place: Index of the activity region.
        duration: Shortest and longest time to be there [s].
        then: Cumulative probabilities: for each stop, the chance that the next one is
            this stop or one before it.
    """

    place: int
    duration: tuple[float, float]
    then: Sequence[float]


class Schedule(Stateful):
    """Where a person is in its schedule; `Routines` lets the time pass.

    Args:
        stops: At least one; the first is where it begins.
        rng: Draws how long each stay takes and where it leads.

    Attributes:
        lasts: Time to be spent in the present place [s].
        until: Schedules do not look at the clock.
        look: `OWN_ACTIVITY`, as a schedule leaves the gaze to habit.
        look_lasts: For ever.
    """

    until = inf
    look = OWN_ACTIVITY
    look_lasts = inf

    STATE = ("_rng", "_stop", "lasts")

    def __init__(self, stops: Sequence[Stop], rng: np.random.Generator) -> None:
        self._stops = stops
        self._rng = rng
        self._begin(0)

    def _begin(self, index: int) -> None:
        self._stop = self._stops[index]
        self.lasts = float(self._rng.uniform(*self._stop.duration))

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""
        return self._stop.place

    def turn_look(self) -> None:
        """Does nothing, as a schedule prescribes no look."""

    def go_on(self, now: float) -> None:
        """Chooses the next stop.

        Args:
            now: Time since the episode began [s]; not used.
        """
        del now
        self._begin(bisect(self._stop.then, self._rng.random()))
