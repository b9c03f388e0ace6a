"""Ways: the waypoints that everybody still has before it."""

from collections.abc import Sequence

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import compiled
from household.config.toml import Point
from household.home.navigation.grid import Cells, Grid
from household.home.navigation.path import ROOM, find_way
from household.home.navigation.search import Turns
from household.state import Stateful


class Paths(Stateful):
    """The way that each body is on, or was on last.

    Attributes:
        points: The waypoints of each way, shape (n, most, 2) [m].
        at: Index of the waypoint that each is heading for, shape (n,).
        count: How many waypoints the way of each has, shape (n,).
    """

    points: Floats
    at: Indices
    count: Indices

    STATE = ("points", "at", "count")

    def __init__(self, n: int) -> None:
        self.points = np.zeros((n, ROOM, 2))
        self.at = np.zeros(n, np.intp)
        self.count = np.zeros(n, np.intp)

    def take(self, i: int, way: Sequence[Point]) -> None:
        """Puts a body at the beginning of a way."""
        self.make_room(len(way))
        self.points[i, : len(way)] = way
        self.at[i], self.count[i] = 0, len(way)

    def make_room(self, most: int) -> None:
        """Makes room for so many waypoints on each way."""
        more = max(0, most - self.points.shape[1])
        if more:
            self.points = np.pad(self.points, ((0, 0), (0, more), (0, 0)))

    def goal(self, i: int) -> Point:
        """Where the way of a body ends [m]."""
        x, y = self.points[i, self.count[i] - 1].tolist()
        return x, y


@compiled
def set_out(
    free: Grid,
    parts: Cells,
    corner: Floats,
    scratch: Cells,
    kept_at: Cells,
    kept: Turns,
    n_kept: Indices,
    position: Floats,
    walking: Mask,
    nearest: Floats,
    stalled: Floats,
    settled: Floats,
    walk_began: Floats,
    lost: Mask,
    points: Floats,
    at: Indices,
    count: Indices,
    goals: Floats,
    target: Indices,
    now: float,
    places: bool,
) -> int:
    """Sends everybody on a walk who is lost; to where no way leads, nobody sets out.

    Args:
        free: As in `find_way`, like all that follow up to ``n_kept``.
        parts: Shape (width, height).
        corner: Shape (2,) [m].
        scratch: Shape (25, n_cells).
        kept_at: Shape (n_cells,).
        kept: Shape (n_goals, n_cells).
        n_kept: Shape (1,).
        position: Shape (n, 2) [m].
        walking: Shape (n,); changed in place, like all that follow up to ``count``.
        nearest: As in `follow_up`, shape (n,) [m].
        stalled: As in `follow_up`, shape (n,) [s].
        settled: The goal that others kept each from, NaN if none, shape (n, 2) [m].
        walk_began: Shape (n,) [s].
        lost: Who is to set out, shape (n,); in the end, who has not for lack of room.
        points: From `Paths`, like the two that follow, shape (n, most, 2) [m].
        at: Shape (n,).
        count: Shape (n,).
        goals: Where to, for each of the first m bodies, shape (m, 2) [m].
        target: Whom each goes after instead, `NOBODY` for none, shape (m,).
        now: [s].
        places: Whether goals are where others will want to be, too.

    Returns:
        How many waypoints the longest way has.
    """
    most = 0
    for i in range(len(goals)):
        if not lost[i]:
            continue
        x, y = goals[i] if target[i] == NOBODY else position[target[i]]
        found = find_way(
            free,
            parts,
            corner,
            scratch,
            kept_at,
            kept,
            n_kept,
            (position[i, 0], position[i, 1]),
            (x, y),
            points[i],
            at[i],
            count[i] if walking[i] else at[i],
            places and target[i] == NOBODY,
        )
        lost[i] = found > points.shape[1]
        if found == 0:
            walking[i] = False
        elif not lost[i]:
            if not walking[i]:
                walking[i], walk_began[i] = True, now
            at[i], count[i] = 0, found
            nearest[i], stalled[i], settled[i] = np.inf, 0.0, np.nan
        most = max(most, found)
    return most
