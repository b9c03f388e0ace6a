"""Straight lines on the grid of free space, compiled: a route needs hundreds."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

SAMPLES = 2.0
"""Samples for each cell's length along a line."""


@njit(cache=True)
def line_is_free(
    free: NDArray[np.bool_], start: NDArray[np.float64], end: NDArray[np.float64]
) -> bool:
    """Whether every cell along a line is free.

    Args:
        free: The grid, shape (width, height).
        start: Shape (2,), in cells from the grid's corner.
        end: Shape (2,), in cells from the grid's corner.
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


@njit(cache=True)
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
        while there > here + 1 and not line_is_free(free, points[here], points[there]):
            there -= 1
        kept[count] = there
        count += 1
        here = there
    return kept[:count]
