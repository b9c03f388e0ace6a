"""Schedules: what people do by chance, as a semi-Markov chain over places."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from household.people.mind import OWN_ACTIVITY


@dataclass(frozen=True, slots=True)
class Stop:
    """One place of a schedule.

    Attributes:
        place: Index of the activity region.
        duration: Shortest and longest time to be there [s].
        then: Probability of each stop to be the next, shape (n_stops,).
    """

    place: int
    duration: tuple[float, float]
    then: NDArray[np.float64]


class Schedule:
    """Where a person is in its schedule.

    Args:
        stops: At least one; the first is where it begins.
        rng: Draws how long each stay takes and where it leads.
    """

    def __init__(self, stops: Sequence[Stop], rng: np.random.Generator) -> None:
        self._stops = stops
        self._rng = rng
        self._begin(0)

    def _begin(self, index: int) -> None:
        self._stop = self._stops[index]
        self._left = float(self._rng.uniform(*self._stop.duration))

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""
        return self._stop.place

    @property
    def look(self) -> int:
        """A schedule leaves the gaze to habit."""
        return OWN_ACTIVITY

    def play(self, now: float, period: float, *, there: bool) -> None:
        """Lets time pass; chooses the next stop when the stay is up.

        Args:
            now: Time since the episode began [s]; schedules do not look at the clock.
            period: Time since the last call [s].
            there: Whether this time was spent in the place.
        """
        del now
        self._left -= period if there else 0.0
        if self._left <= 0.0:
            self._begin(int(self._rng.choice(len(self._stops), p=self._stop.then)))
