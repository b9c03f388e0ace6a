"""Steering: from the next waypoint to the velocity of this moment, without bumping.

Compiled with Numba, as it runs several times in each decision, over all pairs of
bodies.
"""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import compiled
from household.config.toml import Point
from household.motion.bodies import Bodies, Walks
from household.motion.paths import Paths

COMFORT = 0.5
"""Gap between bodies below which a walker gives way [m] (our choice)."""

MARGIN = 0.001
"""Bodies that come this near to each other [m] are left to the engine."""

ATTEMPTS = 3
"""How often a walker tries to get round all who are close, before it waits."""

PUSHY = 0.5
"""Time without progress after which a walker pushes those in its way [s]."""


class Close(NamedTuple):
    """Who is close to a walker, and where; as many elements as there are bodies.

    Attributes:
        near: Whether each body is close.
        who: Indices of those who are; ``x``, ``y`` and ``gap`` are in their order.
        x: From the middle of the walker to theirs [m].
        y: Likewise.
        gap: Between the walker and each [m].
    """

    near: Mask
    who: Indices
    x: Floats
    y: Floats
    gap: Floats


@compiled
def steer(bodies: Bodies, walks: Walks, period: float, paths: Paths) -> None:
    """Sets velocities that lead walkers to their waypoints, keeping to the right.

    A walker slows down only to end on its waypoint. Where a body is in its way, it
    turns to its right in proportion to how near that body is, so that two walkers who
    meet pass each other. It does not walk into others, unless it has come no nearer to
    its waypoint for a while.

    Args:
        bodies: Their velocities are set, to 0 for those who stand; walkers come to face
            where they go.
        walks: Who walks, and since when without coming nearer to its waypoint.
        period: Time until the next steering [s].
        paths: Of all bodies.
    """
    position, heading, velocity = bodies.position, bodies.heading, bodies.velocity
    radius, speed, points, at = bodies.radius, bodies.speed, paths.points, paths.at
    walking, stalled = walks.walking, walks.stalled
    velocity[:] = 0.0
    n = len(position)
    close = Close(
        np.empty(n, np.bool_),
        np.empty(n, np.intp),
        np.empty(n),
        np.empty(n),
        np.empty(n),
    )
    # Plain rows of numbers: the processor looks at several at once.
    xs, ys = position[:, 0].copy(), position[:, 1].copy()
    for i in range(n):
        if not walking[i]:
            continue
        dx, dy = points[i, at[i], 0] - xs[i], points[i, at[i], 1] - ys[i]
        away = np.sqrt(dx * dx + dy * dy)
        if away < 1e-9:
            continue
        dx /= away
        dy /= away
        count = _find_close(xs, ys, radius, i, close)
        turn = 0.0
        for k in range(count):
            ahead = close.x[k] * dx + close.y[k] * dy
            if 0.0 < ahead < away and close.gap[k] < COMFORT:
                turn = max(turn, 1.0 - max(close.gap[k], 0.0) / COMFORT)
        pace = min(speed[i], away / period)
        vx, vy = dx + turn * dy, dy - turn * dx
        norm = np.sqrt(vx * vx + vy * vy)
        vx, vy = pace * vx / norm, pace * vy / norm
        if stalled[i] < PUSHY:
            vx, vy = _given_way(walking, radius, period, i, close, count, (vx, vy))
        velocity[i, 0], velocity[i, 1] = vx, vy
        if vx != 0.0 or vy != 0.0:
            heading[i] = np.arctan2(vy, vx)


@compiled
def _find_close(xs: Floats, ys: Floats, radius: Floats, i: int, close: Close) -> int:
    """Lists the bodies that are close to one, and returns how many these are."""
    for j in range(len(xs)):
        reach = COMFORT + radius[i] + radius[j]
        close.near[j] = (abs(xs[j] - xs[i]) <= reach) & (abs(ys[j] - ys[i]) <= reach)
    close.near[i] = False
    count = 0
    for j in range(len(xs)):
        if close.near[j]:
            x, y = xs[j] - xs[i], ys[j] - ys[i]
            close.who[count], close.x[count], close.y[count] = j, x, y
            close.gap[count] = np.sqrt(x * x + y * y) - radius[i] - radius[j]
            count += 1
    return count


@compiled
def _given_way(
    walking: Mask,
    radius: Floats,
    period: float,
    i: int,
    close: Close,
    count: int,
    wanted: Point,
) -> Point:
    """Takes from a velocity what would lead into others; 0 where all sides are blocked.

    Of two walkers each may use half the gap between them, so that both together cannot
    meet whatever the other does (reciprocal avoidance, van den Berg et al. 2011).

    Args:
        walking: Whether each body walks, shape (n,).
        radius: Of each body, shape (n,) [m].
        period: Time until the next steering [s].
        i: Index of the walker.
        close: Who is close to it; changed in place.
        count: How many are close.
        wanted: The velocity with nobody in the way [m/s].

    Returns:
        The velocity [m/s].
    """
    vx, vy = wanted
    for k in range(count):
        j, gap = close.who[k], close.gap[k]
        away, left = gap + radius[i] + radius[j], gap - 2 * MARGIN
        # From here on the direction to each, and how fast the walker may go there.
        close.x[k] /= away
        close.y[k] /= away
        close.gap[k] = (left / 2 if walking[j] else left) / period
        if away < 1e-9:
            close.gap[k] = np.inf
    for _ in range(ATTEMPTS):
        clear = True
        for k in range(count):
            too_fast = close.x[k] * vx + close.y[k] * vy - close.gap[k]
            if too_fast > 1e-9:
                vx -= too_fast * close.x[k]
                vy -= too_fast * close.y[k]
                clear = False
        if clear:
            return vx, vy
    return 0.0, 0.0
