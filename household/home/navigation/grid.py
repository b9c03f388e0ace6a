"""The grid of free space: where a body fits, and what can be walked straight.

Where a cell is one number, it is its index in ``free.ravel()``.
"""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Mask
from household.compiled.jit import compiled
from household.config.toml import Point

Cells = NDArray[np.int32]
"""A whole number for each cell."""

CELL = 0.1
"""Edge of a grid cell [m]: a fifth of a body's width, so that doorways stay open."""

SAMPLES = 2.0
"""How many samples of a line are taken for each cell's length."""

STRIDE = 8
"""Along a line, every sample at this distance from the first is looked at first, then
each sample after those, and so on: most lines that are blocked are so soon."""

NOWHERE = -1
"""In place of a cell."""


class Grid(NamedTuple):
    """The free space of a home.

    Attributes:
        free: Whether a body fits in each cell, shape (width, height).
        parts: Label of the connected part of each cell, shape (width, height); the
            very first cell is outdoors.
        corner: Left and lower edge of the grid, shape (2,) [m].
    """

    free: Annotated[Mask, "width", "height"]
    parts: Annotated[Cells, "width", "height"]
    corner: Annotated[Floats, 2]


@compiled
def ends_of(grid: Grid, start: Point, goal: Point) -> tuple[int, int, Point]:
    """The cells where a walk begins and ends, and the point where it ends.

    Args:
        grid: The free space.
        start: Where it begins [m].
        goal: Where it should end [m]; where no body fits, it ends at the middle of
            the nearest cell where one does.

    Returns:
        The first cell and the last, the same for a walk straight there, `NOWHERE`
        for none; and the point where it ends [m].
    """
    free, corner = grid.free, grid.corner
    a, b = _indoors(grid, start), _indoors(grid, goal)
    if b != cell_of(free, corner, goal):
        goal = corner[0] + (b[0] + 0.5) * CELL, corner[1] + (b[1] + 0.5) * CELL
    if grid.parts[a] != grid.parts[b]:
        return NOWHERE, NOWHERE, goal
    last = b[0] * free.shape[1] + b[1]
    if line_is_free(free, in_cells(corner, start), in_cells(corner, goal)):
        return last, last, goal
    return a[0] * free.shape[1] + a[1], last, goal


@compiled
def leads_to(grid: Grid, start: Point, goal: Point) -> bool:
    """Whether a walk leads from one point to the other, or near it, as in `ends_of`."""
    return grid.parts[_indoors(grid, start)] == grid.parts[_indoors(grid, goal)]


@compiled
def in_cells(corner: Floats, point: Point) -> Point:
    """A point [m] in cells from the grid's corner."""
    return (point[0] - corner[0]) / CELL, (point[1] - corner[1]) / CELL


@compiled
def cell_of(free: Mask, corner: Floats, point: Point) -> tuple[int, int]:
    """Column and row of the cell that holds a point [m], clipped to the grid."""
    x, y = in_cells(corner, point)
    return (
        min(max(int(x), 0), free.shape[0] - 1),
        min(max(int(y), 0), free.shape[1] - 1),
    )


@compiled
def _indoors(grid: Grid, point: Point) -> tuple[int, int]:
    """The cell that holds a point [m], or else the nearest one where a body fits."""
    cell = cell_of(grid.free, grid.corner, point)
    return cell if _is_indoors(grid, cell) else _nearest(grid, point)


@compiled
def _is_indoors(grid: Grid, cell: tuple[int, int]) -> bool:
    """Whether a body fits in a cell, and the walls close it off from outside."""
    return grid.free[cell] and grid.parts[cell] != grid.parts[0, 0]


@compiled
def _nearest(grid: Grid, point: Point) -> tuple[int, int]:
    """The indoor cell whose middle is nearest to a point, the first of several.

    Looks round the point in ever larger squares, until nothing outside can be nearer.
    """
    free = grid.free
    x, y = in_cells(grid.corner, point)
    a, b = cell_of(free, grid.corner, point)
    best, least = (a, b), np.inf
    for ring in range(max(free.shape)):
        if (ring - 1.0) ** 2 > least:
            break
        for i in range(max(a - ring, 0), min(a + ring + 1, free.shape[0])):
            step = 1 if abs(i - a) == ring else max(2 * ring, 1)
            for j in range(b - ring, b + ring + 1, step):
                if 0 <= j < free.shape[1] and _is_indoors(grid, (i, j)):
                    away = (i + 0.5 - x) ** 2 + (j + 0.5 - y) ** 2
                    if away < least or (away == least and (i, j) < best):
                        best, least = (i, j), away
    return best


@compiled
def line_is_free(free: Mask, start: Point, end: Point) -> bool:
    """Whether every cell along a line is free.

    Args:
        free: As in `Grid`, shape (width, height).
        start: In cells from the grid's corner.
        end: In cells from the grid's corner.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    steps = int(np.sqrt(dx * dx + dy * dy) * SAMPLES) + 1
    # In strides: the strip that a wall blocks is rarely missed by the first samples.
    for first in range(STRIDE):
        for step in range(first, steps + 1, STRIDE):
            x = int(np.floor(start[0] + dx * step / steps))
            y = int(np.floor(start[1] + dy * step / steps))
            if x < 0 or y < 0 or x >= free.shape[0] or y >= free.shape[1]:
                return False
            if not free[x, y]:
                return False
    return True
