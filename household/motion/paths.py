"""Paths: the waypoints that everybody walks to, one after the other."""

from collections.abc import Sequence
from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import compiled
from household.config.toml import Point
from household.home.navigation.grid import Grid, leads_to
from household.home.navigation.path import ROOM, Navigation, Waypoints, find_path
from household.motion.bodies import Goals, Walks


class Paths(NamedTuple):
    """The present or latest path of each body.

    Attributes:
        points: Waypoints, with room for as many on each path, shape (n, most, 2) [m].
        at: Index of the waypoint that each body is walking to, shape (n,).
        length: How many waypoints the path of each has, shape (n,).
    """

    points: Annotated[Floats, "n", "most", 2]
    at: Annotated[Indices, "n"]
    length: Annotated[Indices, "n"]


class Departures(NamedTuple):
    """Who sets out, and where to.

    Attributes:
        due: Whether each body was to set out when that was last found out, shape (n,).
        unplanned: Whether each has set out and its path is still to be found, (n,).
        goal: Where each has set out to, if that is so, shape (n, 2) [m].
        shared: Whether others will walk to that goal, too, shape (n,).
    """

    due: Annotated[Mask, "n"]
    unplanned: Annotated[Mask, "n"]
    goal: Annotated[Floats, "n", 2]
    shared: Annotated[Mask, "n"]


def no_departures(n: int) -> Departures:
    """So many bodies of which none sets out."""
    return Departures(
        due=np.zeros(n, np.bool_),
        unplanned=np.zeros(n, np.bool_),
        goal=np.zeros((n, 2)),
        shared=np.zeros(n, np.bool_),
    )


def no_paths(n: int) -> Paths:
    """Paths without waypoints for so many bodies."""
    return Paths(np.zeros((n, ROOM, 2)), np.zeros(n, np.intp), np.zeros(n, np.intp))


def with_room(paths: Paths, most: int) -> Paths:
    """The same paths, with room for at least so many waypoints on each."""
    more = max(0, most - paths.points.shape[1])
    if not more:
        return paths
    return paths._replace(points=np.pad(paths.points, ((0, 0), (0, more), (0, 0))))


def with_path(paths: Paths, i: int, waypoints: Sequence[Point]) -> Paths:
    """The same paths, but that one body is at the beginning of another.

    What has room is changed in place.

    Args:
        paths: Of all bodies.
        i: Index of the body.
        waypoints: At least one [m].
    """
    paths = with_room(paths, len(waypoints))
    paths.points[i, : len(waypoints)] = waypoints
    paths.at[i], paths.length[i] = 0, len(waypoints)
    return paths


def end_of(paths: Paths, i: int) -> Point:
    """Where the path of a body ends [m]."""
    x, y = paths.points[i, paths.length[i] - 1].tolist()
    return x, y


@compiled
def set_out(
    grid: Grid,
    position: Annotated[Floats, "n", 2],
    walking: Annotated[Mask, "n"],
    departures: Departures,
    paths: Paths,
    goals: Goals,
) -> bool:
    """Lets everybody set out who is to; `find_paths` finds the paths later.

    A body to whose goal no path leads stands still.

    Args:
        grid: The free space of the home.
        position: Of all bodies, shape (n, 2) [m].
        walking: Whether each body is on a walk, shape (n,); changed in place.
        departures: Who is to set out; where they go is set.
        paths: Of all bodies; those of who stood still have nothing left.
        goals: Where the first bodies want to be. Others will walk to the same points,
            but not to the same targets.

    Returns:
        Whether anybody has set out.
    """
    anybody = False
    for i in range(len(goals.target)):
        if not departures.due[i]:
            continue
        goal = goal_of(goals, i, position)
        if not walking[i]:
            paths.length[i] = paths.at[i]
        walking[i] = leads_to(grid, (position[i, 0], position[i, 1]), goal)
        departures.unplanned[i] = walking[i]
        departures.goal[i, 0], departures.goal[i, 1] = goal
        departures.shared[i] = goals.target[i] == NOBODY
        anybody |= walking[i]
    return anybody


@compiled
def find_paths(
    navigation: Navigation,
    position: Annotated[Floats, "n", 2],
    walks: Walks,
    departures: Departures,
    paths: Paths,
) -> int:
    """Finds the paths of all who have set out.

    A body to whose goal no path leads stands still. At the end, `Departures.unplanned`
    holds for those bodies whose path has more waypoints than there is room for.

    Args:
        navigation: Of the home; the paths that it keeps are brought up to date.
        position: Of all bodies, shape (n, 2) [m].
        walks: Changed in place for those who have set out.
        departures: Who has set out, and where to; changed in place.
        paths: Of all bodies, changed in place.

    Returns:
        How many waypoints the longest new path has, 0 if there is none.
    """
    most, walking, unplanned = 0, walks.walking, departures.unplanned
    for i in range(len(unplanned)):
        if not unplanned[i]:
            continue
        here = position[i, 0], position[i, 1]
        goal = departures.goal[i, 0], departures.goal[i, 1]
        path = Waypoints(paths.points[i], paths.at[i], paths.length[i])
        found = find_path(navigation, here, goal, path, departures.shared[i])
        unplanned[i] = found > paths.points.shape[1]
        if found == 0:
            walking[i] = False
        elif not unplanned[i]:
            paths.at[i], paths.length[i] = 0, found
            walks.nearest[i], walks.stalled[i] = np.inf, 0.0
            walks.settled[i] = np.nan
        most = max(most, found)
    return most


@compiled
def goal_of(goals: Goals, i: int, position: Floats) -> Point:
    """Where one of the bodies with a goal wants to be [m].

    Args:
        goals: Of the first bodies.
        i: Index of the body.
        position: Of all bodies, shape (n, 2) [m].
    """
    x, y = goals.point[i] if goals.target[i] == NOBODY else position[goals.target[i]]
    return x, y
