"""Senses: who sees, hears and attends to whom at this moment."""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Mask, Zeros, new_zeros
from household.compiled.jit import FLOAT, FLOATS, FLOATS_2D, bind
from household.home.floorplan import FloorPlan
from household.perception import kernel
from household.scenario.scenario import PerceptionModel
from household.state import Stateful

BATCH = 16
"""So many segments the processor looks at in one go; the rest it takes one by one."""


class Beings(NamedTuple):
    """Everybody, as all others perceive it and as it perceives them.

    Attributes:
        position: Shape (n, 2) [m].
        gaze: Where each head points, shape (n,) [rad].
        half_view: Half the field of view, (n,) [rad]; negative: eyes closed.
        salience: How strongly each draws the eye, shape (n,).
        absorption: What each one's activity holds back, shape (n,).
        source: Sound level of each at 1 m, shape (n,) [dB].
    """

    position: Floats
    gaze: Floats
    half_view: Floats
    salience: Floats
    absorption: Floats
    source: Floats


class Senses(Stateful):
    """What everybody perceives; people come first and robots after them.

    Args:
        plan: The home.
        model: How well everybody perceives.
        n: How many there are.
        silent: So many of the first never make a sound.
        zeros: Makes the arrays that others see: `attention` and `attends`.

    The arrays are the same from moment to moment, with new values in them.

    Attributes:
        walls: That can stand between two, and closed doors, shape (4, m), columns of
            x1, y1, x2, y2 [m]; the last ones may be NaN.
        sees: ``sees[i, j]``: i sees j, shape (n, n).
        facing: Cosine of the angle between the gaze of i and the direction to j,
            shape (n, n).
        attention: The attention matrix, shape (n, n); rows are observers and sum to
            less than 1.
        attends: ``attends[i, j]``: i attends to j, with hysteresis, shape (n, n).
        attention_began: Since when i attends to j [s], NaN if it does not, (n, n).
        loss: What a sound loses on its way from j to i, shape (n, n) [dB]; infinite
            where both never make one.
        level: How loud i hears j, shape (n, n) [dB], at least 0.
    """

    STATE = (
        "_position",
        "_parted",
        "sees",
        "facing",
        "attention",
        "attends",
        "attention_began",
        "loss",
        "level",
    )

    def __init__(
        self,
        plan: FloorPlan,
        model: PerceptionModel,
        n: int,
        silent: int = 0,
        zeros: Zeros = new_zeros,
    ) -> None:
        self.walls = _columns(plan.parting_walls)
        self._position = np.zeros((n, 2))
        # How many walls and how much furniture part two, while none of them moves.
        self._parted = np.zeros((n, n), dtype=np.int64)
        self.sees = np.zeros((n, n), dtype=np.bool_)
        self.facing = np.ones((n, n))
        self.attention: Floats = zeros("attention", (n, n))
        self.attends: Mask = zeros("attends", (n, n), np.bool_)
        self.attention_began = np.full((n, n), np.nan)
        self.loss = np.full((n, n), np.inf)
        self.level = np.zeros((n, n))
        self._perceive = bind(
            kernel.perceive,
            self.walls,
            _columns(plan.tall_diagonals),
            model.wall_loss,
            silent,
            np.deg2rad(model.focus),
            model.distance,
            model.attend_above,
            model.attend_below,
            self._position,
            self._parted,
            self.loss,
            self.sees,
            self.facing,
            self.attention,
            self.level,
            self.attends,
            self.attention_began,
            then=(FLOATS_2D, *[FLOATS] * 5, FLOAT),
        )

    def forget(self) -> None:
        """Begins a new episode: nobody has perceived anything yet."""
        self._position[:] = np.nan  # Everybody has moved.
        self.sees[:] = self.attends[:] = False
        self.attention[:] = self.level[:] = 0.0
        self.attention_began[:] = np.nan

    def perceive(self, beings: Beings, now: float) -> bool:
        """Perceives this moment.

        Args:
            beings: Everybody.
            now: [s].

        Returns:
            Whether anybody attends to others than before.
        """
        return self._perceive(*beings, now)


def _columns(segments: Floats) -> Floats:
    """Segments as columns, filled up to full batches with NaN, which no line crosses.

    Args:
        segments: Shape (m, 4) [m].

    Returns:
        Shape (4, at least m).
    """
    columns = np.full((4, -(-len(segments) // BATCH) * BATCH), np.nan)
    columns[:, : len(segments)] = segments.T
    return columns
