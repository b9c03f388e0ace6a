"""Shortest ways on the grid of free space; those that were once found are kept."""

import numpy as np

from household.arrays import Indices
from household.compiled import compiled
from household.home.grid import NOWHERE, Cells

STRAIGHT, DIAGONAL = 12, 17
"""Lengths of steps to neighboring cells: whole numbers, so that cells are found in
order of distance without a heap; their ratio is the square root of 2 to 0.2 %."""

BUCKETS = 32
"""More than `DIAGONAL`, for all distances that can be waiting; a power of two, for
which a remainder is cheap."""

FAR, CLOSED = np.iinfo(np.int32).max, -1
"""Distance of cells not yet found, and of those that no way may lead through."""

MOST_BYTES = 64 << 20
"""Of memory for the ways that are kept."""

MOST_GOALS = 1024
"""To which ways are kept."""


def room_for_ways(n_cells: int) -> tuple[Cells, Cells, Indices]:
    """Room to keep ways in; memory is taken only when it is used.

    Args:
        n_cells: Of the grid.

    Returns:
        Where the ways to each cell are kept, `NOWHERE` if they are not, (n_cells,);
        for each goal that is kept the next cell from every other, (n_goals, n_cells);
        and how many goals are, (1,).
    """
    goals = max(1, min(MOST_GOALS, MOST_BYTES // (4 * n_cells)))
    kept_at = np.full(n_cells, NOWHERE, np.int32)
    return kept_at, np.empty((goals, n_cells), np.int32), np.zeros(1, np.intp)


@compiled
def onward_to(
    untrodden: Cells,
    kept_at: Cells,
    kept: Cells,
    n_kept: Indices,
    goal: int,
    start: int,
) -> Cells:
    """Ways to a cell from all that are as near as another.

    They are kept for the next who walks there: that saves time, and changes no way.

    Args:
        untrodden: As in `_search`.
        kept_at: From `room_for_ways`; brought up to date in place, like the next two.
        kept: From `room_for_ways`.
        n_kept: From `room_for_ways`.
        goal: A cell.
        start: A cell from which a way leads there.

    Returns:
        A row of ``kept``: for each cell the next one on its way, `NOWHERE` at the goal
        and where the way is not known.
    """
    if kept_at[goal] == NOWHERE:
        if n_kept[0] == len(kept):
            kept_at[:], n_kept[0] = NOWHERE, 0
        kept_at[goal] = n_kept[0]
        n_kept[0] += 1
        _search(untrodden, goal, start, kept[kept_at[goal]])
    elif kept[kept_at[goal], start] == NOWHERE:
        _search(untrodden, goal, start, kept[kept_at[goal]])
    return kept[kept_at[goal]]


@compiled
def _search(untrodden: Cells, goal: int, start: int, onward: Cells) -> None:
    """Shortest ways to a cell (Dijkstra's, with Dial's buckets).

    The search ends once the way from ``start`` is known, and with it all ways that are
    no longer. They are the same however far a search goes.

    Args:
        untrodden: `FAR` for each cell where ways may lead, none of them at the edge
            of the grid, and `CLOSED` for all others, shape (width, height).
        goal: A cell.
        start: A cell from which a way leads there.
        onward: Filled in with the next cell on the way of each, `NOWHERE` at the goal
            and where the way is not known, shape (width * height,).
    """
    height = untrodden.shape[1]
    away = untrodden.copy().ravel()  # As far as found.
    onward[:] = NOWHERE
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
