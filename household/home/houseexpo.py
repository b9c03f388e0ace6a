"""Homes from HouseExpo's JSON files (Li et al. 2019, arXiv:1903.09845).

A file gives the contour of the free space, so both faces of an inner wall are part of
it, and a box for every room, by category. There are no doors and no furniture in it:
doorways are gaps, and the way in is not marked. A sound that passes through an inner
wall passes through two faces and is softened twice.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np
from numpy.typing import NDArray

from household.errors import HouseholdError
from household.home.check import LARGEST, checked
from household.home.floorplan import FloorPlan, Region, RegionActivity, Room, Wall
from household.home.routes import Routes, distance_to_segments
from household.records import Point, convert

Array = NDArray[np.float64]
Corners = tuple[float, float, float, float]

FACE = 0.04
"""Thickness of a wall's face [m]: the contour is where the free space ends."""

JITTER = 0.02
"""Corners that bend a wall by less are dropped [m]; contours were traced in images."""

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
    "entering": (0.5, 0.1),
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


class Bounds(msgspec.Struct, frozen=True):
    """Corners of the whole house [m]."""

    min: Point
    max: Point


class House(msgspec.Struct, frozen=True):
    """A HouseExpo file.

    Attributes:
        id: The house's name in the data set.
        bbox: Corners of the whole house [m].
        verts: Contour of the free space [m], closed or not.
        room_category: Boxes of the rooms of each category: x1, y1, x2, y2 [m].
        room_num: Number of rooms.
    """

    id: str
    bbox: Bounds
    verts: Annotated[tuple[Point, ...], msgspec.Meta(min_length=3)]
    room_category: dict[str, tuple[Corners, ...]]
    room_num: int = 0


@dataclass(frozen=True, kw_only=True)
class Place:
    """A room of the file: its category, its name in the plan, and its box [m]."""

    category: str
    name: str
    box: Corners

    def at(self, share: tuple[float, float]) -> Array:
        """A point of the box, shape (2,) [m]; (0, 0) is its lower left corner."""
        low, high = np.array(self.box[:2]), np.array(self.box[2:])
        point: Array = low + np.array(share) * (high - low)
        return point


def load_houseexpo(path: Path | str) -> FloorPlan:
    """Reads a home from a HouseExpo file.

    Args:
        path: A JSON file of the data set.

    Returns:
        A home without faults, with at least one region of each activity.

    Raises:
        HouseholdError: If the file cannot be read, is damaged, or has no room for all
            six activities; one line that names the file and the place in it.
    """
    try:
        data = msgspec.json.decode(Path(path).read_bytes())
    except OSError as error:
        raise HouseholdError(f"{path}: {error.strerror}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise HouseholdError(f"{path}: not valid JSON: {error}") from None
    return from_houseexpo(convert(data, House, str(path)), str(path))


def from_houseexpo(house: House, origin: str) -> FloorPlan:
    """Makes a home of a HouseExpo record.

    Args:
        house: What a file holds.
        origin: The file's name, for error messages.

    Raises:
        HouseholdError: As ``load_houseexpo``.
    """
    contour = _contour(house.verts, origin)
    walls = tuple(
        Wall(start=a, end=b) for a, b in zip(contour, _rotated(contour), strict=True)
    )
    bare = FloorPlan(
        name=f"houseexpo_{house.id}",
        description=f"House {house.id} of HouseExpo",
        wall_thickness=FACE,
        walls=walls,
        # A plan has regions; where they can be is seen from its walls.
        regions=(_entering_at(contour[0]),),
    )
    rooms = tuple(_places(house))
    regions = _regions(bare, rooms, origin)
    outlines = tuple(Room(name=room.name, corners=_outline(room)) for room in rooms)
    plan = msgspec.structs.replace(bare, regions=regions, rooms=outlines)
    return checked(plan, origin)


def _entering_at(point: Point) -> Region:
    return Region(name="-", activity="entering", center=point, facing=point)


def _rotated(points: Sequence[Point]) -> list[Point]:
    return [*points[1:], points[0]]


def _contour(verts: Sequence[Point], origin: str) -> list[Point]:
    """The corners that matter, of a contour that is a home's."""
    points = np.array(verts)
    sides = np.ptp(points, axis=0)
    if not (sides < LARGEST).all() or not (sides > 1.0).all():
        size = " x ".join(f"{side:.3g} m" for side in sides)
        raise HouseholdError(
            f"{origin}: verts: {size} is no home; allowed: 1 m to {LARGEST:.0f} m, "
            "in meters"
        )
    corners = [(float(x), float(y)) for x, y in points[_bends(points)]]
    pairs = zip(corners, _rotated(corners), strict=True)
    distinct = [a for a, b in pairs if np.hypot(a[0] - b[0], a[1] - b[1]) > JITTER]
    if len(distinct) < 3:
        raise HouseholdError(
            f"{origin}: verts: encloses nothing; allowed: at least three corners"
        )
    return distinct


def _bends(points: Array) -> list[int]:
    """Corners left when all that bend the line by little are gone (Douglas-Peucker)."""
    kept, stretches = {0, len(points) - 1}, [(0, len(points) - 1)]
    while stretches:
        first, last = stretches.pop()
        if last - first < 2:
            continue
        chord = points[[first, last]].reshape(1, 4)
        gaps = distance_to_segments(points[first + 1 : last], chord)[:, 0]
        if gaps.max() > JITTER:
            far = first + 1 + int(gaps.argmax())
            kept.add(far)
            stretches += [(first, far), (far, last)]
    return sorted(kept)


def _places(house: House) -> Iterator[Place]:
    """The rooms, each with a name of its own; boxes without area are left out."""
    for label, boxes in house.room_category.items():
        category = label.strip().lower().replace(" ", "_")
        name = category.replace("_", " ") or "room"
        for i, (x1, y1, x2, y2) in enumerate(boxes):
            box = (min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2))
            if box[0] < box[2] and box[1] < box[3]:
                number = f" {i + 1}" if i else ""
                yield Place(category=category, name=name + number, box=box)


def _outline(room: Place) -> tuple[Point, ...]:
    left, low, right, high = room.box
    return ((left, low), (right, low), (right, high), (left, high))


def _regions(
    plan: FloorPlan, rooms: Sequence[Place], origin: str
) -> tuple[Region, ...]:
    """A region of every activity, and more where a house has the rooms for it."""
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


def _largest_part(plan: FloorPlan) -> Array:
    """Where a body fits, in the largest part that hangs together, shape (n, 2) [m]."""
    routes = Routes(plan)
    indoors = routes.free & (routes.parts != routes.parts[0, 0])
    if not indoors.any():
        return np.empty((0, 2))
    largest = np.bincount(routes.parts[indoors]).argmax()
    spots: Array = routes.centers()[(indoors & (routes.parts == largest)).ravel()]
    return spots


@dataclass(kw_only=True)
class Floor:
    """Free space that fills with regions.

    Attributes:
        spots: Where a body fits, shape (n, 2) [m].
    """

    spots: Array
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


def _facing(activity: RegionActivity, spot: Array, room: Place) -> Point:
    """The middle of the room, the wall behind, or the right wall from the middle."""
    inward = room.at((0.5, 0.5)) - spot
    if np.hypot(*inward) < 0.3:
        return _rounded(room.at((1.0, 0.5)) + (0.5, 0.0))
    return _rounded(spot - inward if activity in AT_THE_WALL else spot + inward)


def _rounded(point: Array) -> Point:
    return round(float(point[0]), 3), round(float(point[1]), 3)
