"""Walking where nobody is in the way, without the physics engine.

A body that touches nobody goes on with its velocity, or along a wall; that takes no
engine. Most steps of most walks are such, and each call of the engine costs more than
this whole loop.
"""

import numpy as np

from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import compiled
from household.motion.collision import keep_out
from household.motion.progress import follow_up, within_reach
from household.motion.steering import MARGIN, steer


@compiled
def walk_freely(
    position: Floats,
    velocity: Floats,
    heading: Floats,
    walking: Mask,
    nearest: Floats,
    stalled: Floats,
    settled: Floats,
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
    target: Indices,
    reach: float,
    periods: int,
    pressed: bool,
) -> tuple[int, bool]:
    """Lets walkers walk until somebody has something to decide, or may touch another.

    Args:
        position: Shape (n, 2) [m]; changed in place, as all that follow up to
            ``settled``, and ``at``, where `steer` and `follow_up` say so.
        velocity: Of the last period, shape (n, 2) [m/s].
        heading: Shape (n,) [rad].
        walking: Shape (n,).
        nearest: How near each came to its waypoint, shape (n,) [m].
        stalled: Since how long each came no nearer, (n,) [s].
        settled: The goal that others kept each from, NaN if none, shape (n, 2) [m].
        speed: Of each that walks, shape (n,) [m/s].
        radius: Of each body, shape (n,) [m].
        segments: Everything solid, shape (m, 4), rows of x1, y1, x2, y2 [m].
        thickness: Its half thickness, shape (m,) [m].
        boxes: From `boxes_round`, shape (4, m) [m].
        ticks: Of the engine in each steering period.
        tick: Length of each [s].
        points: From `Paths`, shape (n, most, 2) [m].
        at: From `Paths`, shape (n,).
        count: From `Paths`, shape (n,).
        target: Whom each of the first bodies is after, `NOBODY` for none.
        reach: Distance from its target at which a body has something to decide [m].
        periods: How many steering periods to walk at most.
        pressed: Whether bodies press each other that stand.

    Returns:
        How many periods have passed, and whether anybody is stuck. If no period has
        passed, the engine has to be asked.
    """
    period = ticks * tick
    before, near_quarry = np.empty_like(position), np.empty(len(target), np.bool_)
    for passed in range(periods):
        steer(
            position,
            walking,
            stalled,
            speed,
            radius,
            period,
            heading,
            velocity,
            points,
            at,
        )
        if pressed or not _is_clear_of_others(position, velocity, radius, period):
            return passed, False
        before[:] = position
        for _ in range(ticks):
            position += velocity * tick
        keep_out(radius, segments, thickness, boxes, before, position)
        stuck = follow_up(
            walking,
            nearest,
            stalled,
            settled,
            radius,
            period,
            position,
            points,
            at,
            count,
        )
        if stuck or within_reach(position, target, reach, near_quarry):
            return passed + 1, stuck
    return periods, False


@compiled
def _is_clear_of_others(
    position: Floats, velocity: Floats, radius: Floats, period: float
) -> bool:
    """Whether nobody who walks comes to touch anybody.

    Two that part from each other may still touch.
    """
    xs, ys = position[:, 0].copy(), position[:, 1].copy()
    us, vs = velocity[:, 0].copy(), velocity[:, 1].copy()
    for i in range(len(position)):
        if us[i] == 0.0 and vs[i] == 0.0:
            continue
        meets = False
        # Without a branch: the processor looks at several at once.
        for j in range(len(position)):
            ox, oy, wx, wy = xs[j] - xs[i], ys[j] - ys[i], us[j] - us[i], vs[j] - vs[i]
            nearing, fast = -(ox * wx + oy * wy), wx * wx + wy * wy
            # How far from each other they are when they come nearest.
            when = nearing / fast if fast > 0.0 else 0.0
            when = period if when > period else when
            ox, oy = ox + wx * when, oy + wy * when
            apart = radius[i] + radius[j] + MARGIN
            meets |= (nearing > 0.0) & (ox * ox + oy * oy < apart * apart)
        if meets:
            return False
    return True
