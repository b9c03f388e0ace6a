"""Plane geometry of walls and furniture: distances and crossings."""

import math

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled


@compiled
def crosses(ax: float, ay: float, bx: float, by: float, segment: Floats) -> bool:
    """Whether the line from a to b crosses a segment (x1, y1, x2, y2)."""
    x1, y1, x2, y2 = segment
    dx, dy = bx - ax, by - ay
    side1 = dx * (y1 - ay) - dy * (x1 - ax)
    side2 = dx * (y2 - ay) - dy * (x2 - ax)
    if side1 * side2 > 0.0:
        return False
    ex, ey = x2 - x1, y2 - y1
    side3 = ex * (ay - y1) - ey * (ax - x1)
    side4 = ex * (by - y1) - ey * (bx - x1)
    return side3 * side4 <= 0.0 and side1 != side2


def distance_to_segments(points: Floats, segments: Floats) -> Floats:
    """Distance from each point to each segment.

    Args:
        points: Shape (n, 2) [m].
        segments: Shape (m, 4), rows of x1, y1, x2, y2 [m].

    Returns:
        Shape (n, m) [m].
    """
    start, along = segments[:, :2], segments[:, 2:] - segments[:, :2]
    offset = points[:, None, :] - start
    length2 = np.maximum((along**2).sum(axis=1), 1e-12)
    share = np.clip((offset * along).sum(axis=2) / length2, 0.0, 1.0)
    gap: Floats = np.linalg.norm(offset - share[..., None] * along, axis=2)
    return gap


def distance_to_box(
    points: Floats, center: tuple[float, float], size: tuple[float, float], angle: float
) -> Floats:
    """Distance from each point to a rotated box; 0 inside.

    Args:
        points: Shape (n, 2) [m].
        center: Middle of the box [m].
        size: Width and depth [m].
        angle: Rotation [degrees].

    Returns:
        Shape (n,) [m].
    """
    # Step by step: NumPy's sine and product round otherwise on other processors.
    turn = math.radians(angle)
    cos, sin = math.cos(turn), math.sin(turn)
    x, y = (points - np.array(center)).T
    local = np.column_stack((x * cos + y * sin, y * cos - x * sin))
    outside = np.maximum(np.abs(local) - np.array(size) / 2, 0.0)
    gap: Floats = np.hypot(outside[:, 0], outside[:, 1])
    return gap
