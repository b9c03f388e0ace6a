"""Steering: from the next waypoint to the velocity of this moment, without bumping.

Compiled with Numba for the same reason as the perception kernel: it runs several
times in each decision, over all pairs of bodies.
"""

import numpy as np

from household.arrays import Floats, Indices, Mask
from household.compiled import compiled

COMFORT = 0.5
"""Gap between bodies below which a walker gives way [m] (our choice)."""

MARGIN = 0.001
"""Bodies that come this near to each other [m] are left to the engine."""

ATTEMPTS = 3
"""How often a walker tries to go round everybody who is close, before it waits."""

PUSHY = 0.5
"""Time without progress after which a walker pushes who stands in its way [s]."""


@compiled
def steer(
    position: Floats,
    walking: Mask,
    stalled: Floats,
    speed: Floats,
    radius: Floats,
    period: float,
    heading: Floats,
    velocity: Floats,
    points: Floats,
    at: Indices,
) -> None:
    """Sets velocities that lead walkers to their waypoints, keeping to the right.

    A walker slows down only to end on its waypoint. Where a body is in its way, it
    turns to its right in proportion to how near that body is, so that two who meet
    pass each other. It does not walk into anybody, unless it got no further for a
    while.

    Args:
        position: Shape (n, 2) [m].
        walking: Shape (n,).
        stalled: Since how long each came no nearer, (n,) [s].
        speed: Of each that walks, shape (n,) [m/s].
        radius: Of each body, shape (n,) [m].
        period: Time until the next steering [s].
        heading: Where every body faces, shape (n,) [rad]; walkers come to face, in
            place, where they go.
        velocity: Set to what each walks with, 0 who stands, shape (n, 2) [m/s].
        points: From `Ways`, shape (n, most, 2) [m].
        at: From `Ways`, shape (n,).
    """
    velocity[:] = 0.0
    close = np.empty(len(position), np.intp)
    for i in range(len(position)):
        if not walking[i]:
            continue
        dx = points[i, at[i], 0] - position[i, 0]
        dy = points[i, at[i], 1] - position[i, 1]
        away = np.sqrt(dx * dx + dy * dy)
        if away < 1e-9:
            continue
        dx /= away
        dy /= away
        pace, turn = min(speed[i], away / period), 0.0
        count = _find_close(position, radius, i, close)
        for j in close[:count]:
            ox, oy, gap = _gap(position, radius, i, j)
            if 0.0 < ox * dx + oy * dy < away and gap < COMFORT:
                turn = max(turn, 1.0 - max(gap, 0.0) / COMFORT)
        vx = dx + turn * dy
        vy = dy - turn * dx
        norm = np.sqrt(vx * vx + vy * vy)
        velocity[i, 0] = pace * vx / norm
        velocity[i, 1] = pace * vy / norm
        if stalled[i] < PUSHY:
            _give_way(position, walking, radius, period, i, close[:count], velocity[i])
        if velocity[i, 0] != 0.0 or velocity[i, 1] != 0.0:
            heading[i] = np.arctan2(velocity[i, 1], velocity[i, 0])


@compiled
def _find_close(position: Floats, radius: Floats, i: int, close: Indices) -> int:
    """Lists who is close to a body, or nearly so; returns how many that are."""
    count = 0
    for j in range(len(position)):
        near = COMFORT + radius[i] + radius[j]
        close[count] = j
        count += (
            (j != i)
            & (abs(position[j, 0] - position[i, 0]) <= near)
            & (abs(position[j, 1] - position[i, 1]) <= near)
        )
    return count


@compiled
def _gap(
    position: Floats, radius: Floats, i: int, j: int
) -> tuple[float, float, float]:
    """From the middle of one body to that of another, and the gap between them [m]."""
    ox, oy = position[j, 0] - position[i, 0], position[j, 1] - position[i, 1]
    return ox, oy, np.sqrt(ox * ox + oy * oy) - radius[i] - radius[j]


@compiled
def _give_way(
    position: Floats,
    walking: Mask,
    radius: Floats,
    period: float,
    i: int,
    close: Indices,
    velocity: Floats,
) -> None:
    """Takes from a velocity what would lead into others; who is hemmed in waits.

    Of two walkers each may use half the gap between them, so that both together cannot
    meet whatever the other does (reciprocal avoidance, van den Berg et al. 2011).
    """
    for _ in range(ATTEMPTS):
        clear = True
        for j in close:
            ox, oy, gap = _gap(position, radius, i, j)
            away = gap + radius[i] + radius[j]
            if away < 1e-9:
                continue
            ox, oy, left = ox / away, oy / away, gap - 2 * MARGIN
            most = (left / 2 if walking[j] else left) / period
            too_fast = ox * velocity[0] + oy * velocity[1] - most
            if too_fast > 1e-9:
                velocity[0] -= too_fast * ox
                velocity[1] -= too_fast * oy
                clear = False
        if clear:
            return
    velocity[:] = 0.0
