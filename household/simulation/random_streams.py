"""Random streams: one seed, one history; nobody's draws depend on who else is there."""

from collections.abc import Sequence
from typing import Literal

import numpy as np

from household.compiled.arrays import Floats
from household.state import Stateful

PEOPLE, ROBOTS, FACES, NOTICED = 0, 1, 2, 3

AHEAD = 64
"""Moments for which numbers are drawn at once: one by one, each takes a microsecond."""

AT_LEISURE = 4
"""Moments for which they are drawn where there is a little time to spare."""

Distribution = Literal["uniform", "normal"]


class Streams(Stateful):
    """Independent generators for each person and robot, anew in each episode.

    Attributes:
        people: One generator for each person.
        robots: One for each robot, for what it does.
        faces: One for each robot, for how it misreads faces.
        noticed: One for each person, for how inexactly robots notice what it does.
    """

    STATE = ("_entropy", "_episode", "robots")

    def __init__(self, n_people: int, n_robots: int) -> None:
        self._counts = (n_people, n_robots, n_robots, n_people)
        self._entropy: int | Sequence[int] | None = None
        self._episode = 0

    def begin(self, seed: int | None) -> None:
        """Begins an episode.

        Args:
            seed: Begins a history of its own; None goes on with the present one, so
                that episodes differ and yet can be repeated.
        """
        if seed is not None or self._entropy is None:
            self._entropy = np.random.SeedSequence(seed).entropy
            self._episode = 0
        else:
            self._episode += 1
        self.people = self._generators(PEOPLE)
        self.robots = self._generators(ROBOTS)
        self.faces = self._generators(FACES)
        self.noticed = self._generators(NOTICED)

    def _generators(self, kind: int) -> list[np.random.Generator]:
        keys = ((self._episode, kind, i) for i in range(self._counts[kind]))
        return [
            np.random.default_rng(np.random.SeedSequence(self._entropy, spawn_key=key))
            for key in keys
        ]


class Draws(Stateful):
    """The random numbers of several streams, as many from each at every moment.

    They are drawn whether anybody needs them or not, so that what happens in one
    moment shifts nobody's numbers in the next.

    Args:
        rngs: The streams.
        size: Numbers from each stream at each moment.
        distribution: "uniform" in [0, 1) or standard "normal".
    """

    STATE = ("_rngs", "_numbers", "_next", "_ready")

    def __init__(
        self,
        rngs: Sequence[np.random.Generator],
        size: int,
        distribution: Distribution = "uniform",
    ) -> None:
        self._rngs, self._distribution = list(rngs), distribution
        # A ring of moments: the numbers of the latest are followed by those to come.
        self._numbers = np.zeros((len(rngs), AHEAD, size))
        # Views, made once: they stay right as the numbers are always in one array.
        self._moments = [self._numbers[:, moment] for moment in range(AHEAD)]
        self._next = self._ready = 0

    def next(self) -> Floats:
        """The numbers of the next moment, shape (n_streams, size); for reading.

        They hold only until the next are asked for.
        """
        if not self._ready:
            self._draw(AHEAD)
        moment = self._moments[self._next]
        self._next = (self._next + 1) % AHEAD
        self._ready -= 1
        return moment

    def draw_ahead(self) -> bool:
        """Draws for a few more moments than needed by now; the numbers stay the same.

        Returns:
            Whether there was room for any.
        """
        if self._ready >= AHEAD - AT_LEISURE:  # The latest are still being read.
            return False
        self._draw(AT_LEISURE)
        return True

    def _draw(self, most: int) -> None:
        """Draws for so many moments, or until the end of the ring."""
        first = (self._next + self._ready) % AHEAD
        last = min(first + most, AHEAD)
        for rng, ahead in zip(self._rngs, self._numbers, strict=True):
            uniform = self._distribution == "uniform"
            draw = rng.random if uniform else rng.standard_normal
            draw(out=ahead[first:last])
        self._ready += last - first
