"""Gaze cones: what lies in somebody's field of view, cut at walls; for pictures."""

import math
from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Mask, Singles
from household.compiled.jit import compiled, compiled_aside

RAYS = 11
"""Rays in a cone; 120 degrees of view are drawn in steps of 12 degrees."""

EDGE = 1e-6
"""By how much a field of view is widened where what lies beyond is left out [rad]."""


class Eye(NamedTuple):
    """Where somebody stands and what is in its field of view.

    Attributes:
        x: [m].
        y: [m].
        gaze: Where the head points [rad].
        half: Half the field of view [rad].
    """

    x: float
    y: float
    gaze: float
    half: float


class Rays(NamedTuple):
    """The rays of a cone, from its right to its left.

    Attributes:
        dx: Unit vectors, shape (RAYS,).
        dy: Shape (RAYS,).
        free: How far each goes, shape (RAYS,) [m].
    """

    dx: Floats
    dy: Floats
    free: Floats


class Blocks(NamedTuple):
    """What blocks sight.

    Attributes:
        columns: The segments, shape (4, m), columns of x1, y1, x2, y2 [m].
        seen: Which of them could be seen from an eye, shape (m,).
        near: Those of them, as seen from there: where each begins, how it goes on, and
            the product of the two, shape (m, 5).
    """

    columns: Floats
    seen: Mask
    near: Floats


@compiled_aside
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
    m = len(segments)
    outline = np.empty((moments, n, RAYS + 2, 2), np.float32)
    # Plain rows of numbers: the processor looks at several at once.
    blocks = Blocks(segments.T.copy(), np.empty(m, np.bool_), np.empty((m, 5)))
    rays = Rays(np.empty(RAYS), np.empty(RAYS), np.empty(RAYS))
    for t in range(moments):
        for i in range(n):
            x, y, half = position[t, i, 0], position[t, i, 1], half_view[t, i]
            if t > 0 and _goes_on(position, gaze, half_view, t, i):
                outline[t, i] = outline[t - 1, i]
                continue
            outline[t, i, :, 0], outline[t, i, :, 1] = x, y
            if half < 0.0:
                continue
            eye = Eye(x, y, gaze[t, i], half)
            _aim(eye, rays)
            _cut(rays, blocks.near[: _gather(eye, blocks, reach)], reach)
            for ray in range(RAYS):
                outline[t, i, ray + 1, 0] = x + rays.free[ray] * rays.dx[ray]
                outline[t, i, ray + 1, 1] = y + rays.free[ray] * rays.dy[ray]
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
def _aim(eye: Eye, rays: Rays) -> None:
    """Spreads rays over a field of view."""
    dx, dy = rays.dx, rays.dy
    dx[0], dy[0] = math.cos(eye.gaze - eye.half), math.sin(eye.gaze - eye.half)
    turn = 2.0 * eye.half / (len(dx) - 1)
    along, across = math.cos(turn), math.sin(turn)
    for ray in range(1, len(dx)):
        dx[ray] = dx[ray - 1] * along - dy[ray - 1] * across
        dy[ray] = dx[ray - 1] * across + dy[ray - 1] * along


@compiled
def _gather(eye: Eye, blocks: Blocks, reach: float) -> int:
    """Finds the segments that could be seen from an eye; returns how many.

    What lies wholly beyond one edge of the field of view, less than half a circle,
    cannot be in it.
    """
    columns, seen, near = blocks.columns, blocks.seen, blocks.near
    x, y, gaze, half = eye
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
def _cut(rays: Rays, near: Floats, reach: float) -> None:
    """Cuts rays off at the segments that `_gather` found, and at their reach."""
    dx, dy, free = rays.dx, rays.dy, rays.free
    free[:] = reach
    for k in range(len(near)):
        ax, ay, ex, ey, turned = near[k]
        for ray in range(len(dx)):
            cross = dx[ray] * ey - dy[ray] * ex
            aside = ax * dy[ray] - ay * dx[ray]
            # On the line, in front and between its ends: found without a branch.
            hit = (abs(aside) <= abs(cross)) & (aside * cross >= 0.0)
            hit &= (turned * cross >= 0.0) & (cross != 0.0)
            away = turned / cross
            free[ray] = away if hit & (away < free[ray]) else free[ray]
