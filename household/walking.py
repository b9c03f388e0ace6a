"""Walking where nothing is in the way, without the physics engine.

A body that touches nothing goes on with its velocity; that takes no engine. Most steps
of most walks are such, and each call of the engine costs more than this whole loop.
"""

import numpy as np

from household.arrays import Floats, Indices, Mask
from household.compiled import compiled
from household.locomotion import follow_up, steer, within_reach
from household.solid import touches

MARGIN = 0.001
"""Bodies that come this near to each other [m] are left to the engine."""


@compiled
def walk_freely(
    position: Floats,
    velocity: Floats,
    heading: Floats,
    walking: Mask,
    nearest: Floats,
    stalled: Floats,
    speed: Floats,
    radius: Floats,
    segments: Floats,
    thickness: Floats,
    boxes: Floats,
    ticks: int,
    tick: float,
    points: Floats,
    at: Indices,
    count: Indices,
    quarry: Indices,
    reach: float,
    periods: int,
) -> tuple[int, bool]:
    """Lets walkers walk until somebody has something to decide, or may touch something.

    Args:
        position: Shape (n, 2) [m]; changed in place, as all that follow up to
            ``stalled``, and ``at``, where `steer` and `follow_up` say so.
        velocity: Of the last period, shape (n, 2) [m/s].
        heading: Shape (n,) [rad].
        walking: Shape (n,).
        nearest: How near each came to its waypoint, shape (n,) [m].
        stalled: Since how long each came no nearer, (n,) [s].
        speed: Of each that walks, shape (n,) [m/s].
        radius: Of each body, shape (n,) [m].
        segments: Everything solid, shape (m, 4), rows of x1, y1, x2, y2 [m].
        thickness: Its half thickness, shape (m,) [m].
        boxes: From `boxes_round`, shape (4, m) [m].
        ticks: Of the engine in each steering period.
        tick: Length of each [s].
        points: From `Ways`, shape (n, most, 2) [m].
        at: From `Ways`, shape (n,).
        count: From `Ways`, shape (n,).
        quarry: Whom each of the first bodies is after, `NOBODY` for none.
        reach: Distance from its quarry at which a body has something to decide [m].
        periods: How many steering periods to walk at most.

    Returns:
        How many periods have passed, and whether anybody is stuck. If no period has
        passed, the engine has to be asked.
    """
    period = ticks * tick
    near_quarry = np.empty(len(quarry), np.bool_)
    for passed in range(periods):
        steer(position, walking, speed, radius, period, heading, velocity, points, at)
        if not (
            _is_clear_of_walls(
                position, velocity, radius, segments, thickness, boxes, period
            )
            and _is_clear_of_others(position, velocity, radius, period)
        ):
            return passed, False
        before = position.copy()
        for _ in range(ticks):
            position += velocity * tick
        stuck, _ = follow_up(
            walking, nearest, stalled, period, before, position, points, at, count
        )
        if stuck or within_reach(position, quarry, reach, near_quarry):
            return passed + 1, stuck
    return periods, False


@compiled
def _is_clear_of_walls(
    position: Floats,
    velocity: Floats,
    radius: Floats,
    segments: Floats,
    thickness: Floats,
    boxes: Floats,
    period: float,
) -> bool:
    """Whether nobody who walks comes to touch anything solid."""
    for i in range(len(position)):
        x, y = position[i]
        to = (x + velocity[i, 0] * period, y + velocity[i, 1] * period)
        if to != (x, y) and touches(
            (x, y), to, radius[i] + MARGIN, segments, thickness, boxes
        ):
            return False
    return True


@compiled
def _is_clear_of_others(
    position: Floats, velocity: Floats, radius: Floats, period: float
) -> bool:
    """Whether nobody who walks comes to touch anybody."""
    for i in range(len(position)):
        if velocity[i, 0] == 0.0 and velocity[i, 1] == 0.0:
            continue
        for j in range(len(position)):
            apart = radius[i] + radius[j] + MARGIN
            if j != i and _least_gap(position, velocity, i, j, period) < apart:
                return False
    return True


@compiled
def _least_gap(
    position: Floats, velocity: Floats, i: int, j: int, period: float
) -> float:
    """The least distance between two middles while both go on for a period [m]."""
    ox, oy = position[j, 0] - position[i, 0], position[j, 1] - position[i, 1]
    vx, vy = velocity[j, 0] - velocity[i, 0], velocity[j, 1] - velocity[i, 1]
    fast = vx * vx + vy * vy
    when = 0.0
    if fast > 0.0:
        when = min(max(-(ox * vx + oy * vy) / fast, 0.0), period)
    ox, oy = ox + vx * when, oy + vy * when
    return np.sqrt(ox * ox + oy * oy)
