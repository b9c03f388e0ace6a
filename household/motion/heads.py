"""Heads: they turn towards what somebody looks at, and bodies turn after them."""

from typing import Annotated

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import compiled
from household.motion.bodies import Bodies

NECK = np.pi / 2
"""How far a head turns from the body [rad]."""


@compiled
def turn_heads(
    bodies: Bodies,
    walking: Annotated[Mask, "n"],
    look: Annotated[Indices, "m"],
    focus: Annotated[Floats, "m", 2],
    most: Annotated[Floats, "n"],
) -> None:
    """Turns every head towards where it wants to look, and bodies where necks end.

    Of the first m bodies, those that look at nobody look at their focus, if they stand
    and have one. All others look straight ahead.

    Args:
        bodies: Their gaze and heading are changed in place.
        walking: Whether each walks, shape (n,).
        look: Index of the body that each of the first m looks at, `NOBODY` for none,
            shape (m,).
        focus: What each of them looks at then, NaN for nothing, shape (m, 2) [m].
        most: How far each head can turn in this time, shape (n,) [rad].
    """
    position, gaze, heading = bodies.position, bodies.gaze, bodies.heading
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
