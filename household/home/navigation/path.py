"""Ways through a home, compiled: shortest ones, pulled straight where they can be."""

import numpy as np

from household.compiled.arrays import Floats, Indices
from household.compiled.jit import compiled
from household.config.toml import Point
from household.home.navigation.grid import (
    CELL,
    NOWHERE,
    Cells,
    Grid,
    ends_of,
    in_cells,
    line_is_free,
)
from household.home.navigation.search import HERE, Turns, beyond, onward_to

BENT = 1.0
"""So far may the end of a way be moved before the way is planned anew [m]: who follows
somebody need not think of the whole way at each step."""

ROOM = 8
"""Waypoints that there is room for at first; hardly any way has more."""


@compiled
def find_way(
    free: Grid,
    parts: Cells,
    corner: Floats,
    scratch: Cells,
    kept_at: Cells,
    kept: Turns,
    n_kept: Indices,
    start: Point,
    goal: Point,
    way: Floats,
    at: int,
    count: int,
    keep: bool,
) -> int:
    """Finds the waypoints of a short walk.

    Where the goal of a way has only moved a little, its end is bent towards it.

    Args:
        free: The grid, shape (width, height).
        parts: Label of the connected part of each cell, shape (width, height).
        corner: Of the grid, shape (2,) [m].
        scratch: From `room_for_ways`, like the three that follow; brought up to date.
        kept_at: Shape (n_cells,).
        kept: Shape (n_goals, n_cells).
        n_kept: Shape (1,).
        start: Where the walk begins [m].
        goal: Where it should end [m]; where no body fits, the nearest place where one
            does.
        way: Filled in with the points to walk to one after the other, the last one
            nearest to the goal, if there is room for them, shape (most, 2) [m]. It
            holds the way that the walker is on.
        at: Index of the first waypoint of that way that is still before it.
        count: How many waypoints that way has; ``at`` if it is on none.
        keep: Whether others will walk to that goal, too.

    Returns:
        How many waypoints there are, 0 if no way leads there.
    """
    first, last, end = ends_of(free, parts, corner, start, goal)
    if first == NOWHERE:
        return 0
    if first != last and count - at > 1 and _leads_on(free, corner, way, count, end):
        for k in range(count - at):
            way[k] = way[at + k]
        way[count - at - 1, 0], way[count - at - 1, 1] = end
        return count - at
    if first == last:
        way[0, 0], way[0, 1] = end
        return 1
    height = free.shape[1]
    onward = onward_to(height, scratch, kept_at, kept, n_kept, last, first, keep)
    turns = _turns(free, onward, corner, first, end)
    if len(turns) <= len(way):
        way[: len(turns)] = turns
    return len(turns)


@compiled
def _leads_on(free: Grid, corner: Floats, way: Floats, count: int, end: Point) -> bool:
    """Whether a way leads to a new end close to its own."""
    dx, dy = way[count - 1, 0] - end[0], way[count - 1, 1] - end[1]
    if np.hypot(dx, dy) > BENT:
        return False
    turn = (way[count - 2, 0], way[count - 2, 1])
    return line_is_free(free, in_cells(corner, turn), in_cells(corner, end))


@compiled
def _turns(free: Grid, onward: Turns, corner: Floats, first: int, end: Point) -> Floats:
    """A shortest way pulled straight: one walks straight between its points.

    Args:
        free: The grid, shape (width, height).
        onward: From `onward_to`.
        corner: Of the grid [m].
        first: The cell where the way begins.
        end: Where it ends, in the last cell [m].

    Returns:
        The points where it turns, and its end, shape (n, 2) [m].
    """
    middles = _middles(onward, first, free.shape[1])
    goal, last = in_cells(corner, end), len(middles) - 1
    turns, count, here = np.empty((len(middles), 2)), 0, 0
    while here < last:
        start = (middles[here, 0], middles[here, 1])
        if line_is_free(free, start, goal):
            break
        there = last
        while there > here + 1:
            if line_is_free(free, start, (middles[there, 0], middles[there, 1])):
                break
            there -= 1
        turns[count, 0] = corner[0] + middles[there, 0] * CELL
        turns[count, 1] = corner[1] + middles[there, 1] * CELL
        count, here = count + 1, there
    turns[count, 0], turns[count, 1] = end
    return turns[: count + 1]


@compiled
def _middles(onward: Turns, first: int, height: int) -> Floats:
    """Middles of the cells on a way, shape (n, 2), in cells from the grid's corner."""
    count, here = 1, first
    while onward[here] != HERE:
        count, here = count + 1, beyond(here, onward[here], height)
    middles, here = np.empty((count, 2)), first
    for k in range(count):
        middles[k, 0], middles[k, 1] = here // height + 0.5, here % height + 0.5
        here = beyond(here, onward[here], height)
    return middles
