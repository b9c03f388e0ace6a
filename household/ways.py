"""Ways: the waypoints that everybody still has before it."""

from collections.abc import Sequence

import numpy as np

from household.arrays import Floats, Indices
from household.records import Point

ROOM = 8
"""Waypoints that there is room for at first; hardly any way has more."""


class Ways:
    """The way that each body is on.

    Attributes:
        points: The waypoints of each way, shape (n, most, 2) [m].
        at: Index of the waypoint that each is heading for, shape (n,).
        count: How many waypoints the way of each has, shape (n,).
    """

    points: Floats
    at: Indices
    count: Indices

    def __init__(self, n: int) -> None:
        self.points = np.zeros((n, ROOM, 2))
        self.at = np.zeros(n, np.intp)
        self.count = np.zeros(n, np.intp)

    def set_out(self, i: int, way: Sequence[Point]) -> None:
        """Puts a body at the beginning of a way."""
        if len(way) > self.points.shape[1]:
            more = len(way) - self.points.shape[1]
            self.points = np.pad(self.points, ((0, 0), (0, more), (0, 0)))
        points = self.points
        for k, (x, y) in enumerate(way):
            points[i, k, 0], points[i, k, 1] = x, y
        self.at[i], self.count[i] = 0, len(way)

    def left(self, i: int) -> list[Point]:
        """The waypoints that a body has not passed yet [m]."""
        left = self.points[i, self.at[i] : self.count[i]].tolist()
        return [(x, y) for x, y in left]
