"""Walking where nobody is in the way, without the physics engine.

A body that touches nobody goes on with its velocity, or along a wall; no engine is
needed for that. Most steps of most walks are such, and one call of the engine takes
longer than this whole loop.
"""

from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.motion.bodies import Bodies, Pursuit, Walks
from household.motion.collision import Obstacles, keep_out
from household.motion.paths import Paths
from household.motion.progress import follow_up, within_reach
from household.motion.steering import MARGIN, steer


class Ticks(NamedTuple):
    """How time passes in a steering period.

    Attributes:
        number: Of ticks of the physics engine in each period.
        duration: Of each tick [s].
    """

    number: int
    duration: float


@compiled
def walk_freely(
    bodies: Bodies,
    walks: Walks,
    obstacles: Obstacles,
    ticks: Ticks,
    paths: Paths,
    pursuit: Pursuit,
    periods: int,
) -> tuple[int, bool]:
    """Lets walkers walk until somebody has something to decide, or may touch another.

    Args:
        bodies: Moved in place.
        walks: Brought up to date in place.
        obstacles: Of the home.
        ticks: Of each steering period.
        paths: Which waypoint each walks to is changed in place.
        pursuit: A body that comes within reach of its target has something to decide.
        periods: How many steering periods to walk at most.

    Returns:
        How many periods have passed, and whether anybody is stuck. If fewer have passed
        although nobody has anything to decide, bodies may touch in the next period: all
        have their velocities for it, and the engine has to move them.
    """
    radius, position, velocity = bodies.radius, bodies.position, bodies.velocity
    period = ticks.number * ticks.duration
    before = np.empty_like(position)
    near_target = np.empty(len(pursuit.target), np.bool_)
    for passed in range(periods):
        steer(bodies, walks, period, paths)
        if not _is_clear_of_others(position, velocity, radius, period):
            return passed, False
        before[:] = position
        for _ in range(ticks.number):
            position += velocity * ticks.duration
        keep_out(radius, obstacles, before, position)
        stuck = follow_up(bodies, walks, period, paths)
        if stuck or within_reach(position, pursuit.target, pursuit.reach, near_target):
            return passed + 1, stuck
    return periods, False


@compiled
def _is_clear_of_others(
    position: Floats, velocity: Floats, radius: Floats, period: float
) -> bool:
    """Whether no walker comes to touch another body; bodies that part may touch."""
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
