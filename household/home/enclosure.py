"""Enclosure: what of a plan is outdoors, found out on a fine grid."""

import math

import numpy as np
from scipy.ndimage import label

from household.compiled.arrays import Floats, Indices, Mask
from household.config.toml import Point
from household.home.floorplan import Door, FloorPlan
from household.home.navigation.cells import mark_near_segment

FINE = 0.05
"""Cell [m] of the search for gaps: half the usual wall, so that no wall leaks."""

RIM = 6
"""Cells round the plan, so that all that is outdoors hangs together."""


def outdoors(plan: FloorPlan, segments: Floats) -> Mask:
    """Marks the cells of a fine grid that can be reached from outside the walls.

    Args:
        plan: The home.
        segments: What is in the way, shape (n, 4), rows of x1, y1, x2, y2 [m].
    """
    reach = max(plan.wall_thickness / 2, FINE)
    last = _cell(plan, plan.upper)
    solid = np.zeros((last[0] + RIM + 1, last[1] + RIM + 1), dtype=np.bool_)
    for segment in segments:
        mark_near_segment(solid, plan.lower, FINE, segment, reach, rim=RIM)
    parts, _ = label(~solid)
    marked: Mask = parts == parts[0, 0]
    return marked


def is_outdoors(plan: FloorPlan, marked: Mask, point: Point) -> bool:
    """Whether a point [m] is in one of the cells that `outdoors` marked."""
    cell = np.clip(_cell(plan, np.array(point)), 0, np.array(marked.shape) - 1)
    return bool(marked[tuple(cell)])


def _cell(plan: FloorPlan, point: Floats) -> Indices:
    """Indices of the fine cell that holds a point."""
    cell: Indices = np.floor((point - plan.lower) / FINE).astype(int) + RIM
    return cell


def middle_of(door: Door) -> Point:
    """The middle of a door's leaf [m]."""
    return (door.start[0] + door.end[0]) / 2, (door.start[1] + door.end[1]) / 2


def sides_of(plan: FloorPlan, door: Door) -> tuple[Point, Point]:
    """A point just off either face of a door's leaf [m]."""
    (x, y), width = middle_of(door), math.dist(door.start, door.end)
    reach = (plan.wall_thickness / 2 + 4 * FINE) / width
    dx = (door.start[1] - door.end[1]) * reach
    dy = (door.end[0] - door.start[0]) * reach
    return (x + dx, y + dy), (x - dx, y - dy)
