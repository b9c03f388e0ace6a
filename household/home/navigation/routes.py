"""Routes through a home: short paths round walls and furniture.

A person's center may be wherever its body is clear of all obstacles. That free space
is a grid; shortest paths on it are made straight wherever the straight line is free.
"""

from collections.abc import Callable
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from household.compiled.arrays import Floats, Mask
from household.compiled.jit import bind
from household.config.toml import Point
from household.home.floorplan import FloorPlan
from household.home.geometry import distance_to_box, distance_to_segments
from household.home.navigation.cells import mark_near_box, mark_near_segment
from household.home.navigation.grid import CELL, Grid, cell_of
from household.home.navigation.path import ROOM, Navigation, Waypoints, find_path
from household.home.navigation.search import empty_cache

BODY = 0.25
"""Radius of the widest walker, a person [m]."""

CLEARANCE = 0.3
"""From a walker's center to any obstacle [m]: its radius and a margin."""

ROUNDING = 1e-9
"""Of distances [m]."""

STEPS = ((0, 1), (1, 0), (1, 1), (1, -1))
"""Half of the eight directions; the graph is undirected."""

MARGIN = 6 * CELL
"""Free ground round the home [m], so that all that is outdoors hangs together."""


class Routes:
    """The free space of one floor plan and the walks through it."""

    def __init__(self, plan: FloorPlan) -> None:
        self._plan = plan
        self._origin = plan.lower - MARGIN
        shape = np.ceil((plan.upper + MARGIN - self._origin) / CELL).astype(int)
        self._shape: tuple[int, int] = (int(shape[0]), int(shape[1]))
        self.free = self._clear_of(plan)

    def _clear_of(self, plan: FloorPlan) -> Mask:
        """Marks the cells whose center clears walls and furniture."""
        solid = np.zeros(self._shape, np.bool_)
        for wall in plan.wall_segments:
            reach = plan.wall_thickness / 2 + CLEARANCE
            mark_near_segment(solid, self._origin, CELL, wall, reach)
        for box in plan.furniture:
            mark_near_box(solid, self._origin, CELL, box, CLEARANCE)
        return ~solid

    def centers(self) -> Floats:
        """Middles of all cells [m], shape (n_cells, 2), in the order of ``free``."""
        grid = np.indices(self._shape).reshape(2, -1).T
        return self._origin + (grid + 0.5) * CELL

    @cached_property
    def _graph(self) -> csr_array:
        """Distances [m] between neighboring free cells, as a sparse matrix."""
        rows, columns, lengths = [], [], []
        number = np.arange(self.free.size).reshape(self._shape)
        for dx, dy in STEPS:
            here, there = _shifted(dx, dy)
            open_ = self.free[here] & self.free[there]
            rows.append(number[here][open_])
            columns.append(number[there][open_])
            lengths.append(np.full(int(open_.sum()), CELL * np.hypot(dx, dy)))
        entries = np.concatenate(lengths)
        place = (np.concatenate(rows), np.concatenate(columns))
        return csr_array((entries, place), shape=(self.free.size, self.free.size))

    @cached_property
    def parts(self) -> NDArray[np.int32]:
        """Label of the connected part that each cell belongs to, shape of ``free``.

        Part ``parts[0, 0]`` is outdoors; cells of walls are parts of their own.
        """
        _, labels = connected_components(self._graph, directed=False)
        return labels.astype(np.int32).reshape(self._shape)

    def cell(self, point: Point | Floats) -> tuple[int, int]:
        """The grid cell that holds a point, clipped to the grid."""
        return cell_of(self.free, self._origin, (float(point[0]), float(point[1])))

    def is_indoors(self, point: Floats) -> bool:
        """Whether a body fits at a point that the walls close off from outside."""
        cell = self.cell(point)
        return bool(self.free[cell]) and self.parts[cell] != self.parts[0, 0]

    def has_room(self, point: Point) -> bool:
        """Whether a body at a point overlaps nothing; in a free cell it nearly fits."""
        if not self.free[self.cell(point)]:
            return False
        plan, spot = self._plan, np.array([point])
        gap = distance_to_segments(spot, plan.wall_segments).min()
        gaps = [gap - plan.wall_thickness / 2]
        for box in plan.furniture:
            gaps.append(distance_to_box(spot, box.center, box.size, box.angle)[0])
        return bool(min(gaps) >= BODY - ROUNDING)

    def connects(self, start: Floats, goal: Floats) -> bool:
        """Whether a body that fits at both points can walk from one to the other."""
        a, b = self.cell(start), self.cell(goal)
        fits = bool(self.free[a]) and bool(self.free[b])
        return fits and bool(self.parts[a] == self.parts[b])

    @cached_property
    def _indoors(self) -> Mask:
        return self.free & (self.parts != self.parts[0, 0])

    @cached_property
    def navigation(self) -> Navigation:
        """What paths are found with; all who walk through this home share it."""
        grid = Grid(self.free, self.parts, self._origin)
        return Navigation(grid, empty_cache(self._indoors))

    @cached_property
    def _find_path(self) -> Callable[[Point, Point, Waypoints, bool], int]:
        return bind(find_path, self.navigation)

    def plan(self, start: Point, goal: Point) -> list[Point]:
        """Waypoints of a short walk.

        Args:
            start: Where the walk begins [m].
            goal: Where it should end [m]; where no body fits, the nearest place
                where one does.

        Returns:
            Points [m] to walk to one after the other, the last one nearest to the
            goal. Empty if no path leads there.
        """
        points = np.zeros((ROOM, 2))
        count = self._find_path(start, goal, Waypoints(points, 0, 0), False)
        if count > len(points):
            points = np.zeros((count, 2))
            count = self._find_path(start, goal, Waypoints(points, 0, 0), False)
        return [(x, y) for x, y in points[:count].tolist()]


def _shifted(dx: int, dy: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Index pairs that line every cell up with its neighbor at (dx, dy)."""
    whole = slice(None)
    ahead, behind = slice(1, None), slice(None, -1)
    here_y, there_y = {0: (whole, whole), 1: (behind, ahead), -1: (ahead, behind)}[dy]
    here_x, there_x = (behind, ahead) if dx else (whole, whole)
    return (here_x, here_y), (there_x, there_y)


@lru_cache(maxsize=64)
def routes_of(plan: FloorPlan) -> Routes:
    """The routes of a floor plan, computed once per plan and process."""
    return Routes(plan)
