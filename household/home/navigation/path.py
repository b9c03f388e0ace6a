"""Paths through a home, compiled: short ones, straightened wherever they can be."""

from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.config.toml import Point
from household.home.navigation.grid import (
    CELL,
    NOWHERE,
    Grid,
    ends_of,
    in_cells,
    line_is_free,
)
from household.home.navigation.search import (
    HERE,
    PathCache,
    Steps,
    beyond,
    steps_to,
)

BENT = 1.0
"""How far the end of a path may move before the path is planned anew [m]: a body that
follows another need not think of the whole path at each step."""

ROOM = 8
"""Waypoints that there is room for at first; hardly any path has more."""


class Navigation(NamedTuple):
    """What paths through a home are found with.

    Attributes:
        grid: The free space.
        cache: The paths that are kept.
    """

    grid: Grid
    cache: PathCache


class Waypoints(NamedTuple):
    """The path that a body is on.

    Attributes:
        points: The waypoints, with room for more, shape (most, 2) [m].
        at: Index of the waypoint that the body is walking to.
        length: How many waypoints there are; ``at`` if the body is on no path.
    """

    points: Annotated[Floats, "most", 2]
    at: int
    length: int


@compiled
def find_path(
    navigation: Navigation, start: Point, goal: Point, path: Waypoints, keep: bool
) -> int:
    """Finds the waypoints of a short walk.

    Where the goal of a path has only moved a little, its end is bent towards it.

    Args:
        navigation: Of the home; its cache is brought up to date.
        start: Where the walk begins [m].
        goal: Where it should end [m]; where no body fits, the nearest place where one
            does.
        path: The path that the walker is on. Its points are replaced by the new ones to
            walk to one after the other, the last one nearest to the goal, if there is
            room for them.
        keep: Whether others will walk to that goal, too.

    Returns:
        How many waypoints there are, 0 if no path leads there.
    """
    grid, points = navigation.grid, path.points
    first, last, end = ends_of(grid, start, goal)
    if first == NOWHERE:
        return 0
    left = path.length - path.at
    if first != last and left > 1 and _leads_on(grid, path, end):
        for k in range(left):
            points[k] = points[path.at + k]
        points[left - 1, 0], points[left - 1, 1] = end
        return left
    if first == last:
        points[0, 0], points[0, 1] = end
        return 1
    steps = steps_to(navigation.cache, last, first, keep)
    turns = _turns(grid, steps, first, end)
    if len(turns) <= len(points):
        points[: len(turns)] = turns
    return len(turns)


@compiled
def _leads_on(grid: Grid, path: Waypoints, end: Point) -> bool:
    """Whether a path leads to a new end close to its own."""
    points, last = path.points, path.length - 1
    dx, dy = points[last, 0] - end[0], points[last, 1] - end[1]
    if np.hypot(dx, dy) > BENT:
        return False
    turn = (points[last - 1, 0], points[last - 1, 1])
    return line_is_free(
        grid.free, in_cells(grid.corner, turn), in_cells(grid.corner, end)
    )


@compiled
def _turns(grid: Grid, steps: Steps, first: int, end: Point) -> Floats:
    """A shortest path made straight: one walks straight between its points.

    Args:
        grid: The free space.
        steps: From `steps_to`.
        first: The cell where the path begins.
        end: Where it ends, in the last cell [m].

    Returns:
        The points where it turns, and its end, shape (n, 2) [m].
    """
    free, corner = grid.free, grid.corner
    middles = _middles(steps, first, free.shape[1])
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
def _middles(steps: Steps, first: int, height: int) -> Floats:
    """Middles of the cells on a path, shape (n, 2), in cells from the grid's corner."""
    count, here = 1, first
    while steps[here] != HERE:
        count, here = count + 1, beyond(here, steps[here], height)
    middles, here = np.empty((count, 2)), first
    for k in range(count):
        middles[k, 0], middles[k, 1] = here // height + 0.5, here % height + 0.5
        here = beyond(here, steps[here], height)
    return middles
