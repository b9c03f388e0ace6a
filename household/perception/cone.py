"""Gaze cones: what lies in somebody's field of view, cut at walls; for pictures."""

import math

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled

Array = NDArray[np.float64]

RAYS = 13
"""Rays in a cone; 120 degrees of view are drawn in steps of 10 degrees."""


@compiled
def gaze_cones(
    position: Array, gaze: Array, half_view: Array, segments: Array, reach: float
) -> Array:
    """The outline of everybody's field of view at several moments.

    Args:
        position: Shape (n_moments, n, 2) [m].
        gaze: Shape (n_moments, n) [rad].
        half_view: Half the field of view, (n_moments, n) [rad]; negative: eyes closed.
        segments: What blocks sight, shape (m, 4), rows of x1, y1, x2, y2 [m].
        reach: How far the cone is drawn where nothing is in the way [m].

    Returns:
        Shape (n_moments, n, RAYS + 2, 2) [m]: closed outlines that begin and end at
        the eye. With closed eyes all points are there.
    """
    moments, n = gaze.shape
    outline = np.empty((moments, n, RAYS + 2, 2))
    near = np.empty_like(segments)
    for t in range(moments):
        for i in range(n):
            x, y, half = position[t, i, 0], position[t, i, 1], half_view[t, i]
            if (
                t > 0
                and x == position[t - 1, i, 0]
                and y == position[t - 1, i, 1]
                and gaze[t, i] == gaze[t - 1, i]
                and half == half_view[t - 1, i]
            ):
                outline[t, i] = outline[t - 1, i]
                continue
            outline[t, i, :, 0] = x
            outline[t, i, :, 1] = y
            if half < 0.0:
                continue
            count = _gather(x, y, segments, reach, near)
            for ray in range(RAYS):
                angle = gaze[t, i] + half * (2.0 * ray / (RAYS - 1) - 1.0)
                dx, dy = math.cos(angle), math.sin(angle)
                free = _free(x, y, dx, dy, near[:count], reach)
                outline[t, i, ray + 1, 0] = x + free * dx
                outline[t, i, ray + 1, 1] = y + free * dy
    return outline


@compiled
def _gather(x: float, y: float, segments: Array, reach: float, near: Array) -> int:
    """Copies the segments that could be within reach to `near`; returns how many."""
    count = 0
    for k in range(segments.shape[0]):
        x1, y1, x2, y2 = segments[k]
        if (
            min(x1, x2) <= x + reach
            and max(x1, x2) >= x - reach
            and min(y1, y2) <= y + reach
            and max(y1, y2) >= y - reach
        ):
            near[count] = segments[k]
            count += 1
    return count


@compiled
def _free(
    x: float, y: float, dx: float, dy: float, segments: Array, reach: float
) -> float:
    """How far one sees from (x, y) in the unit direction (dx, dy)."""
    free = reach
    for k in range(segments.shape[0]):
        ax, ay = segments[k, 0] - x, segments[k, 1] - y
        ex, ey = segments[k, 2] - segments[k, 0], segments[k, 3] - segments[k, 1]
        cross = dx * ey - dy * ex
        if cross == 0.0:
            continue
        along = (ax * ey - ay * ex) / cross
        across = (ax * dy - ay * dx) / cross
        if 0.0 <= along < free and 0.0 <= across <= 1.0:
            free = along
    return free
