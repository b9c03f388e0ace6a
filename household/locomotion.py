"""Walking: from the next waypoint to the velocity of this moment.

Compiled with Numba for the same reason as the perception kernel: it runs several
times in each decision, over all pairs of bodies.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

Array = NDArray[np.float64]

COMFORT = 0.5
"""Gap between bodies below which a walker gives way [m] (our choice)."""


@njit(cache=True)
def steer(
    position: Array, waypoint: Array, speed: Array, radius: Array, period: float
) -> Array:
    """Velocities that lead walkers to their waypoints, keeping to the right.

    A walker slows down only to end on its waypoint. Where a body is in its way, it
    turns to its right in proportion to how near that body is, so that two who meet
    pass each other.

    Args:
        position: Shape (n, 2) [m].
        waypoint: Where each is heading, shape (n, 2) [m].
        speed: Shape (n,) [m/s]; 0: stands.
        radius: Of each body, shape (n,) [m].
        period: Time until the next steering [s].

    Returns:
        Shape (n, 2) [m/s].
    """
    n = position.shape[0]
    velocity = np.zeros((n, 2))
    for i in range(n):
        dx = waypoint[i, 0] - position[i, 0]
        dy = waypoint[i, 1] - position[i, 1]
        away = np.sqrt(dx * dx + dy * dy)
        if speed[i] <= 0.0 or away < 1e-9:
            continue
        dx /= away
        dy /= away
        pace = min(speed[i], away / period)
        turn = 0.0
        for j in range(n):
            if j == i:
                continue
            ox = position[j, 0] - position[i, 0]
            oy = position[j, 1] - position[i, 1]
            gap = np.sqrt(ox * ox + oy * oy) - radius[i] - radius[j]
            if 0.0 < ox * dx + oy * dy < away and gap < COMFORT:
                turn = max(turn, 1.0 - max(gap, 0.0) / COMFORT)
        vx = dx + turn * dy
        vy = dy - turn * dx
        norm = np.sqrt(vx * vx + vy * vy)
        velocity[i, 0] = pace * vx / norm
        velocity[i, 1] = pace * vy / norm
    return velocity
