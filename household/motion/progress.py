"""Walking: who is where on its way, who has arrived, and who is stuck.

Compiled with Numba for the same reason as the perception kernel: it runs several
times in each decision, over all pairs of bodies.
"""

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import compiled

PROGRESS = 0.05
"""How much nearer to its waypoint a walker must come not to be stuck [m]."""

STUCK = 2.0
"""Time without progress after which a walker tries another way [s]."""

DRIFT = 0.1
"""How far a body lets itself be pushed before it steps back to its place [m]."""

CROWDED = 1.0
"""Where others stand in its place, a walker settles for this near to it [m]."""

NECK = np.pi / 2
"""How far a head turns from the body [rad]."""

PASSED = 0.15
"""Distance at which a waypoint on the way counts as passed [m]."""

ARRIVED = 0.05
"""Distance at which a walk ends [m]."""

TOUCH = 0.01
"""Gap between bodies that touch, at most [m]."""

OVERLAP = 0.003
"""How deep bodies may overlap that nothing presses together [m]; the engine parts them
ever more slowly."""


@compiled
def follow_up(
    walking: Mask,
    nearest: Floats,
    stalled: Floats,
    settled: Floats,
    radius: Floats,
    period: float,
    position: Floats,
    points: Floats,
    at: Indices,
    count: Indices,
) -> bool:
    """Notes how every walker came on: who is at its waypoint heads for the next.

    Who comes no nearer because somebody stands on its goal has arrived.

    Args:
        walking: Shape (n,); brought up to date in place, like the three that follow.
        nearest: How near each came to its waypoint, shape (n,) [m].
        stalled: Since how long each came no nearer, (n,) [s].
        settled: The goal that others kept each from, NaN if none, shape (n, 2) [m].
        radius: Of each body, shape (n,) [m].
        period: Since this was last done [s].
        position: Where everybody is, shape (n, 2) [m].
        points: From `Paths`, shape (n, most, 2) [m].
        at: From `Paths`, shape (n,); brought up to date in place.
        count: From `Paths`, shape (n,).

    Returns:
        Whether anybody is stuck.
    """
    stuck = False
    for i in range(len(position)):
        if not walking[i]:
            continue
        wx = points[i, at[i], 0] - position[i, 0]
        wy = points[i, at[i], 1] - position[i, 1]
        left = np.sqrt(wx * wx + wy * wy)
        if left <= (PASSED if at[i] + 1 < count[i] else ARRIVED):
            at[i] += 1
            walking[i] = at[i] < count[i]
            nearest[i], stalled[i] = np.inf, 0.0
        elif left < nearest[i] - PROGRESS:
            # Whoever only tries another way has not come nearer yet.
            stalled[i] = 0.0 if nearest[i] < np.inf else stalled[i]
            nearest[i] = left
        else:
            stalled[i] += period
            stuck |= stalled[i] >= STUCK
            goal = points[i, count[i] - 1]
            if _is_taken(position, walking, radius, i, goal):
                walking[i], stalled[i] = False, 0.0
                settled[i] = goal
    return stuck


@compiled
def are_pressed(position: Floats, walking: Mask, radius: Floats) -> bool:
    """Whether bodies overlap that do not walk, so that they push each other away.

    Args:
        position: Shape (n, 2) [m].
        walking: Shape (n,).
        radius: Of each body, shape (n,) [m].
    """
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
    position: Floats, walking: Mask, settled: Floats, goals: Floats, there: Mask
) -> None:
    """Who stands at its goal, or as near to it as others let it.

    Args:
        position: Shape (n, 2) [m].
        walking: Shape (n,).
        settled: The goal that others kept each from, NaN if none, shape (n, 2) [m].
        goals: One for each of the first m bodies, shape (m, 2) [m].
        there: Shape (m,); filled in.
    """
    for i in range(len(goals)):
        x, y = goals[i]
        there[i] = not walking[i] and _is_at(position[i], settled[i], x, y)


