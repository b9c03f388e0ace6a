"""The grid of free space: where a body fits, and what is in a straight line.

Where a cell is one number, it is its index in ``free.ravel()``.
"""

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.config.toml import Point

Grid = NDArray[np.bool_]
Cells = NDArray[np.int32]

CELL = 0.1
"""Edge of a grid cell [m]; a third of a body's width keeps doorways open."""

SAMPLES = 2.0
"""Samples for each cell's length along a line."""

STRIDE = 8
"""Every so many of them are looked at first, then those after them, and so on."""

NOWHERE = -1
"""In place of a cell."""


@compiled
def ends_of(
    free: Grid, parts: Cells, corner: Floats, start: Point, goal: Point
) -> tuple[int, int, Point]:
    """Where a walk begins and ends.

    Args:
        free: The grid, shape (width, height).
        parts: Label of the connected part of each cell, shape (width, height); the
            very first is outdoors.
        corner: Of the grid [m].
        start: Where it begins [m].
        goal: Where it should end [m]; where no body fits, it ends at the middle of
            the nearest cell where one does.

    Returns:
        The first cell and the last, the same for a walk straight there, `NOWHERE`
        for none; and the point where it ends [m].
    """
    a, b = cell_of(free, corner, start), cell_of(free, corner, goal)
    if not _is_indoors(free, parts, a):
        a = _nearest(free, parts, corner, start)
    if not _is_indoors(free, parts, b):
        b = _nearest(free, parts, corner, goal)
        goal = corner[0] + (b[0] + 0.5) * CELL, corner[1] + (b[1] + 0.5) * CELL
    if parts[a] != parts[b]:
        return NOWHERE, NOWHERE, goal
    last = b[0] * free.shape[1] + b[1]
    if line_is_free(free, in_cells(corner, start), in_cells(corner, goal)):
        return last, last, goal
    return a[0] * free.shape[1] + a[1], last, goal


@compiled
def in_cells(corner: Floats, point: Point) -> Point:
    """A point [m] in cells from the grid's corner."""
    return (point[0] - corner[0]) / CELL, (point[1] - corner[1]) / CELL


@compiled
def cell_of(free: Grid, corner: Floats, point: Point) -> tuple[int, int]:
    """Column and row of the cell that holds a point [m], clipped to the grid."""
    x, y = in_cells(corner, point)
    return (
        min(max(int(x), 0), free.shape[0] - 1),
        min(max(int(y), 0), free.shape[1] - 1),
    )


@compiled
def _is_indoors(free: Grid, parts: Cells, cell: tuple[int, int]) -> bool:
    """Whether a body fits in a cell that the walls close off from outside."""
    return free[cell] and parts[cell] != parts[0, 0]


@compiled
def _nearest(free: Grid, parts: Cells, corner: Floats, point: Point) -> tuple[int, int]:
    """The indoor cell whose middle is nearest to a point, the first of several.

    Looks round the point in ever larger squares, until nothing outside can be nearer.
    """
    x, y = in_cells(corner, point)
    a, b = cell_of(free, corner, point)
    best, least = (a, b), np.inf
    for ring in range(max(free.shape)):
        if (ring - 1.0) ** 2 > least:
            break
        for i in range(max(a - ring, 0), min(a + ring + 1, free.shape[0])):
            step = 1 if abs(i - a) == ring else max(2 * ring, 1)
            for j in range(b - ring, b + ring + 1, step):
                if 0 <= j < free.shape[1] and _is_indoors(free, parts, (i, j)):
                    away = (i + 0.5 - x) ** 2 + (j + 0.5 - y) ** 2
                    if away < least or (away == least and (i, j) < best):
                        best, least = (i, j), away
    return best


@compiled
def line_is_free(free: Grid, start: Point, end: Point) -> bool:
    """Whether every cell along a line is free.

    Args:
        free: The grid, shape (width, height).
        start: In cells from the grid's corner.
        end: In cells from the grid's corner.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    steps = int(np.sqrt(dx * dx + dy * dy) * SAMPLES) + 1
    # First in strides: a wall with a body's radius on either side hardly hides between.
    for first in range(STRIDE):
        for step in range(first, steps + 1, STRIDE):
            x = int(np.floor(start[0] + dx * step / steps))
            y = int(np.floor(start[1] + dy * step / steps))
            if x < 0 or y < 0 or x >= free.shape[0] or y >= free.shape[1]:
                return False
            if not free[x, y]:
                return False
    return True
