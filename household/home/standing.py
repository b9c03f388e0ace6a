"""Standing room: where in a home somebody can stand who is in nobody's way."""

import math
from collections.abc import Sequence

import numpy as np

from household.config.toml import Point
from household.errors import HouseholdError
from household.home.floorplan import FloorPlan
from household.home.navigation.routes import routes_of

FROM_DOORS = 0.9
"""Least distance to a door's middle [m]: people come through."""

FROM_PLACES = 0.5
"""Least distance to the rim of an activity region [m]: people stand there."""

APART = 0.8
"""Least distance between two of them [m]."""


def standing_room(
    plan: FloorPlan, n: int, rng: np.random.Generator, taken: Sequence[Point] = ()
) -> list[Point]:
    """Draws places to stand, all within walking distance of the home's regions.

    Args:
        plan: The home.
        n: How many places.
        rng: Draws them.
        taken: Where others stand already [m].

    Returns:
        Points [m].

    Raises:
        HouseholdError: If the home has no room for so many.
    """
    routes = routes_of(plan)
    first = routes.cell(plan.regions[0].center)
    reached = (routes.free & (routes.parts == routes.parts[first])).reshape(-1)
    points = routes.centers()[reached]
    for door in plan.doors:
        middle = (np.array(door.start) + np.array(door.end)) / 2
        points = points[np.linalg.norm(points - middle, axis=1) >= FROM_DOORS]
    for region in plan.regions:
        gap = np.linalg.norm(points - np.array(region.center), axis=1) - region.radius
        points = points[gap >= FROM_PLACES]
    chosen: list[Point] = []
    for x, y in rng.permutation(points).tolist():
        if len(chosen) == n:
            break
        if all(math.dist((x, y), other) >= APART for other in (*taken, *chosen)):
            chosen.append((round(x, 2), round(y, 2)))
    if len(chosen) < n:
        raise HouseholdError(
            f"{plan.name}: room for {len(chosen)} robots in the open, not for {n}; "
            "allowed: fewer robots or larger rooms"
        )
    return chosen
