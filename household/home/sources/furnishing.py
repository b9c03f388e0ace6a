"""Furniture for generated homes: what belongs in a room, and where it can stand.

Everything stands along a wall, away from doors and far enough from everything else
for a person to walk past; so no furniture ever cuts a room in two.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from household.config.toml import Point
from household.home.floorplan import Furniture, Region, RegionActivity

Box = tuple[float, float, float, float]
"""Left, bottom, right and top [m] of an upright rectangle."""

PASSAGE = 0.8
"""Free way [m] past furniture: a body's 0.5 with a margin on either side."""

STANDOFF = 0.45
"""From a person's place to the furniture that it uses [m], as in the smart room."""

WALL_FACE = 0.05
"""From the middle of a wall to its face [m]: half the usual thickness."""

TRIES = 60
"""Places tried for one piece before giving up."""


@dataclass(frozen=True, kw_only=True)
class Piece:
    """Something to furnish a room with.

    Attributes:
        width: Along the wall [m].
        depth: Into the room [m]; 0 for a place without furniture, as a rug.
        activity: What people do in front of it, if that is an activity; then a home
            needs it, else it is dropped where there is no place for it.
    """

    name: str
    width: float = 0.0
    depth: float = 0.0
    tall: bool = False
    activity: RegionActivity | None = None


RUG = Piece(name="rug", activity="playing")
DESK = Piece(name="desk", width=1.4, depth=0.7, activity="working")
ARMCHAIR = Piece(name="armchair", width=0.8, depth=0.8, activity="reading")
BED = Piece(name="bed", width=2.0, depth=1.4, activity="sleeping")
PHONE = Piece(name="phone", width=0.5, depth=0.4, activity="calling")
SHELF = Piece(name="bookshelf", width=1.2, depth=0.35, tall=True)
WARDROBE = Piece(name="wardrobe", width=1.5, depth=0.6, tall=True)
SOFA = Piece(name="sofa", width=2.0, depth=0.9)
TELEVISION = Piece(name="television", width=1.4, depth=0.4)
COUNTER = Piece(name="counter", width=2.2, depth=0.6)
FRIDGE = Piece(name="fridge", width=0.7, depth=0.7, tall=True)
TABLE = Piece(name="table", width=1.4, depth=0.8)
TUB = Piece(name="tub", width=1.7, depth=0.75)
BASIN = Piece(name="basin", width=0.6, depth=0.5)
TOYS = Piece(name="toy shelf", width=1.2, depth=0.35)
COATS = Piece(name="coat cupboard", width=0.9, depth=0.4, tall=True)

ROOM_KINDS: dict[str, tuple[float, tuple[Piece, ...]]] = {
    "living room": (1.6, (RUG, ARMCHAIR, SOFA, TELEVISION, SHELF)),
    "bedroom": (1.0, (BED, WARDROBE)),
    "hall": (0.9, (PHONE, COATS)),
    "study": (0.9, (DESK, SHELF)),
    "kitchen": (0.9, (COUNTER, FRIDGE, TABLE)),
    "bathroom": (0.8, (TUB, BASIN)),
    "child's room": (1.0, (BED, RUG, TOYS, WARDROBE)),
    "dining room": (1.0, (TABLE, PHONE, COATS)),
    "library": (1.0, (ARMCHAIR, SHELF, TABLE)),
    "student's room": (1.0, (BED, DESK, SHELF)),
    "guest room": (0.9, (BED, ARMCHAIR, WARDROBE)),
    "playroom": (1.0, (RUG, TOYS, SOFA)),
}
"""Share of the area and furniture of each kind of room, the most common kind first."""


