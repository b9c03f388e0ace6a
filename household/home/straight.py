"""Ways on the grid of free space, compiled: shortest ones, and pulled straight."""

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled

SAMPLES = 2.0
"""Samples for each cell's length along a line."""

STRAIGHT, DIAGONAL = 12, 17
"""Lengths of steps to neighboring cells: whole numbers, so that cells are found in
order of distance without a heap; their ratio is the square root of 2 to 0.2 %."""

NOWHERE = -1
"""Where no way goes on."""


@compiled
def onward_to(free: NDArray[np.bool_], goal: int) -> NDArray[np.int32]:
    """Shortest ways from everywhere to one cell (Dijkstra's, with Dial's buckets).

    Args:
        free: The grid, shape (width, height).
        goal: Index of a cell, in the order of ``free.ravel()``.

    Returns:
        For each cell the next one on its way, `NOWHERE` at the goal and where there
        is no way, shape (width * height,).
    """
    width, height = free.shape
    onward = np.full(free.size, NOWHERE, np.int32)
    away = np.full(free.size, np.iinfo(np.int32).max, np.int32)
    # A bucket for each distance that can be waiting; in each a list of entries.
    first = np.full(DIAGONAL + 1, NOWHERE, np.int32)
    following = np.empty(8 * free.size + 1, np.int32)
    cell_of = np.empty(8 * free.size + 1, np.int32)
    away[goal], first[0], following[0], cell_of[0] = 0, 0, NOWHERE, goal
    entries, waiting, distance = 1, 1, 0
    while waiting > 0:
        entry = first[distance % len(first)]
        first[distance % len(first)] = NOWHERE
        while entry != NOWHERE:
            cell, entry = cell_of[entry], following[entry]
            waiting -= 1
            if away[cell] < distance:
                continue
            x, y = cell // height, cell % height
            for dx in range(-1, 2):
                for dy in range(-1, 2):
                    i, j = x + dx, y + dy
                    if not (0 <= i < width and 0 <= j < height and free[i, j]):
                        continue
                    there = i * height + j
                    reached = distance + (DIAGONAL if dx and dy else STRAIGHT)
                    if reached < away[there]:
                        away[there], onward[there] = reached, cell
                        bucket = reached % len(first)
                        cell_of[entries], following[entries] = there, first[bucket]
                        first[bucket] = entries
                        entries += 1
                        waiting += 1
        distance += 1
    return onward


@compiled
def cells_between(
    onward: NDArray[np.int32], first: int, height: int, end: tuple[float, float]
) -> NDArray[np.float64]:
    """Middles of the cells on a way, and the point where it ends.

    Args:
        onward: From `onward_to`.
        first: Index of the cell where the way begins.
        height: Of the grid, in cells.
        end: In the last of the cells, in cells from the grid's corner.

    Returns:
        Shape (n, 2), in cells from the grid's corner.
    """
    count, here = 1, onward[first]
    while here != NOWHERE:
        count, here = count + 1, onward[here]
    points, here = np.empty((count + 1, 2)), np.int32(first)
    points[count, 0], points[count, 1] = end
    for k in range(count):
        points[k, 0], points[k, 1] = here // height + 0.5, here % height + 0.5
        here = onward[here]
    return points


@compiled
def nearest(points: NDArray[np.float64], point: tuple[float, float]) -> int:
    """Index of the point that is nearest to another.

    Args:
        points: Shape (n, 2).
        point: The other.
    """
    best, least = 0, np.inf
    for i in range(len(points)):
        dx, dy = points[i, 0] - point[0], points[i, 1] - point[1]
        if dx * dx + dy * dy < least:
            best, least = i, dx * dx + dy * dy
    return best


@compiled
def line_is_free(
    free: NDArray[np.bool_], start: tuple[float, float], end: tuple[float, float]
) -> bool:
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


@compiled
def turning_points(
    free: NDArray[np.bool_], points: NDArray[np.float64]
) -> NDArray[np.int64]:
    """The points of a path at which one must turn; between them one walks straight.

    Args:
        free: The grid, shape (width, height).
        points: The path from cell to neighboring cell, shape (n, 2), in cells.

    Returns:
        Indices of the points that are kept, the last one always, the first never.
    """
    n = points.shape[0]
    kept = np.empty(n, np.int64)
    count, here = 0, 0
    while here < n - 1:
        there = n - 1
        start = (points[here, 0], points[here, 1])
        while there > here + 1:
            if line_is_free(free, start, (points[there, 0], points[there, 1])):
                break
            there -= 1
        kept[count] = there
        count += 1
        here = there
    return kept[:count]
