"""Labels: where names go so that they cover neither each other nor bodies."""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled, compiled_aside

GAP = 0.03
"""Between a body and its name [m]."""

RINGS = 4
"""How many lines away from its body a name may be."""

ASIDE = 0.6
"""How much further away a name is that is shifted by half its width, in lines."""

PLACES = np.array(
    sorted(
        [
            (aside, sign * line)
            for line in range(1, RINGS + 1)
            for sign in (-1.0, 1.0)
            for aside in (0.0, 1.0, -1.0, 2.0, -2.0)
        ]
        + [(1.0, 0.0), (-1.0, 0.0)],
        key=lambda place: (abs(place[1]) or 0.5) + ASIDE * abs(place[0]),
    )
)
"""Where a name may be, best first: 1 is beside the body, 2 a line or half a name
further away."""

FAR, LOYAL = 0.02, 0.3
"""What each place costs more than the one before it, and what leaving a place costs, as
shares of the name that would be covered."""


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


class Drawn(NamedTuple):
    """What is drawn at a moment.

    Attributes:
        position: Of bodies, shape (n, 2) [m].
        radius: Of bodies, shape (n,) [m].
        size: Width and height of names, shape (n, 2) [m].
        bounds: Of the drawing: left, bottom, right, top [m].
    """

    position: Floats
    radius: Floats
    size: Floats
    bounds: Floats


@compiled_aside
def place_labels(
    position: Floats, radius: Floats, size: Floats, bounds: Floats
) -> Floats:
    """Places the names of everybody at several moments.

    A name stays where it was in the moment before as long as nothing else is much
    better, so that it does not jump.

    Args:
        position: Of bodies, shape (n_moments, n, 2) [m].
        radius: Of bodies, shape (n,) [m].
        size: Width and height of names, shape (n_moments, n, 2) [m].
        bounds: Of the drawing: left, bottom, right, top [m].

    Returns:
        Centers of the names, shape (n_moments, n, 2) [m].
    """
    moments, n = position.shape[0], position.shape[1]
    centers = np.empty((moments, n, 2))
    before = np.full(n, -1, np.int64)
    for t in range(moments):
        drawn = Drawn(position[t], radius, size[t], bounds)
        for i in range(n):
            whole = size[t, i, 0] * size[t, i, 1]
            best, least, leaving = 0, np.inf, 0.0
            if before[i] >= 0:  # First, since hardly any other is better.
                best, leaving = before[i], LOYAL * whole
                least = FAR * best * whole + _cost(i, best, drawn, centers[t])
            for k in range(len(PLACES)):
                cost = FAR * k * whole + leaving
                if cost >= least:
                    break  # Those that follow cost more.
                if k != before[i]:
                    cost += _cost(i, k, drawn, centers[t])
                    if cost < least:
                        best, least = k, cost
            before[i] = best
            box = _box(i, best, drawn)
            centers[t, i, 0], centers[t, i, 1] = box.x, box.y
    return centers


@compiled
def _cost(i: int, place: int, drawn: Drawn, centers: Floats) -> float:
    """What it costs to have a name in a place: what would be covered, or be outside."""
    box = _box(i, place, drawn)
    return 4.0 * _outside(box, drawn.bounds) + _covered(box, i, drawn, centers)


@compiled
def _box(i: int, place: int, drawn: Drawn) -> Box:
    """The box of a name in one of its places."""
    body, radius, size = drawn.position[i], drawn.radius[i], drawn.size[i]
    width, height = size[0] / 2, size[1] / 2
    aside, along = PLACES[place, 0], PLACES[place, 1]
    # Beside the body a name is clear of it; above and below it may be shifted half.
    reach = radius + GAP + width if along == 0.0 else width
    x = body[0] + aside * reach
    near = radius + GAP + height + (abs(along) - 1.0) * size[1]
    y = body[1] + (near if along > 0.0 else -near if along < 0.0 else 0.0)
    return Box(x, y, width, height)


@compiled
def _outside(box: Box, bounds: Floats) -> float:
    """Area of a name that is not on the drawing [m2]."""
    wide = min(box.x + box.width, bounds[2]) - max(box.x - box.width, bounds[0])
    high = min(box.y + box.height, bounds[3]) - max(box.y - box.height, bounds[1])
    return 4.0 * box.width * box.height - max(0.0, wide) * max(0.0, high)


@compiled
def _covered(box: Box, i: int, drawn: Drawn, centers: Floats) -> float:
    """Area of earlier names, which weigh more, and of bodies that are covered [m2]."""
    position, radius, size = drawn.position, drawn.radius, drawn.size
    total = 0.0
    for j in range(len(position)):
        body = Box(position[j, 0], position[j, 1], radius[j], radius[j])
        total += _overlap(box, body)
        if j < i:
            name = Box(centers[j, 0], centers[j, 1], size[j, 0] / 2, size[j, 1] / 2)
            covered = _overlap(box, name)
            if covered > 0.0:
                total += 8.0 * covered + 8.0 * box.width * box.height
    return total


@compiled
def _overlap(one: Box, other: Box) -> float:
    """Area that two boxes share [m2]."""
    across = one.width + other.width - abs(one.x - other.x)
    down = one.height + other.height - abs(one.y - other.y)
    return max(0.0, across) * max(0.0, down)
