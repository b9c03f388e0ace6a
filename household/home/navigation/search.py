"""Shortest ways on the grid of free space; those that were once found are kept."""

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Indices, Mask
from household.compiled.jit import compiled
from household.home.navigation.grid import NOWHERE, Cells

Turns = NDArray[np.int8]

STRAIGHT, DIAGONAL = 12, 17
"""Lengths of steps to neighboring cells: whole numbers, so that cells are found in
order of distance without a heap; their ratio is the square root of 2 to 0.2 %."""

BUCKETS = 64
"""More than twice `DIAGONAL`, for all lengths that can be waiting; a power of two, for
which a remainder is cheap."""

FAR, CLOSED = np.iinfo(np.int32).max, -1
"""Distance of cells not yet found, and of those that no way may lead through."""

HERE, UNKNOWN = 4, -1
"""In place of the next step, from 0 to 8: at the goal, and where no way is known."""

MOST_BYTES = 64 << 20
"""Of memory for the ways that are kept."""

MOST_GOALS = 4096
"""To which ways are kept."""


def room_for_ways(indoors: Mask) -> tuple[Cells, Cells, Turns, Indices]:
    """Room to find ways in, and to keep them; most of it is taken when it is used.

    Args:
        indoors: Where ways may lead, nowhere at the edge, shape (width, height).

    Returns:
        scratch: For `_search`, shape (25, n_cells).
        kept_at: In which row of ``kept`` the ways to each cell are, `NOWHERE` if they
            are not kept, shape (n_cells,).
        kept: For each goal that is kept the step from every cell, (n_goals, n_cells);
            the first row is for a way that is not kept.
        n_kept: How many rows are taken, shape (1,).
    """
    n_cells = indoors.size
    scratch = np.zeros((25, n_cells), np.int32)
    scratch[0] = np.where(indoors, FAR, CLOSED).ravel()
    goals = max(1, min(MOST_GOALS, MOST_BYTES // n_cells))
    kept_at = np.full(n_cells, NOWHERE, np.int32)
    kept = np.empty((1 + goals, n_cells), np.int8)
    return scratch, kept_at, kept, np.ones(1, np.intp)


@compiled
def onward_to(
    height: int,
    scratch: Cells,
    kept_at: Cells,
    kept: Turns,
    n_kept: Indices,
    goal: int,
    start: int,
    keep: bool,
) -> Turns:
    """A way to a cell, or ways from all that are as near as another.

    Those are kept for the next who walks there: that saves time, and changes no way.

    Args:
        height: Of the grid.
        scratch: From `room_for_ways`, like the three that follow; brought up to date.
        kept_at: Shape (n_cells,).
        kept: Shape (n_goals, n_cells).
        n_kept: Shape (1,).
        goal: A cell.
        start: A cell from which a way leads there.
        keep: Whether others will walk there, too.

    Returns:
        A row of ``kept``: the step that leads on from each cell, see `beyond`.
    """
    if not keep:
        _search(height, scratch, goal, start, kept[0], 1, True)
        return kept[0]
    if kept_at[goal] == NOWHERE:
        if n_kept[0] == len(kept):
            kept_at[:], n_kept[0] = NOWHERE, 1
        kept_at[goal] = n_kept[0]
        n_kept[0] += 1
        _search(height, scratch, goal, start, kept[kept_at[goal]], 1, False)
    elif kept[kept_at[goal], start] == UNKNOWN:
        # A goal of many: twice as far as needed, so that few more ask in vain.
        _search(height, scratch, goal, start, kept[kept_at[goal]], 2, False)
    return kept[kept_at[goal]]


@compiled
def beyond(cell: int, step: int, height: int) -> int:
    """The cell that a step leads to: 0 to 8, as in three columns of three cells."""
    column, row = divmod(int(step), 3)  # A small type of its own would overflow.
    return cell + (column - 1) * height + row - 1


@compiled
def _search(
    height: int,
    scratch: Cells,
    goal: int,
    start: int,
    onward: Turns,
    times: int,
    aimed: bool,
) -> None:
    """Shortest ways to a cell (Dijkstra's, with Dial's buckets; A* where aimed).

    The search ends once the way from ``start`` is known, and with it all ways that are
    no longer, or so many times as long. They are the same however far a search goes.
    One that is aimed at ``start`` leaves out what lies elsewhere.

    Args:
        height: Of the grid.
        scratch: `FAR` for each cell where ways may lead, none of them at the edge of
            the grid, and `CLOSED` for all others, in its first row; that is so again in
            the end. The others are for entries, of which each cell can have eight.
            Shape (25, width * height).
        goal: A cell.
        start: A cell from which a way leads there.
        onward: Filled in with the step that leads on from each cell, `HERE` at the
            goal, `UNKNOWN` where the way is not known, shape (width * height,).
        times: How many times as far as ``start`` is to search; 1 where aimed.
        aimed: Whether only the way from ``start`` is looked for.
    """
    onward[:] = UNKNOWN
    away = scratch[0]  # As far as found.
    # A bucket for each length that can be waiting, in each a list of entries: a cell,
    # the step that leads on from it and the entry that follows in the bucket. Lengths
    # are those of the way from the cell, or where aimed, of the whole way through it.
    bucket = np.full(BUCKETS, NOWHERE, np.int32)
    cells, steps, followers = scratch[1:].reshape((3, -1))
    length = 0
    if aimed:
        length = _beeline(
            goal // height - start // height, goal % height - start % height
        )
    cells[0], steps[0], followers[0] = goal, HERE, NOWHERE
    away[goal], bucket[length % BUCKETS], entries = 0, 0, 1
    while times * int(away[start]) >= length:
        entry = bucket[length % BUCKETS]
        if entry == NOWHERE:
            length += 1
            continue
        cell, step = cells[entry], steps[entry]
        bucket[length % BUCKETS] = followers[entry]
        if onward[cell] != UNKNOWN:
            continue
        onward[cell] = step
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
                cells[entries], steps[entries] = there, 8 - out
                followers[entries], bucket[k] = bucket[k], entries
                away[there], entries = reached, entries + 1
    for entry in range(entries):
        away[cells[entry]] = FAR


@compiled
def _beeline(columns: int, rows: int) -> int:
    """The least length that a way over so many columns and rows can have."""
    most, least = max(abs(columns), abs(rows)), min(abs(columns), abs(rows))
    return STRAIGHT * most + (DIAGONAL - STRAIGHT) * least
