"""Progress of walks: who has arrived, who is stuck, and who needs another path.

Compiled with Numba, as it runs several times in each decision, over all pairs of
bodies.
"""

from typing import Annotated

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import compiled
from household.config.toml import Point
from household.motion.bodies import Bodies, Goals, Walks
from household.motion.paths import Paths, goal_of

PROGRESS = 0.05
"""How much nearer to its waypoint a walker must come not to be stuck [m]."""

STUCK = 2.0
"""Time without progress after which a walker tries another path [s]."""

DRIFT = 0.1
"""How far a body lets itself be pushed before it steps back to its place [m]."""

CROWDED = 1.0
"""Where others stand in its place, a walker settles for this near to it [m]."""

PASSED = 0.15
"""Distance at which a waypoint that is not the last counts as passed [m]."""

ARRIVED = 0.05
"""Distance at which a walk ends [m]."""

TOUCH = 0.01
"""Gap between bodies that touch, at most [m]."""

OVERLAP = 0.003
"""How deep standing bodies may overlap without being pushed apart [m]; the engine parts
them ever more slowly."""


@compiled
def follow_up(bodies: Bodies, walks: Walks, period: float, paths: Paths) -> bool:
    """Notes how every walker came on: at its waypoint it turns to the next one.

    A walker that comes no nearer because another body stands on its goal has arrived.

    Args:
        bodies: Where they have come to.
        walks: Brought up to date in place.
        period: Time since this was last done [s].
        paths: Which waypoint each walks to is changed in place.

    Returns:
        Whether anybody is stuck.
    """
    position, radius, walking = bodies.position, bodies.radius, walks.walking
    nearest, stalled = walks.nearest, walks.stalled
    points, at, length = paths.points, paths.at, paths.length
    stuck = False
    for i in range(len(position)):
        if not walking[i]:
            continue
        wx = points[i, at[i], 0] - position[i, 0]
        wy = points[i, at[i], 1] - position[i, 1]
        left = np.sqrt(wx * wx + wy * wy)
        if left <= (PASSED if at[i] + 1 < length[i] else ARRIVED):
            at[i] += 1
            walking[i] = at[i] < length[i]
            nearest[i], stalled[i] = np.inf, 0.0
        elif left < nearest[i] - PROGRESS:
            # The first look after a detour begins is not progress yet.
            stalled[i] = 0.0 if nearest[i] < np.inf else stalled[i]
            nearest[i] = left
        else:
            stalled[i] += period
            stuck |= stalled[i] >= STUCK
            goal = points[i, length[i] - 1]
            if _is_taken(position, walking, radius, i, goal):
                walking[i], stalled[i] = False, 0.0
                walks.settled[i] = goal
    return stuck


@compiled
def follow_up_push(
    bodies: Bodies, walks: Walks, period: float, paths: Paths
) -> tuple[bool, bool]:
    """Notes how every walker came on while bodies pushed each other.

    Args:
        bodies: As in `follow_up`.
        walks: As in `follow_up`.
        period: As in `follow_up`.
        paths: As in `follow_up`.

    Returns:
        Whether anybody is stuck; and whether standing bodies overlap, so that they push
        each other away.
    """
    stuck = follow_up(bodies, walks, period, paths)
    return stuck, _are_pressed(bodies.position, walks.walking, bodies.radius)


@compiled
def _are_pressed(position: Floats, walking: Mask, radius: Floats) -> bool:
    """Whether bodies overlap that do not walk."""
    for i in range(len(position)):
        for j in range(i):
            if walking[i] or walking[j]:
                continue
            dx, dy = position[j, 0] - position[i, 0], position[j, 1] - position[i, 1]
            apart = radius[i] + radius[j] - OVERLAP
            if dx * dx + dy * dy < apart * apart:
                return True
    return False


