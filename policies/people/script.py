"""Scripts: a timeline of places and of whom to attend to, over and over."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from household.people.mind import OWN_ACTIVITY

Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a script.

    Attributes:
        place: Index of the activity region to be in.
        duration: Shortest and longest time to be there [s].
        until: Time at which the line ends at the latest [s].
        look: Index of the entity to attend to, or `OWN_ACTIVITY`.
        look_for: Shortest and longest time of looking there at a stretch [s].
        look_away: Shortest and longest time of not looking there, in between [s].
    """

    place: int
    duration: Range = (inf, inf)
    until: float = inf
    look: int = OWN_ACTIVITY
    look_for: Range = (inf, inf)
    look_away: Range = (0.0, 0.0)


class Script:
    """Where a person is in its script.

    Args:
        lines: At least one.
        rng: Draws how long each line and each look takes this time.
    """

    def __init__(self, lines: Sequence[Line], rng: np.random.Generator) -> None:
        self._lines = lines
        self._rng = rng
        self._begin(0)

    def _begin(self, index: int) -> None:
        self._index = index
        self._left = self._drawn(self.line.duration)
        self._looks = True
        self._look_left = self._drawn(self.line.look_for)

    def _drawn(self, times: Range) -> float:
        shortest, longest = times
        return shortest if shortest == longest else self._rng.uniform(*times)

    @property
    def line(self) -> Line:
        """The line that is being played."""
        return self._lines[self._index]

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""
        return self.line.place

    @property
    def look(self) -> int:
        """Index of the entity that the script says to look at, or `OWN_ACTIVITY`."""
        return self.line.look if self._looks else OWN_ACTIVITY

    def play(self, now: float, period: float, *, there: bool) -> None:
        """Lets time pass; goes on to the next line when the present one is up.

        Args:
            now: Time since the episode began [s].
            period: Time since the last call [s].
            there: Whether this time was spent in the place of the line; other time
                counts only against ``until``.
        """
        if there:
            self._left -= period
            self._alternate(period)
        if self._left <= 0.0 or now >= self.line.until:
            self._go_on(now)

    def _alternate(self, period: float) -> None:
        """Looks for a while, then looks away for a while."""
        self._look_left -= period
        if self._look_left <= 0.0:
            self._looks = not self._looks
            line = self.line
            self._look_left = self._drawn(
                line.look_for if self._looks else line.look_away
            )

    def _go_on(self, now: float) -> None:
        """Begins the next line whose time is not over; stays where none is left."""
        n = len(self._lines)
        following = ((self._index + step) % n for step in range(1, n + 1))
        ahead = (index for index in following if self._lines[index].until > now)
        index = next(ahead, None)
        if index is not None:
            self._begin(index)
