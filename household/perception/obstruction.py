"""Obstruction: what stands between two entities, in the way of sight and of sound.

Plain loops, compiled, because asking the physics engine for every line of sight would
cost more than the rest of a step (docs/performance.md).
"""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers, Mask
from household.compiled.jit import compiled


class Barriers(NamedTuple):
    """What can stand between entities.

    Attributes:
        walls: Segments that block sight and dampen sound, shape (4, n_walls), columns
            of x1, y1, x2, y2 [m].
        tall: Diagonals of furniture that blocks sight alone, shape (4, n_tall) [m].
    """

    walls: Annotated[Floats, 4, "n_walls"]
    tall: Annotated[Floats, 4, "n_tall"]


class Obstructions(NamedTuple):
    """What stands between each two.

    Attributes:
        position: Where everybody was at the last update, shape (n, 2) [m].
        moved: Who had moved since the update before that, shape (n,).
        crossed: How many walls stand between each two, shape (n, n).
        hidden: Whether anything hides them from each other, shape (n, n).
    """

    position: Annotated[Floats, "n", 2]
    moved: Annotated[Mask, "n"]
    crossed: Annotated[Integers, "n", "n"]
    hidden: Annotated[Mask, "n", "n"]


@compiled
def between(position: Floats, i: int, j: int, columns: Floats) -> int:
    """How many segments stand between two entities, as `crosses` defines it.

    Args:
        position: Shape (n, 2) [m].
        i: Index of one of them.
        j: Index of the other.
        columns: The segments, shape (4, m), columns of x1, y1, x2, y2 [m].
    """
    ends, count, asked = np.empty((2, 2)), np.zeros(2, np.int32), np.ones(2, np.bool_)
    ends[0], ends[1] = position[i], position[j]
    _count_between(ends, 0, columns, _sides(ends, columns), asked, count)
    return int(count[1])


@compiled
def update_obstructions(
    obstructions: Obstructions, barriers: Barriers, position: Floats
) -> None:
    """Brings up to date what stands between those pairs of which one has moved.

    Args:
        obstructions: Changed in place.
        barriers: Of the home.
        position: Where everybody is now, shape (n, 2) [m].
    """
    n, moved = len(position), obstructions.moved
    crossed, hidden = obstructions.crossed, obstructions.hidden
    gone = obstructions.position != position
    moved[:] = gone[:, 0] | gone[:, 1]
    wall_sides = _sides(position, barriers.walls)
    tall_sides = _sides(position, barriers.tall)
    asked, found = np.zeros(n, np.bool_), np.zeros(n, np.int32)
    for i in range(n):
        for j in range(i + 1, n):
            asked[j] = moved[i] or moved[j]
        asked[i] = False
        _count_between(position, i, barriers.walls, wall_sides, asked, found)
        for j in range(i + 1, n):
            if asked[j]:
                crossed[i, j] = crossed[j, i] = found[j]
                hidden[i, j] = hidden[j, i] = found[j] > 0
                asked[j] = found[j] == 0
        # Tall furniture matters only where no wall hides already.
        _count_between(position, i, barriers.tall, tall_sides, asked, found)
        for j in range(i + 1, n):
            if asked[j]:
                hidden[i, j] = hidden[j, i] = found[j] > 0
    obstructions.position[:] = position


@compiled
def _sides(position: Floats, columns: Floats) -> Floats:
    """On which side of each segment each entity is, by the sign, shape (n, m)."""
    x1, y1, x2, y2 = columns[0], columns[1], columns[2], columns[3]
    sides = np.empty((len(position), columns.shape[1]))
    for i in range(len(position)):
        x, y = position[i]
        for k in range(columns.shape[1]):
            ex, ey = x2[k] - x1[k], y2[k] - y1[k]
            sides[i, k] = ex * (y - y1[k]) - ey * (x - x1[k])
    return sides


@compiled
def _count_between(
    position: Floats,
    i: int,
    columns: Floats,
    sides: Floats,
    asked: Mask,
    count: NDArray[np.int32],
) -> None:
    """Counts the segments between one entity and each of those that are asked for.

    Without a branch, with each coordinate of all segments in a row of its own, and with
    a small number to count in, the processor looks at many segments at once.
    """
    ax, ay = position[i, 0], position[i, 1]
    for j in range(len(position)):
        if asked[j]:
            dx, dy = position[j, 0] - ax, position[j, 1] - ay
            found = np.int32(0)
            for k in range(columns.shape[1]):
                side1 = dx * (columns[1, k] - ay) - dy * (columns[0, k] - ax)
                side2 = dx * (columns[3, k] - ay) - dy * (columns[2, k] - ax)
                apart = (side1 * side2 <= 0.0) & (side1 != side2)
                found += np.int32(apart & (sides[i, k] * sides[j, k] <= 0.0))
            count[j] = found
