"""Labels: where names go so that they cover neither each other nor bodies."""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled

GAP = 0.03
"""Between a body and its name [m]."""

PLACES = np.array(
    [
        [0.0, -1.0],
        [0.0, 1.0],
        [1.0, 0.0],
        [-1.0, 0.0],
        [1.0, -1.0],
        [-1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [0.0, -2.0],
        [0.0, 2.0],
        [1.0, -2.0],
        [-1.0, -2.0],
        [0.0, -3.0],
        [0.0, 3.0],
    ]
)
"""Where a name may be, best first: 1 is beside the body, 2 a line further away."""


class Box(NamedTuple):
    """An upright box.

    Attributes:
        x: Of its center [m].
        y: Of its center [m].
        width: Half of it [m].
        height: Half of it [m].
    """

    x: float
    y: float
    width: float
    height: float


@compiled
def place_labels(position: Floats, radius: Floats, size: Floats) -> Floats:
    """Places the names of everybody at several moments.

    A name stays where it was in the moment before as long as it is free there, so that
    it does not jump.

    Args:
        position: Of bodies, shape (n_moments, n, 2) [m].
        radius: Of bodies, shape (n,) [m].
        size: Width and height of names, shape (n, 2) [m].

    Returns:
        Centers of the names, shape (n_moments, n, 2) [m].
    """
    moments, n = position.shape[0], position.shape[1]
    centers = np.empty((moments, n, 2))
    before = np.zeros(n, np.int64)
    for t in range(moments):
        for i in range(n):
            best, least = 0, np.inf
            for k in range(-1, len(PLACES)):
                place = before[i] if k < 0 else k
                box = _box(position[t, i], radius[i], size[i], place)
                cost = _covered(box, i, position[t], radius, centers[t], size)
                if cost < least - 1e-9:
                    best, least = place, cost
                if least <= 0.0:
                    break
            before[i] = best
            box = _box(position[t, i], radius[i], size[i], best)
            centers[t, i, 0], centers[t, i, 1] = box.x, box.y
    return centers


@compiled
def _box(body: Floats, radius: float, size: Floats, place: int) -> Box:
    """The box of a name in one of its places."""
    width, height = size[0] / 2, size[1] / 2
    aside, along = PLACES[place, 0], PLACES[place, 1]
    x = body[0] + aside * (radius + GAP + width)
    near = radius + GAP + height + (abs(along) - 1.0) * size[1]
    y = body[1] + (near if along > 0.0 else -near if along < 0.0 else 0.0)
    return Box(x, y, width, height)


@compiled
def _covered(
    box: Box, i: int, position: Floats, radius: Floats, centers: Floats, size: Floats
) -> float:
    """Area of earlier names and of bodies that a name would cover [m2]."""
    total = 0.0
    for j in range(len(position)):
        body = Box(position[j, 0], position[j, 1], radius[j], radius[j])
        total += _overlap(box, body)
        if j < i:
            name = Box(centers[j, 0], centers[j, 1], size[j, 0] / 2, size[j, 1] / 2)
            total += 2.0 * _overlap(box, name)
    return total


@compiled
def _overlap(one: Box, other: Box) -> float:
    """Area that two boxes share [m2]."""
    across = one.width + other.width - abs(one.x - other.x)
    down = one.height + other.height - abs(one.y - other.y)
    return max(0.0, across) * max(0.0, down)