@compiled
def needs_replan(
    position: Floats,
    walking: Mask,
    settled: Floats,
    lost: Mask,
    points: Floats,
    count: Indices,
    goals: Floats,
    target: Indices,
) -> bool:
    """Who is not bound for its goal, or for whom it is after.

    Args:
        position: As in `is_bound_for`, like the two that follow.
        walking: Shape (n,).
        settled: Shape (n, 2) [m].
        lost: Set to who is, shape (n,).
        points: From `Paths`, shape (n, most, 2) [m].
        count: From `Paths`, shape (n,).
        goals: One for each of the first m bodies, shape (m, 2) [m].
        target: Whom each is after instead, `NOBODY` for none, shape (m,).

    Returns:
        Whether anybody is.
    """
    anybody = False
    for i in range(len(goals)):
        x, y = goals[i] if target[i] == NOBODY else position[target[i]]
        lost[i] = not is_bound_for(position, walking, settled, points, count, i, x, y)
        anybody |= lost[i]
    return anybody


@compiled
def is_bound_for(
    position: Floats,
    walking: Mask,
    settled: Floats,
    points: Floats,
    count: Indices,
    i: int,
    x: float,
    y: float,
) -> bool:
    """Whether a body is at a goal, on its way there, or as near as others let it.

    Args:
        position: Shape (n, 2) [m].
        walking: Shape (n,).
        settled: The goal that others kept each from, NaN if none, shape (n, 2) [m].
        points: From `Paths`, shape (n, most, 2) [m].
        count: From `Paths`, shape (n,).
        i: Index of the body.
        x: Of the goal [m].
        y: Of the goal [m].
    """
    if walking[i]:
        return _away(points[i, count[i] - 1], x, y) <= DRIFT
    return _is_at(position[i], settled[i], x, y)


@compiled
def within_reach(position: Floats, target: Indices, reach: float, near: Mask) -> bool:
    """Who has come near to whom it is after.

    Args:
        position: Shape (n, 2) [m].
        target: Whom each of the first m bodies is after, `NOBODY` for none, shape (m,).
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
def _is_at(position: Floats, settled: Floats, x: float, y: float) -> bool:
    """Whether a body that stands is at a point, or as near as others let it."""
    crowded = _away(settled, x, y) <= DRIFT
    return _away(position, x, y) <= (CROWDED if crowded else DRIFT)


@compiled
def _away(point: Floats, x: float, y: float) -> float:
    """Distance from one point to another [m]; NaN if one of them is unknown."""
    return np.hypot(point[0] - x, point[1] - y)


@compiled
def turn_heads(
    gaze: Floats,
    heading: Floats,
    position: Floats,
    walking: Mask,
    look: Indices,
    focus: Floats,
    most: Floats,
) -> None:
    """Turns every head towards where it wants to look, and bodies where necks end.

    Who looks at nobody and has nothing to look at, or walks, looks ahead.

    Args:
        gaze: Where every head points, shape (n,) [rad]; changed in place.
        heading: Where every body faces, shape (n,) [rad]; changed in place.
        position: Shape (n, 2) [m].
        walking: Shape (n,).
        look: Whom each of the first m bodies looks at, `NOBODY` for none, shape (m,).
        focus: What each of them looks at then, NaN for nothing, shape (m, 2) [m].
        most: How far each head can turn in this time, shape (n,) [rad].
    """
    for i in range(len(gaze)):
        goal = heading[i]
        if i < len(look) and look[i] != NOBODY:
            goal = _direction(position[i], position[look[i]])
        elif i < len(look) and not walking[i] and not np.isnan(focus[i, 0]):
            goal = _direction(position[i], focus[i])
        turn = _wrapped(goal - gaze[i])
        gaze[i] += min(max(turn, -most[i]), most[i])
        strain = _wrapped(gaze[i] - heading[i])
        heading[i] = heading[i] + strain - min(max(strain, -NECK), NECK)


@compiled
def _direction(here: Floats, there: Floats) -> float:
    """The direction from one point to another [rad]."""
    return np.arctan2(there[1] - here[1], there[0] - here[0])


@compiled
def _wrapped(angle: float) -> float:
    """An angle in [-pi, pi) [rad]."""
    return (angle + np.pi) % (2 * np.pi) - np.pi
