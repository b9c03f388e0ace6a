"""The space of a robot's actions."""

from typing import Any

import numpy as np
from gymnasium import spaces


class Actions(spaces.Discrete):
    """The behaviors that one robot can choose, each by its index.

    The same seed gives every robot samples of its own: else all would do the same.

    Args:
        n_behaviors: How many there are.
        robot: Index of the robot.
    """

    def __init__(self, n_behaviors: int, robot: int) -> None:
        self._robot = robot
        super().__init__(n_behaviors)

    def seed(self, seed: int | None = None) -> Any:  # noqa: ANN401 - as Gymnasium's own
        """Seeds the samples; those of the first robot are as a plain space gives them.

        Args:
            seed: A whole number from 0 up; None: from the system's entropy.

        Returns:
            The seed that was used.
        """
        if seed is None or self._robot == 0:
            return super().seed(seed)
        mixed = np.random.SeedSequence(seed, spawn_key=(self._robot,))
        return super().seed(int(mixed.generate_state(1, np.uint64)[0]))
