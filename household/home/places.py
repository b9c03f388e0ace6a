"""Places: the spots in activity regions where people stand, each for one person."""

import math
from collections.abc import Callable, Sequence
from functools import lru_cache, partial

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.config.toml import Point
from household.home.floorplan import FloorPlan, Region
from household.home.navigation.routes import Routes, routes_of
from household.state import Stateful

EDGE = 0.1
"""How far inside its region a spot lies at least [m], so that a body that is pushed a
little stays in the region."""

SPOTS_ON_RING = 6

NOWHERE = -1
"""In place of a region."""

APART = 0.5
"""Least distance between the spots of two people [m]: two bodies side by side."""

KEPT = 1024
"""How many rings round spots are remembered, as people ask for the same ones."""


class Places(Stateful):
    """Activity regions with their spots, and who has claimed which.

    Args:
        plan: The home.

    Attributes:
        circles: The regions, shape (n_regions, 3), rows of x, y, radius [m].
        roles: The role that people play in each, as `Activity` values, and at the end
            the role outside all regions, shape (n_regions + 1,).
        facing: What people look at in each, and NaN at the end, shape
            (n_regions + 1, 2) [m].
    """

    STATE = ("_claims",)

    def __init__(self, plan: FloorPlan) -> None:
        self.regions = plan.regions
        self.circles = plan.region_circles
        self.roles = np.array([*(r.role for r in plan.regions), Activity.UNKNOWN])
        nothing = (math.nan, math.nan)
        self.facing = np.array([*(r.facing for r in plan.regions), nothing])
        self._ring = _rings_in(plan)
        self._spots = _spots_in(plan)
        self._claims: dict[int, tuple[int, Point]] = {}

    @property
    def centers(self) -> Floats:
        """Middles of the regions, shape (n_regions, 2) [m]."""
        return self.circles[:, :2]

    def clear(self) -> None:
        """Begins a new episode: nobody has claimed a spot."""
        self._claims.clear()

    def has(self, name: str) -> bool:
        """Whether there is a region with this name or this activity."""
        return any(name in (region.name, region.activity) for region in self.regions)

    def index(self, name: str) -> int:
        """Index of the region with this name, else the first with this activity."""
        names = [region.name for region in self.regions]
        activities: list[str] = [region.activity for region in self.regions]
        return names.index(name) if name in names else activities.index(name)

    def own(self, name: str, person: int) -> int:
        """The region with this name, else one person's own with this activity.

        Where a home has several, such as bedrooms, people share them out in order.
        """
        same = [i for i, region in enumerate(self.regions) if region.activity == name]
        if any(region.name == name for region in self.regions) or not same:
            return self.index(name)
        return same[person % len(same)]

    def claim(self, person: int, region: int) -> Point:
        """The spot of a region where a person goes: its own, else the first free.

        When all are taken, the person waits beside them, at a distance from the others.
        """
        place, spot = self._claims.get(person, (NOWHERE, (0.0, 0.0)))
        if place != region:
            taken = [spot for r, spot in self._claims.values() if r == region]
            spots = self._spots[region]
            free = (spot for spot in spots if spot not in taken)
            spot = next(free, None) or self.beside(spots[0], taken)
            self._claims[person] = (region, spot)
        return spot

    def beside(self, spot: Point, taken: Sequence[Point]) -> Point:
        """The spot itself or, if it is taken, a free one as near to it as possible.

        Args:
            spot: Where a body fits [m].
            taken: Where others are [m].
        """
        for ring in range(len(taken) + 1):
            for point in self._ring(spot, ring):
                if all(math.dist(point, other) >= APART - 1e-9 for other in taken):
                    return point
        return spot


@compiled
def place_of(point: Floats, circles: Floats) -> int:
    """The region that a point is in, or `NOWHERE`; regions do not overlap.

    Args:
        point: Shape (2,) [m].
        circles: From `Places`, shape (n_regions, 3).
    """
    for k in range(len(circles)):
        dx, dy = point[0] - circles[k, 0], point[1] - circles[k, 1]
        if dx * dx + dy * dy <= circles[k, 2] * circles[k, 2]:
            return k
    return NOWHERE


@lru_cache(maxsize=64)
def _rings_in(plan: FloorPlan) -> Callable[[Point, int], list[Point]]:
    """Finds rings round spots, and remembers them for all who live in such a home."""
    return lru_cache(maxsize=KEPT)(partial(_places_on_ring, routes_of(plan)))


def _places_on_ring(routes: Routes, spot: Point, ring: int) -> list[Point]:
    """The points on one of the rings round a spot where a body fits."""
    around = _ring(spot, ring * APART, max(1, SPOTS_ON_RING * ring))
    here = np.array(spot)
    return [
        point
        for point in around
        if routes.connects(np.array(point), here) and routes.has_room(point)
    ]


@lru_cache(maxsize=64)
def _spots_in(plan: FloorPlan) -> tuple[tuple[Point, ...], ...]:
    """The spots of each region where a body fits that came from its middle."""
    routes = routes_of(plan)
    return tuple(
        tuple(
            spot
            for spot in _spots(region)
            if routes.connects(np.array(spot), np.array(region.center))
            and routes.has_room(spot)
        )
        for region in plan.regions
    )


def _spots(region: Region) -> list[Point]:
    """The center of a region and, if it is wide enough, a ring of spots round it."""
    ring = region.radius - EDGE
    if ring < APART:
        return [region.center]
    return [region.center, *_ring(region.center, ring, SPOTS_ON_RING)]


def _ring(center: Point, radius: float, n: int) -> list[Point]:
    """Spots that are spread evenly round a point [m]."""
    angles = [2 * math.pi * i / n for i in range(n)]
    x, y = center
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]
