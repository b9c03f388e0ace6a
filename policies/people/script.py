"""Scripts: a timeline of places and of whom to attend to, over and over."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from household.people.mind import OWN_ACTIVITY


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a script.

    Attributes:
        place: Index of the activity region to be in.
        look: Index of the entity to attend to, or `OWN_ACTIVITY`.
        duration: Shortest and longest time to be there [s].
    """

    place: int
    look: int = OWN_ACTIVITY
    duration: tuple[float, float] = (10.0, 10.0)


class Script:
    """Where a person is in its script.

    Args:
        lines: At least one.
        rng: Draws how long each line takes this time.
    """

    def __init__(self, lines: Sequence[Line], rng: np.random.Generator) -> None:
        self._lines = lines
        self._rng = rng
        self._index = 0
        self._left = self._drawn()

    def _drawn(self) -> float:
        return float(self._rng.uniform(*self.line.duration))

    @property
    def line(self) -> Line:
        """The line that is being played."""
        return self._lines[self._index]

    def play(self, period: float) -> None:
        """Lets time pass in the place of the line; goes on to the next when it is up.

        Args:
            period: Time that was spent there [s].
        """
        self._left -= period
        if self._left <= 0.0:
            self._index = (self._index + 1) % len(self._lines)
            self._left = self._drawn()
