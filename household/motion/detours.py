"""Detours: paths for walkers that are stuck."""

import math

from household.config.toml import Point
from household.home.navigation.routes import Routes

SIDESTEP = 0.7
"""How far a walker that is stuck steps aside before it goes on [m]."""

GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))
"""Between the directions of sidesteps, so that repeated ones try all sides [rad]."""


def detour(routes: Routes, here: Point, goal: Point, attempt: int) -> list[Point]:
    """A path that first leads a step aside.

    Args:
        routes: Of the home.
        here: Where it begins [m].
        goal: Where it ends [m].
        attempt: Another number has another direction to step in.

    Returns:
        Waypoints [m]; empty if no path leads aside.
    """
    angle = attempt * GOLDEN_ANGLE
    aside = (
        here[0] + SIDESTEP * math.cos(angle),
        here[1] + SIDESTEP * math.sin(angle),
    )
    path = routes.plan(here, aside)
    return path + routes.plan(path[-1], goal) if path else []
