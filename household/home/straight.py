"""Ways on the grid of free space, compiled: shortest ones, and pulled straight.

Where a cell is one number, it is its index in ``free.ravel()``.
"""

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled
from household.records import Point

Array = NDArray[np.float64]
Grid = NDArray[np.bool_]
Cells = NDArray[np.int32]

CELL = 0.1
"""Edge of a grid cell [m]; a third of a body's width keeps doorways open."""

SAMPLES = 2.0
"""Samples for each cell's length along a line."""

STRAIGHT, DIAGONAL = 12, 17
"""Lengths of steps to neighboring cells: whole numbers, so that cells are found in
order of distance without a heap; their ratio is the square root of 2 to 0.2 %."""

BUCKETS = 32
"""More than `DIAGONAL`, for all distances that can be waiting; a power of two, for
which a remainder is cheap."""

NOWHERE = -1
"""Where no way goes on."""

FAR, CLOSED = np.iinfo(np.int32).max, -1
"""Distance of cells not yet found, and of those that no way may lead through."""


@compiled
def ends_of(
    free: Grid, parts: Cells, corner: Point, start: Point, goal: Point
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
def in_cells(corner: Point, point: Point) -> Point:
    """A point [m] in cells from the grid's corner."""
    return (point[0] - corner[0]) / CELL, (point[1] - corner[1]) / CELL


@compiled
def cell_of(free: Grid, corner: Point, point: Point) -> tuple[int, int]:
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
def _nearest(free: Grid, parts: Cells, corner: Point, point: Point) -> tuple[int, int]:
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
def onward_to(untrodden: Cells, goal: int, start: int) -> Cells:
    """Shortest ways to a cell (Dijkstra's, with Dial's buckets).

    The search ends once the way from ``start`` is known, and with it all ways that are
    no longer. They are the same however far a search goes.

    Args:
        untrodden: `FAR` for each cell where ways may lead, none of them at the edge
            of the grid, and `CLOSED` for all others, shape (width, height).
        goal: A cell.
        start: A cell from which a way leads there.

    Returns:
        For each cell the next one on its way, `NOWHERE` at the goal and where the way
        is not known, shape (width * height,).
    """
    height = untrodden.shape[1]
    away = untrodden.copy().ravel()  # As far as found.
    onward = np.full(away.size, NOWHERE, np.int32)
    # A bucket for each distance that can be waiting, in each a list of entries: a
    # cell, the next one on its way and the entry that follows in the bucket. A cell
    # comes in twice at most, over a diagonal and then over a shorter, straight step.
    bucket = np.full(BUCKETS, NOWHERE, np.int32)
    cells, nexts, followers = np.empty((3, 2 * away.size), np.int32)
    cells[0], nexts[0], followers[0] = goal, NOWHERE, NOWHERE
    away[goal], bucket[0], entries, distance = 0, 0, 1, 0
    while away[start] >= distance:
        entry = bucket[distance % BUCKETS]
        bucket[distance % BUCKETS] = NOWHERE
        while entry != NOWHERE:
            cell, onto, entry = cells[entry], nexts[entry], followers[entry]
            if away[cell] < distance:
                continue
            onward[cell] = onto
            for dx in range(-1, 2):
                for dy in range(-1, 2):
                    there = cell + dx * height + dy
                    reached = distance + (DIAGONAL if dx and dy else STRAIGHT)
                    if reached < away[there]:
                        k = reached % BUCKETS
                        cells[entries], nexts[entries] = there, cell
                        followers[entries], bucket[k] = bucket[k], entries
                        away[there], entries = reached, entries + 1
        distance += 1
    return onward


@compiled
def turning_way(
    free: Grid, onward: Cells, corner: Point, first: int, end: Point
) -> list[Point]:
    """A shortest way pulled straight: one walks straight between its points.

    Args:
        free: The grid, shape (width, height).
        onward: From `onward_to`.
        corner: Of the grid [m].
        first: The cell where the way begins.
        end: Where it ends, in the last cell [m].

    Returns:
        The points where it turns, and its end [m].
    """
    middles = _middles(onward, first, free.shape[1])
    goal, last = in_cells(corner, end), len(middles) - 1
    way: list[Point] = []
    here = 0
    while here < last:
        start = (middles[here, 0], middles[here, 1])
        if line_is_free(free, start, goal):
            break
        there = last
        while there > here + 1:
            if line_is_free(free, start, (middles[there, 0], middles[there, 1])):
                break
            there -= 1
        x, y = middles[there, 0], middles[there, 1]
        way.append((corner[0] + x * CELL, corner[1] + y * CELL))
        here = there
    way.append(end)
    return way


@compiled
def _middles(onward: Cells, first: int, height: int) -> Array:
    """Middles of the cells on a way, shape (n, 2), in cells from the grid's corner."""
    count, here = 0, first
    while here != NOWHERE:
        count, here = count + 1, onward[here]
    middles, here = np.empty((count, 2)), first
    for k in range(count):
        middles[k, 0], middles[k, 1] = here // height + 0.5, here % height + 0.5
        here = onward[here]
    return middles


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
    for step in range(steps + 1):
        x = int(np.floor(start[0] + dx * step / steps))
        y = int(np.floor(start[1] + dy * step / steps))
        if x < 0 or y < 0 or x >= free.shape[0] or y >= free.shape[1]:
            return False
        if not free[x, y]:
            return False
    return True
