"""Scripts: a timeline of places and of whom to attend to, over and over."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from household.people.mind import OWN_ACTIVITY
from household.state import Stateful

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


class Script(Stateful):
    """Where a person is in its script; `Routines` lets the time pass.

    Args:
        lines: At least one.
        rng: Draws how long each line and each look takes this time.

    Attributes:
        lasts: Time to be spent in the place of the present line [s].
        until: When the line ends at the latest [s].
        look_lasts: Time there until the person looks away, or back again [s].
    """

    STATE = ("_rng", "_index", "_looks", "lasts", "until", "look_lasts")

    def __init__(self, lines: Sequence[Line], rng: np.random.Generator) -> None:
        self._lines = lines
        self._rng = rng
        self._begin(0)

    def _begin(self, index: int) -> None:
        self._index = index
        self.lasts = self._drawn(self._line.duration)
        self.until = self._line.until
        self._looks = True
        self.look_lasts = self._drawn(self._line.look_for)

    def _drawn(self, times: Range) -> float:
        shortest, longest = times
        return shortest if shortest == longest else self._rng.uniform(*times)

    @property
    def _line(self) -> Line:
        """The line that is being played."""
        return self._lines[self._index]

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""
        return self._line.place

    @property
    def look(self) -> int:
        """Index of the entity that the script says to look at, or `OWN_ACTIVITY`."""
        return self._line.look if self._looks else OWN_ACTIVITY

    def turn_look(self) -> None:
        """Looks away for a while, or back again."""
        self._looks = not self._looks
        line = self._line
        self.look_lasts = self._drawn(line.look_for if self._looks else line.look_away)

    def go_on(self, now: float) -> None:
        """Begins the next line whose time is not over; stays where none is left.

        Args:
            now: Time since the episode began [s].
        """
        n = len(self._lines)
        following = ((self._index + step) % n for step in range(1, n + 1))
        ahead = (index for index in following if self._lines[index].until > now)
        index = next(ahead, None)
        if index is None:
            self.lasts = self.until = inf
        else:
            self._begin(index)
