"""Gaze cones: what lies in somebody's field of view, cut at walls; for pictures."""

import math

import numpy as np

from household.compiled.arrays import Floats, Mask, Singles
from household.compiled.jit import compiled

RAYS = 11
"""Rays in a cone; 120 degrees of view are drawn in steps of 12 degrees."""

EDGE = 1e-6
"""By how much a field of view is widened where what lies beyond is left out [rad]."""


@compiled
def gaze_cones(
    position: Floats, gaze: Floats, half_view: Floats, segments: Floats, reach: float
) -> Singles:
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
    near, seen = np.empty((len(segments), 5)), np.empty(len(segments), np.bool_)
    # Plain rows of numbers: the processor looks at several at once.
    columns = segments.T.copy()
    dx, dy, free = np.empty(RAYS), np.empty(RAYS), np.empty(RAYS)
    for t in range(moments):
        for i in range(n):
            x, y, half = position[t, i, 0], position[t, i, 1], half_view[t, i]
            if t > 0 and _goes_on(position, gaze, half_view, t, i):
                outline[t, i] = outline[t - 1, i]
                continue
            outline[t, i, :, 0], outline[t, i, :, 1] = x, y
            if half < 0.0:
                continue
            count = _gather(x, y, gaze[t, i], half, columns, reach, seen, near)
            _aim(gaze[t, i], half, dx, dy)
            _cut(dx, dy, near, count, reach, free)
            for ray in range(RAYS):
                outline[t, i, ray + 1, 0] = x + free[ray] * dx[ray]
                outline[t, i, ray + 1, 1] = y + free[ray] * dy[ray]
    return outline


@compiled
def _goes_on(position: Floats, gaze: Floats, half_view: Floats, t: int, i: int) -> bool:
    """Whether somebody looks from where and to where it did the moment before."""
    return bool(
        position[t, i, 0] == position[t - 1, i, 0]
        and position[t, i, 1] == position[t - 1, i, 1]
        and gaze[t, i] == gaze[t - 1, i]
        and half_view[t, i] == half_view[t - 1, i]
    )


@compiled
def _aim(gaze: float, half: float, dx: Floats, dy: Floats) -> None:
    """Spreads rays over a field of view: unit vectors, from its right to its left."""
    dx[0], dy[0] = math.cos(gaze - half), math.sin(gaze - half)
    turn = 2.0 * half / (len(dx) - 1)
    along, across = math.cos(turn), math.sin(turn)
    for ray in range(1, len(dx)):
        dx[ray] = dx[ray - 1] * along - dy[ray - 1] * across
        dy[ray] = dx[ray - 1] * across + dy[ray - 1] * along


@compiled
def _gather(
    x: float,
    y: float,
    gaze: float,
    half: float,
    columns: Floats,
    reach: float,
    seen: Mask,
    near: Floats,
) -> int:
    """Copies the segments that could be seen to `near`; returns how many.

    There they are where they begin, as seen from (x, y), how they go on, and the
    product of the two. What lies wholly beyond one edge of the field of view, less
    than half a circle, cannot be in it.
    """
    lx, ly = math.cos(gaze + half + EDGE), math.sin(gaze + half + EDGE)
    rx, ry = math.cos(gaze - half - EDGE), math.sin(gaze - half - EDGE)
    wide = half + EDGE >= math.pi / 2
    for k in range(columns.shape[1]):
        ax, ay = columns[0, k] - x, columns[1, k] - y
        bx, by = columns[2, k] - x, columns[3, k] - y
        far = (min(ax, bx) > reach) | (max(ax, bx) < -reach)
        far |= (min(ay, by) > reach) | (max(ay, by) < -reach)
        beyond = (lx * ay > ly * ax) & (lx * by > ly * bx)
        beyond |= (rx * ay < ry * ax) & (rx * by < ry * bx)
        seen[k] = (not far) & (wide | (not beyond))
    count = 0
    for k in range(columns.shape[1]):
        if seen[k]:
            ax, ay = columns[0, k] - x, columns[1, k] - y
            ex, ey = columns[2, k] - columns[0, k], columns[3, k] - columns[1, k]
            near[count, 0], near[count, 1], near[count, 2] = ax, ay, ex
            near[count, 3], near[count, 4] = ey, ax * ey - ay * ex
            count += 1
    return count


@compiled
def _cut(
    dx: Floats, dy: Floats, near: Floats, count: int, reach: float, free: Floats
) -> None:
    """How far one sees in each unit direction (dx, dy), past what `_gather` found."""
    free[:] = reach
    for k in range(count):
        ax, ay, ex, ey, turned = near[k]
        for ray in range(len(dx)):
            cross = dx[ray] * ey - dy[ray] * ex
            aside = ax * dy[ray] - ay * dx[ray]
            # On the line, in front and between its ends: told without a branch.
            hit = (abs(aside) <= abs(cross)) & (aside * cross >= 0.0)
            hit &= (turned * cross >= 0.0) & (cross != 0.0)
            away = turned / cross
            free[ray] = away if hit & (away < free[ray]) else free[ray]
