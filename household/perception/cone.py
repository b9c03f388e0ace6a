"""Gaze cones: what lies in somebody's field of view, cut at walls; for pictures."""

import math

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled

Array = NDArray[np.float64]
Drawn = NDArray[np.float32]

RAYS = 11
"""Rays in a cone; 120 degrees of view are drawn in steps of 12 degrees."""

EDGE = 1e-6
"""By how much a field of view is widened where what lies beyond is left out [rad]."""


@compiled
def gaze_cones(
    position: Array, gaze: Array, half_view: Array, segments: Array, reach: float
) -> Drawn:
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
    outline = np.empty((moments, n, RAYS + 2, 2), np.float32)
    near = np.empty((len(segments), 5))
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
                for point in range(RAYS + 2):
                    outline[t, i, point, 0] = outline[t - 1, i, point, 0]
                    outline[t, i, point, 1] = outline[t - 1, i, point, 1]
                continue
            for point in range(RAYS + 2):
                outline[t, i, point, 0] = x
                outline[t, i, point, 1] = y
            if half < 0.0:
                continue
            count = _gather(x, y, gaze[t, i], half, segments, reach, near)
            dx, dy = math.cos(gaze[t, i] - half), math.sin(gaze[t, i] - half)
            turn = 2.0 * half / (RAYS - 1)
            along, across = math.cos(turn), math.sin(turn)
            for ray in range(RAYS):
                free = _free(dx, dy, near, count, reach)
                outline[t, i, ray + 1, 0] = x + free * dx
                outline[t, i, ray + 1, 1] = y + free * dy
                dx, dy = dx * along - dy * across, dx * across + dy * along
    return outline


@compiled
def _gather(
    x: float,
    y: float,
    gaze: float,
    half: float,
    segments: Array,
    reach: float,
    near: Array,
) -> int:
    """Copies the segments that could be seen to `near`; returns how many.

    There they are where they begin, as seen from (x, y), how they go on, and the
    product of the two. What lies wholly beyond one edge of the field of view, less
    than half a circle, cannot be in it.
    """
    lx, ly = math.cos(gaze + half + EDGE), math.sin(gaze + half + EDGE)
    rx, ry = math.cos(gaze - half - EDGE), math.sin(gaze - half - EDGE)
    narrow = half + EDGE < math.pi / 2
    count = 0
    for k in range(segments.shape[0]):
        ax, ay = segments[k, 0] - x, segments[k, 1] - y
        bx, by = segments[k, 2] - x, segments[k, 3] - y
        if (
            (ax > reach and bx > reach)
            or (ax < -reach and bx < -reach)
            or (ay > reach and by > reach)
            or (ay < -reach and by < -reach)
        ):
            continue
        if narrow and (
            (lx * ay > ly * ax and lx * by > ly * bx)
            or (rx * ay < ry * ax and rx * by < ry * bx)
        ):
            continue
        ex, ey = segments[k, 2] - segments[k, 0], segments[k, 3] - segments[k, 1]
        near[count, 0], near[count, 1], near[count, 2] = ax, ay, ex
        near[count, 3], near[count, 4] = ey, ax * ey - ay * ex
        count += 1
    return count


@compiled
def _free(dx: float, dy: float, near: Array, count: int, reach: float) -> float:
    """How far one sees in the unit direction (dx, dy), past what `_gather` found."""
    free = reach
    for k in range(count):
        cross = dx * near[k, 3] - dy * near[k, 2]
        aside = near[k, 0] * dy - near[k, 1] * dx
        # On the line, in front and between its ends, told without a division; without
        # a jump, too, as what is hit is hard to foresee.
        ahead = near[k, 4] * cross >= 0.0
        on = (abs(aside) <= abs(cross)) & (aside * cross >= 0.0) & ahead
        if on & (cross != 0.0):
            free = min(free, near[k, 4] / cross)
    return free