@dataclass(kw_only=True)
class Furnisher:
    """Places pieces one by one and remembers what stands where.

    Attributes:
        rng: Chooses the places.
        clear: Where nothing may stand: either side of every door.
    """

    rng: np.random.Generator
    clear: list[Box]
    furniture: list[Furniture] = field(default_factory=list)
    regions: list[Region] = field(default_factory=list)

    def add(self, piece: Piece, room: Box, owner: str) -> bool:
        """Puts a piece into a room, if there is a place for it.

        Args:
            piece: What to place.
            room: Between the middles of its walls [m].
            owner: The room's name, which becomes part of the piece's.

        Returns:
            Whether a place was found.
        """
        inside = grown(room, -WALL_FACE)
        place = self._against_wall if piece.depth else self._in_the_open
        return any(place(piece, inside, f"{owner} {piece.name}") for _ in range(TRIES))

    def _against_wall(self, piece: Piece, room: Box, name: str) -> bool:
        """Tries one random place along a wall."""
        side = int(self.rng.integers(4))
        frame = (room[2] - room[0], room[3] - room[1])[:: 1 if side < 2 else -1]
        slack = frame[0] - piece.width
        if slack < PASSAGE or frame[1] - piece.depth < PASSAGE:
            return False
        offset = _snapped(float(self.rng.uniform(0.0, slack)), slack)
        box = _turned((offset, 0.0, offset + piece.width, piece.depth), side, room)
        if not self._is_free(box):
            return False
        if piece.activity:
            along, ahead = offset + piece.width / 2, piece.depth + STANDOFF
            spot = _turned((along, ahead, along, ahead), side, room)[:2]
            region = Region(
                name=name,
                activity=piece.activity,
                center=spot,
                radius=0.5,
                facing=middle(box),
            )
            if not self._is_open(region, room):
                return False
            self.regions.append(region)
        size = (round(box[2] - box[0], 2), round(box[3] - box[1], 2))
        self.furniture.append(
            Furniture(name=name, center=middle(box), size=size, tall=piece.tall)
        )
        return True

    def _in_the_open(self, piece: Piece, room: Box, name: str) -> bool:
        """Tries one random circle on the floor."""
        assert piece.activity is not None, "without depth there is only the activity"
        radius = round(float(self.rng.uniform(0.55, 0.75)), 2)
        low, high = np.array(room[:2]) + radius, np.array(room[2:]) - radius
        x, y = self.rng.uniform(low, np.maximum(low, high)).tolist()
        turn = float(self.rng.uniform(0.0, math.tau))
        region = Region(
            name=name,
            activity=piece.activity,
            center=(round(x, 2), round(y, 2)),
            radius=radius,
            facing=(
                round(x + 2 * math.cos(turn), 2),
                round(y + 2 * math.sin(turn), 2),
            ),
        )
        if not self._is_open(region, room):
            return False
        self.regions.append(region)
        return True

    def _is_free(self, box: Box) -> bool:
        """Whether furniture may stand here."""
        return (
            all(gap(box, zone) > 0 for zone in self.clear)
            and all(gap(box, _bounds(other)) >= PASSAGE for other in self.furniture)
            and all(gap(box, r.center * 2) >= STANDOFF for r in self.regions)
        )

    def _is_open(self, region: Region, room: Box) -> bool:
        """Whether a person can be here without being in anybody's way."""
        spot = region.center * 2
        return (
            min(grown(room, -STANDOFF)[2:] - np.array(spot[:2])) >= 0
            and min(np.array(spot[:2]) - grown(room, -STANDOFF)[:2]) >= 0
            and all(gap(spot, zone) > 0.3 for zone in self.clear)
            and all(gap(spot, _bounds(other)) >= STANDOFF for other in self.furniture)
            and all(
                gap(spot, other.center * 2) >= region.radius + other.radius
                for other in self.regions
            )
        )


def grown(box: Box, by: float) -> Box:
    """A box with every side moved outward [m], inward if negative."""
    return (box[0] - by, box[1] - by, box[2] + by, box[3] + by)


def middle(box: Box) -> Point:
    """The center of a box [m], to the centimeter."""
    return round((box[0] + box[2]) / 2, 3), round((box[1] + box[3]) / 2, 3)


def gap(a: Box, b: Box) -> float:
    """Shortest distance between two boxes [m]; 0 where they touch or overlap."""
    dx = max(a[0] - b[2], b[0] - a[2], 0.0)
    dy = max(a[1] - b[3], b[1] - a[3], 0.0)
    return math.hypot(dx, dy)


def _bounds(box: Furniture) -> Box:
    (x, y), (width, depth) = box.center, box.size
    return (x - width / 2, y - depth / 2, x + width / 2, y + depth / 2)


def _snapped(offset: float, slack: float) -> float:
    """Into the corner, if it would leave a cranny too narrow to walk into."""
    if offset < PASSAGE:
        return 0.0
    return slack if slack - offset < PASSAGE else round(offset, 2)


def _turned(box: Box, side: int, room: Box) -> Box:
    """A box given along and away from a wall, in the coordinates of the home.

    Args:
        box: Measured from the wall's left or lower end [m].
        side: 0 the lower wall, 1 the upper, 2 the left, 3 the right.
        room: Between the faces of its walls [m].
    """
    along, away, along2, away2 = box
    left, low, right, high = room
    corners: Box = (
        (left + along, low + away, left + along2, low + away2),
        (left + along, high - away2, left + along2, high - away),
        (left + away, low + along, left + away2, low + along2),
        (right - away2, low + along, right - away, low + along2),
    )[side]
    x, y, x2, y2 = (round(value, 3) for value in corners)
    return (x, y, x2, y2)
