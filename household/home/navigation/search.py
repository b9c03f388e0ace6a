"""Shortest paths on the grid of free space; those that were once found are kept."""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Indices, Mask
from household.compiled.jit import compiled
from household.home.navigation.grid import NOWHERE, Cells

Steps = NDArray[np.int8]
"""A step from each cell, see `beyond`."""

STRAIGHT, DIAGONAL = 12, 17
"""Lengths of steps to neighboring cells: whole numbers, so that cells are found in
order of distance without a heap; their ratio is the square root of 2 to 0.2 %."""

BUCKETS = 64
"""More than twice `DIAGONAL`, for all lengths that can be waiting; a power of two, for
which a remainder is cheap."""

FAR, CLOSED = np.iinfo(np.int32).max, -1
"""Distance of cells not yet found, and of those that no path may lead through."""

HERE, UNKNOWN = 4, -1
"""In place of the next step, from 0 to 8: at the goal, and where no path is known."""

MOST_BYTES = 64 << 20
"""Of memory for the paths that are kept."""

MOST_GOALS = 4096
"""To which paths are kept."""


class PathCache(NamedTuple):
    """Paths that were found, and what is needed to find others.

    Attributes:
        height: Of the grid.
        scratch: Working memory of `_search`, shape (25, n_cells).
        row: In which row of ``steps`` the paths to each cell are, `NOWHERE` if they are
            not kept, shape (n_cells,).
        steps: For each goal the step that leads on from every cell, see `beyond`,
            shape (n_goals, n_cells); the first row is for a path that is not kept.
        used: How many rows are taken, shape (1,).
    """

    height: int
    scratch: Annotated[Cells, 25, "n_cells"]
    row: Annotated[Cells, "n_cells"]
    steps: Annotated[Steps, "n_goals", "n_cells"]
    used: Annotated[Indices, 1]


def empty_cache(indoors: Mask) -> PathCache:
    """A cache without paths; most of its memory is taken when it is used.

    Args:
        indoors: Where paths may lead, nowhere at the edge, shape (width, height).
    """
    n_cells = indoors.size
    scratch = np.zeros((25, n_cells), np.int32)
    scratch[0] = np.where(indoors, FAR, CLOSED).ravel()
    goals = max(1, min(MOST_GOALS, MOST_BYTES // n_cells))
    return PathCache(
        height=indoors.shape[1],
        scratch=scratch,
        row=np.full(n_cells, NOWHERE, np.int32),
        steps=np.empty((1 + goals, n_cells), np.int8),
        used=np.ones(1, np.intp),
    )


@compiled
def steps_to(cache: PathCache, goal: int, start: int, keep: bool) -> Steps:
    """The steps of a path to a cell, or of the paths from all cells that are as near.

    The latter are kept for the next who walks there: that saves time, and changes no
    path.

    Args:
        cache: Brought up to date.
        goal: A cell.
        start: A cell from which a path leads there.
        keep: Whether others will walk there, too.

    Returns:
        A row of ``cache.steps``.
    """
    row, steps, used = cache.row, cache.steps, cache.used
    if not keep:
        _search(cache, goal, start, steps[0], 1, True)
        return steps[0]
    if row[goal] == NOWHERE:
        if used[0] == len(steps):
            row[:], used[0] = NOWHERE, 1
        row[goal] = used[0]
        used[0] += 1
        _search(cache, goal, start, steps[row[goal]], 1, False)
    elif steps[row[goal], start] == UNKNOWN:
        # A goal of many: twice as far as needed, so that few more ask in vain.
        _search(cache, goal, start, steps[row[goal]], 2, False)
    return steps[row[goal]]


@compiled
def beyond(cell: int, step: int, height: int) -> int:
    """The cell that a step leads to: 0 to 8, as in three columns of three cells."""
    column, row = divmod(int(step), 3)  # A small type of its own would overflow.
    return cell + (column - 1) * height + row - 1


@compiled
def _search(
    cache: PathCache, goal: int, start: int, steps: Steps, times: int, aimed: bool
) -> None:
    """Shortest paths to a cell (Dijkstra's, with Dial's buckets; A* where aimed).

    The search ends once the path from ``start`` is known, and with it all paths that
    are no longer, or so many times as long. They are the same however far a search
    goes. One that is aimed at ``start`` leaves out what lies elsewhere.

    Args:
        cache: Its ``scratch`` is used. The first row of it is `FAR` for each cell where
            paths may lead, none of them at the edge of the grid, and `CLOSED` for all
            others; that is so again in the end. The other rows are for entries, of
            which each cell can have eight.
        goal: A cell.
        start: A cell from which a path leads there.
        steps: Filled in with the step that leads on from each cell, `HERE` at the goal,
            `UNKNOWN` where the path is not known, shape (n_cells,).
        times: How many times as far as ``start`` is to search; 1 where aimed.
        aimed: Whether only the path from ``start`` is looked for.
    """
    height, scratch = cache.height, cache.scratch
    steps[:] = UNKNOWN
    away = scratch[0]  # As far as found.
    # A bucket for each length that can be waiting, in each a list of entries: a cell,
    # the step that leads on from it and the entry that follows in the bucket. Lengths
    # are those of the path from the cell, or where aimed, of the whole path through it.
    bucket = np.full(BUCKETS, NOWHERE, np.int32)
    cells, onward, followers = scratch[1:].reshape((3, -1))
    length = 0
    if aimed:
        length = _beeline(
            goal // height - start // height, goal % height - start % height
        )
    cells[0], onward[0], followers[0] = goal, HERE, NOWHERE
    away[goal], bucket[length % BUCKETS], entries = 0, 0, 1
    while times * int(away[start]) >= length:
        entry = bucket[length % BUCKETS]
        if entry == NOWHERE:
            length += 1
            continue
        cell, step = cells[entry], onward[entry]
        bucket[length % BUCKETS] = followers[entry]
        if steps[cell] != UNKNOWN:
            continue
        steps[cell] = step
        column = cell // height - start // height
        row = cell % height - start % height
        for out in range(9):
            there = beyond(cell, out, height)
            reached = away[cell] + (STRAIGHT if out % 2 else DIAGONAL)
            if reached < away[there]:
                left = (
                    _beeline(column + out // 3 - 1, row + out % 3 - 1) if aimed else 0
                )
                k = (reached + left) % BUCKETS
                cells[entries], onward[entries] = there, 8 - out
                followers[entries], bucket[k] = bucket[k], entries
                away[there], entries = reached, entries + 1
    for entry in range(entries):
        away[cells[entry]] = FAR


@compiled
def _beeline(columns: int, rows: int) -> int:
    """The least length that a path over so many columns and rows can have."""
    most, least = max(abs(columns), abs(rows)), min(abs(columns), abs(rows))
    return STRAIGHT * most + (DIAGONAL - STRAIGHT) * least
