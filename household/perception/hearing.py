"""Hearing: how loud everybody hears each, quieter with distance and with walls."""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.perception.obstruction import Obstructions

AUDIBLE = 40.0
"""Level at the ear from which a sound is noticed [dB]: a quiet room."""

NEAREST = 0.3
"""Distance below which a sound gets no louder [m]: an ear is not inside its source."""


class Acoustics(NamedTuple):
    """The constants of hearing.

    Attributes:
        wall_loss: What one wall takes from a sound [dB].
        silent: How many entities, from the first on, never make a sound.
    """

    wall_loss: float
    silent: int


@compiled
def attenuate(obstructions: Obstructions, acoustics: Acoustics, loss: Floats) -> None:
    """Brings up to date what sounds lose between those pairs of which one has moved.

    Args:
        obstructions: Of this moment.
        acoustics: The constants; nothing is worked out between two who are silent.
        loss: What a sound loses between each two, symmetric, shape (n, n) [dB];
            changed in place.
    """
    position, moved = obstructions.position, obstructions.moved
    n = len(position)
    for i in range(n):
        for j in range(max(i + 1, acoustics.silent), n):
            if moved[i] or moved[j]:
                through_walls = obstructions.crossed[i, j] * acoustics.wall_loss
                loss[i, j] = _spread(position, i, j) + through_walls
                loss[j, i] = loss[i, j]


@compiled
def _spread(position: Floats, i: int, j: int) -> float:
    """What a sound loses on its way between two entities without a wall [dB].

    A point source loses 6 dB for each doubling of the distance beyond 1 m.
    """
    dx = position[j, 0] - position[i, 0]
    dy = position[j, 1] - position[i, 1]
    return 20.0 * np.log10(max(np.sqrt(dx * dx + dy * dy), NEAREST))


@compiled
def hear(source: Floats, loss: Floats, level: Floats) -> None:
    """Works out how loud everybody hears each.

    Args:
        source: Sound level of each at 1 m, shape (n,) [dB].
        loss: From `attenuate`, shape (n, n) [dB].
        level: Filled in, at least 0, shape (n, n) [dB].
    """
    n = len(source)
    for i in range(n):
        for j in range(n):
            level[i, j] = max(source[j] - loss[i, j], 0.0)
