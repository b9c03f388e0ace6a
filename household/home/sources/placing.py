"""Activity regions for homes that come with rooms but without furniture.

Every activity gets a region in the room that suits it best; the region lies as near
to its aim there as a body fits, apart from the others, and all of them are joined.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from household.compiled.arrays import Floats
from household.config.toml import Point
from household.errors import HouseholdError
from household.home.floorplan import FloorPlan, Region, RegionActivity
from household.home.navigation.routes import Routes

Corners = tuple[float, float, float, float]

RADII = (0.6, 0.45)
"""Radius of a region [m], and where that does not fit."""

PREFERRED: dict[RegionActivity, tuple[str, ...]] = {
    "entering": ("entryway", "hall", "lobby", "hallway", "corridor", "living_room"),
    "sleeping": ("bedroom", "child_room", "guest_room", "living_room"),
    "working": ("office", "study", "guest_room", "dining_room", "bedroom"),
    "playing": ("living_room", "child_room", "gym", "dining_room", "bedroom"),
    "reading": ("living_room", "library", "dining_room", "bedroom"),
    "calling": ("hallway", "hall", "kitchen", "dining_room", "living_room"),
}
"""Where an activity is at home: the first category that a house has. Our choice."""

AIM: dict[RegionActivity, tuple[float, float]] = {
    "entering": (0.5, 0.2),
    "sleeping": (0.2, 0.8),
    "working": (0.8, 0.2),
    "playing": (0.5, 0.5),
    "reading": (0.8, 0.8),
    "calling": (0.2, 0.2),
}
"""Where in its room an activity would be, as shares of width and depth: apart from
the others if one room has to hold several. Our choice."""

AT_THE_WALL = ("sleeping", "working", "calling")
"""Activities whose bed, desk or phone is at the wall; in others one faces the room."""

EVERY: dict[RegionActivity, set[str]] = {
    "sleeping": {"bedroom", "child_room", "guest_room"},
    "working": {"office", "study"},
    "playing": {"living_room", "child_room"},
    "reading": {"living_room", "library"},
}
"""Categories whose every room has a region of this activity."""


@dataclass(frozen=True, kw_only=True)
class Place:
    """A room of the file: its category, its name in the plan, and its box [m]."""

    category: str
    name: str
    box: Corners

    def at(self, share: tuple[float, float]) -> Floats:
        """A point of the box, shape (2,) [m]; (0, 0) is its lower left corner."""
        low, high = np.array(self.box[:2]), np.array(self.box[2:])
        point: Floats = low + np.array(share) * (high - low)
        return point


def place_regions(
    plan: FloorPlan, rooms: Sequence[Place], origin: str
) -> tuple[Region, ...]:
    """A region of every activity, and more where a house has the rooms for it.

    Args:
        plan: A home whose walls count and whose regions do not.
        rooms: Its rooms.
        origin: The file's name, for error messages.

    Raises:
        HouseholdError: If there is no place for an activity.
    """
    floor = Floor(spots=_largest_part(plan))
    everywhere = Place(category="", name="home", box=(*plan.lower, *plan.upper))
    for activity in PREFERRED:
        first = _by_preference(rooms, activity)
        if not any(floor.add(activity, room) for room in [*first, everywhere]):
            raise HouseholdError(
                f"{origin}: verts: no free place for {activity}; allowed: free space "
                "for six activities that are joined"
            )
    taken = {region.name for region in floor.regions}
    for activity, categories in EVERY.items():
        for room in rooms:
            if room.category in categories and f"{room.name} {activity}" not in taken:
                floor.add(activity, room)
    return tuple(floor.regions)


def _by_preference(rooms: Iterable[Place], activity: RegionActivity) -> list[Place]:
    """Rooms in the order in which they suit an activity; unsuitable ones last."""
    order = PREFERRED[activity]
    rank = {category: i for i, category in enumerate(order)}
    return sorted(rooms, key=lambda room: rank.get(room.category, len(order)))


def _largest_part(plan: FloorPlan) -> Floats:
    """Where a body fits, in the largest part that hangs together, shape (n, 2) [m]."""
    routes = Routes(plan)
    indoors = routes.free & (routes.parts != routes.parts[0, 0])
    if not indoors.any():
        return np.empty((0, 2))
    largest = np.bincount(routes.parts[indoors]).argmax()
    spots: Floats = routes.centers()[(indoors & (routes.parts == largest)).ravel()]
    return spots


@dataclass(kw_only=True)
class Floor:
    """Free space that fills with regions.

    Attributes:
        spots: Where a body fits, shape (n, 2) [m].
    """

    spots: Floats
    regions: list[Region] = field(default_factory=list)

    def add(self, activity: RegionActivity, room: Place) -> bool:
        """Puts a region as near as possible to its aim in a room, if it fits there."""
        return any(self._add(activity, room, radius) for radius in RADII)

    def _add(self, activity: RegionActivity, room: Place, radius: float) -> bool:
        low, high = np.array(room.box[:2]), np.array(room.box[2:])
        here = ((self.spots >= low) & (self.spots <= high)).all(axis=1)
        for other in self.regions:
            away = np.hypot(*(self.spots - other.center).T)
            here &= away >= radius + other.radius
        spots = self.spots[here]
        if not len(spots):
            return False
        nearest = spots[np.hypot(*(spots - room.at(AIM[activity])).T).argmin()]
        region = Region(
            name=f"{room.name} {activity}",
            activity=activity,
            center=_rounded(nearest),
            radius=radius,
            facing=_facing(activity, nearest, room),
        )
        self.regions.append(region)
        return True


def _facing(activity: RegionActivity, spot: Floats, room: Place) -> Point:
    """The middle of the room, the wall behind, or the right from the middle."""
    inward = room.at((0.5, 0.5)) - spot
    if np.hypot(*inward) < 0.3:
        return _rounded(room.at((1.5, 0.5)))
    return _rounded(spot - inward if activity in AT_THE_WALL else spot + inward)


def _rounded(point: Floats) -> Point:
    return round(float(point[0]), 3), round(float(point[1]), 3)