@compiled
def _is_taken(
    position: Floats, walking: Mask, radius: Floats, i: int, goal: Floats
) -> bool:
    """Whether a body touches another that stands where it wants to be."""
    if _away(position[i], goal[0], goal[1]) > CROWDED:
        return False
    for j in range(len(position)):
        touching = radius[i] + radius[j] + TOUCH
        if (
            j != i
            and not walking[j]
            and _away(goal, position[j, 0], position[j, 1]) < touching - DRIFT
            and _away(position[i], position[j, 0], position[j, 1]) < touching
        ):
            return True
    return False


@compiled
def arrived(
    position: Annotated[Floats, "n", 2],
    walking: Annotated[Mask, "n"],
    settled: Annotated[Floats, "n", 2],
    goals: Annotated[Floats, "m", 2],
    there: Annotated[Mask, "m"],
) -> None:
    """Finds out who stands at its goal, or as near to it as others let it.

    Args:
        position: Of all bodies, shape (n, 2) [m].
        walking: As in `Walks`, shape (n,).
        settled: As in `Walks`, shape (n, 2) [m].
        goals: One for each of the first m bodies, shape (m, 2) [m].
        there: Set to who does, shape (m,).
    """
    for i in range(len(goals)):
        goal = goals[i, 0], goals[i, 1]
        there[i] = not walking[i] and _is_at(position, settled, i, goal)


@compiled
def find_who_needs_replan(
    position: Annotated[Floats, "n", 2],
    walking: Annotated[Mask, "n"],
    settled: Annotated[Floats, "n", 2],
    due: Annotated[Mask, "n"],
    paths: Paths,
    goals: Goals,
) -> bool:
    """Finds out who is neither at its goal nor on its way there.

    Args:
        position: Of all bodies, shape (n, 2) [m].
        walking: As in `Walks`, shape (n,).
        settled: As in `Walks`, shape (n, 2) [m].
        due: Set for the bodies that have a goal: whether each is to set out, (n,).
        paths: Of all bodies.
        goals: Where the first bodies want to be.

    Returns:
        Whether anybody is.
    """
    anybody = False
    for i in range(len(goals.target)):
        goal = goal_of(goals, i, position)
        due[i] = not is_bound_for(position, walking, settled, paths, i, goal)
        anybody |= due[i]
    return anybody


@compiled
def is_bound_for(
    position: Annotated[Floats, "n", 2],
    walking: Annotated[Mask, "n"],
    settled: Annotated[Floats, "n", 2],
    paths: Paths,
    i: int,
    goal: Point,
) -> bool:
    """Whether a body is at a goal, on its way there, or as near as others let it.

    Args:
        position: Of all bodies, shape (n, 2) [m].
        walking: As in `Walks`, shape (n,).
        settled: As in `Walks`, shape (n, 2) [m].
        paths: Of all bodies.
        i: Index of the body.
        goal: [m].
    """
    if walking[i]:
        end = paths.points[i, paths.length[i] - 1]
        return _away(end, goal[0], goal[1]) <= DRIFT
    return _is_at(position, settled, i, goal)


@compiled
def within_reach(position: Floats, target: Indices, reach: float, near: Mask) -> bool:
    """Finds out who has come near to its target.

    Args:
        position: Of all bodies, shape (n, 2) [m].
        target: Whom each of the first m bodies follows, `NOBODY` for none, shape (m,).
        reach: How near that is [m].
        near: Set to who has, shape (m,).

    Returns:
        Whether anybody has.
    """
    for i in range(len(target)):
        near[i] = False
        if target[i] != NOBODY:
            x, y = position[target[i]]
            near[i] = _away(position[i], x, y) <= reach
    return bool(near.any())


@compiled
def _is_at(position: Floats, settled: Floats, i: int, goal: Point) -> bool:
    """Whether a standing body is at a goal, or as near to it as others let it."""
    x, y = goal
    crowded = _away(settled[i], x, y) <= DRIFT
    return _away(position[i], x, y) <= (CROWDED if crowded else DRIFT)


@compiled
def _away(point: Floats, x: float, y: float) -> float:
    """Distance from one point to another [m]; NaN if one of them is unknown."""
    return np.hypot(point[0] - x, point[1] - y)
