"""Homes from HouseExpo's JSON files (Li et al. 2019, arXiv:1903.09845).

A file gives the contour of the free space, so both faces of an inner wall are part of
it, and a box for every room, by category. There are no doors and no furniture in it:
doorways are gaps, and the way in is not marked. A sound that passes through an inner
wall passes through two faces and is softened twice.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np

from household.compiled.arrays import Floats
from household.config.toml import Point, convert, read_file
from household.errors import HouseholdError, shown_path
from household.home.check import LARGEST, checked
from household.home.floorplan import FEW, FloorPlan, Region, Room, Wall
from household.home.geometry import distance_to_segments
from household.home.sources.placing import Corners, Place, place_regions

FACE = 0.04
"""Thickness of a wall's face [m]: the contour is where the free space ends."""

JITTER = 0.02
"""Corners that bend a wall by less are dropped [m]; contours were traced in images."""


MOST_VERTS = 2000
"""Of a contour; those of the data set have some dozens."""


class House(msgspec.Struct, frozen=True):
    """A HouseExpo file; its ``bbox`` and ``room_num`` follow from these fields.

    Attributes:
        id: The house's name in the data set.
        verts: Contour of the free space [m], closed or not.
        room_category: Boxes of the rooms of each category: x1, y1, x2, y2 [m].
    """

    id: str
    verts: Annotated[
        tuple[Point, ...], msgspec.Meta(min_length=3, max_length=MOST_VERTS)
    ]
    room_category: Annotated[dict[str, Annotated[tuple[Corners, ...], FEW]], FEW]


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
    origin = shown_path(path)
    try:
        data = msgspec.json.decode(read_file(Path(path)))
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise HouseholdError(f"{origin}: not valid JSON: {error}") from None
    except RecursionError:
        raise HouseholdError(f"{origin}: nested too deeply") from None
    if isinstance(data, dict):
        # The rest of a file follows from these fields, or is not ours to judge.
        names = House.__struct_fields__
        data = {name: value for name, value in data.items() if name in names}
    return from_houseexpo(convert(data, House, origin), origin)


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
    regions = place_regions(bare, rooms, origin)
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


def _bends(points: Floats) -> list[int]:
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
