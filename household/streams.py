"""Random streams: one seed, one history; nobody's draws depend on who else is there."""

from collections.abc import Sequence

import numpy as np

PEOPLE, ROBOTS = 0, 1


class Streams:
    """Independent generators for each person and robot, anew in each episode.

    Attributes:
        people: One generator for each person.
        robots: One for each robot.
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

    def _generators(self, kind: int) -> list[np.random.Generator]:
        keys = ((self._episode, kind, index) for index in range(self._counts[kind]))
        return [
            np.random.default_rng(np.random.SeedSequence(self._entropy, spawn_key=key))
            for key in keys
        ]
