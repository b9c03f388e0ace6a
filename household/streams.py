"""Random streams: one seed, one history; nobody's draws depend on who else is there."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

PEOPLE, ROBOTS, FACES = 0, 1, 2

AHEAD = 64
"""Moments for which numbers are drawn at once: one by one, each takes a microsecond."""

Distribution = Literal["uniform", "normal"]


class Streams:
    """Independent generators for each person and robot, anew in each episode.

    Attributes:
        people: One generator for each person.
        robots: One for each robot, for what it does.
        faces: One for each robot, for how it misreads faces.
    """

    def __init__(self, n_people: int, n_robots: int) -> None:
        self._counts = (n_people, n_robots)
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

    def _generators(self, kind: int) -> list[np.random.Generator]:
        count = self._counts[min(kind, ROBOTS)]
        keys = ((self._episode, kind, index) for index in range(count))
        return [
            np.random.default_rng(np.random.SeedSequence(self._entropy, spawn_key=key))
            for key in keys
        ]


class Draws:
    """The random numbers of several streams, as many from each at every moment.

    They are drawn whether anybody needs them or not, so that what happens in one
    moment shifts nobody's numbers in the next.

    Args:
        rngs: The streams.
        size: Numbers from each stream at each moment.
        distribution: "uniform" in [0, 1) or standard "normal".
    """

    def __init__(
        self,
        rngs: Sequence[np.random.Generator],
        size: int,
        distribution: Distribution = "uniform",
    ) -> None:
        self._rngs = rngs
        self._distribution = distribution
        self._numbers = np.empty((AHEAD, len(rngs), size))
        self._next = AHEAD

    def next(self) -> NDArray[np.float64]:
        """The numbers of the next moment, shape (n_streams, size); for reading only."""
        if self._next == AHEAD:
            self._draw_ahead()
        self._next += 1
        return self._numbers[self._next - 1]

    def _draw_ahead(self) -> None:
        shape = (len(self._numbers), self._numbers.shape[2])
        for stream, rng in enumerate(self._rngs):
            uniform = self._distribution == "uniform"
            draw = rng.random if uniform else rng.standard_normal
            self._numbers[:, stream] = draw(shape)
        self._next = 0
