"""Floor plans: walls, doors, furniture, rooms and activity regions (paper, figure 2).

A plan is data: a TOML file in ``homes/`` or of the user's own. All lengths are in
meters, x to the right and y up; angles are in degrees in the files and in radians
in the code, counter-clockwise from the x axis.
"""

import math
from collections.abc import Iterable
from typing import Annotated, Literal

import msgspec
import numpy as np

from household.activity import Activity, activity_of
from household.compiled.arrays import Floats
from household.config.quantities import Angle, Length, Name, Position, Text
from household.config.toml import Point, Record, load, locate

RegionActivity = Literal[
    "working", "reading", "sleeping", "playing", "entering", "calling"
]

Size = Annotated[float, msgspec.Meta(ge=0.01, le=10)]
"""Of a piece of furniture [m]: engines cannot turn what has no size."""

MOST_WALLS, MOST_OTHERS = 1000, 500
"""In one home; of doors, furniture, regions and rooms, so many each."""

FEW = msgspec.Meta(max_length=MOST_OTHERS)

MOST_CORNERS = 500
"""Of one room."""

ON_THE_LINE = 1e-9
"""A point lies on a line if it makes a parallelogram of this area with it [m2]."""


class Wall(Record, frozen=True, kw_only=True, rename={"start": "from", "end": "to"}):
    """A straight wall from one point to another [m]."""

    start: Position
    end: Position


class Door(Record, frozen=True, kw_only=True, rename={"start": "from", "end": "to"}):
    """A door leaf in a gap between walls; closed, it is a wall.

    Attributes:
        open: People walk and look through an open door.
    """

    start: Position
    end: Position
    open: bool = True


class Furniture(Record, frozen=True, kw_only=True):
    """A box that stands on the floor.

    Attributes:
        center: Middle of the box [m].
        size: Width and depth [m], before rotation.
        angle: Rotation about the center [degrees].
        tall: Hides what is behind it from view; low furniture does not.
    """

    name: Name
    center: Position
    size: tuple[Size, Size]
    angle: Angle = 0.0
    tall: bool = False

    @property
    def corners(self) -> tuple[Point, ...]:
        """The four corners [m], counter-clockwise."""
        angle = math.radians(self.angle)
        cos, sin = math.cos(angle), math.sin(angle)
        half_x, half_y = self.size[0] / 2, self.size[1] / 2
        box = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        return tuple(
            (
                self.center[0] + cos * half_x * i - sin * half_y * j,
                self.center[1] + sin * half_x * i + cos * half_y * j,
            )
            for i, j in box
        )


class Region(Record, frozen=True, kw_only=True):
    """A circle on the floor in which a person plays a role.

    Attributes:
        activity: The role that is played inside.
        center: Where people stand or sit [m].
        radius: Radius [m].
        facing: What one looks at while absorbed here, a point [m].
    """

    name: Name
    activity: RegionActivity
    center: Position
    radius: Length = 0.6
    facing: Position

    @property
    def role(self) -> Activity:
        """The activity as an enumeration member."""
        return activity_of(self.activity)


class Room(Record, frozen=True, kw_only=True):
    """A named part of the plan, for texts and pictures.

    Attributes:
        corners: Outline [m], in order.
    """

    name: Name
    corners: Annotated[
        tuple[Position, ...], msgspec.Meta(min_length=3, max_length=MOST_CORNERS)
    ]


class FloorPlan(Record, frozen=True, kw_only=True):
    """A home.

    Attributes:
        walls: Outer and inner walls; together with closed doors they must enclose
            every region.
        wall_thickness: Of every wall [m].
    """

    name: Name
    description: Text = ""
    wall_thickness: Annotated[float, msgspec.Meta(ge=0.001)] = 0.1
    walls: Annotated[
        tuple[Wall, ...], msgspec.Meta(min_length=3, max_length=MOST_WALLS)
    ]
    doors: Annotated[tuple[Door, ...], FEW] = ()
    furniture: Annotated[tuple[Furniture, ...], FEW] = ()
    regions: Annotated[
        tuple[Region, ...], msgspec.Meta(min_length=1, max_length=MOST_OTHERS)
    ]
    rooms: Annotated[tuple[Room, ...], FEW] = ()

    @property
    def lower(self) -> Floats:
        """Lower left corner of the walls' bounding box, shape (2,) [m]."""
        corners: Floats = self.wall_segments.reshape(-1, 2)
        return corners.min(axis=0)

    @property
    def upper(self) -> Floats:
        """Upper right corner of the walls' bounding box, shape (2,) [m]."""
        corners: Floats = self.wall_segments.reshape(-1, 2)
        return corners.max(axis=0)

    @property
    def wall_segments(self) -> Floats:
        """Walls and closed doors as (n, 4) rows of x1, y1, x2, y2 [m]."""
        closed = [(*door.start, *door.end) for door in self.doors if not door.open]
        walls = [(*wall.start, *wall.end) for wall in self.walls]
        return np.array(walls + closed, dtype=np.float64)

    @property
    def solid_segments(self) -> Floats:
        """What blocks the way: walls, closed doors, sides of furniture, (n, 4)."""
        return np.vstack([self.wall_segments, _sides(self.furniture)])

    @property
    def opaque_segments(self) -> Floats:
        """What blocks sight: walls, closed doors, sides of tall furniture, (n, 4)."""
        return np.vstack([self.wall_segments, _sides(self._tall)])

    @property
    def parting_walls(self) -> Floats:
        """Walls and closed doors that can stand between two at home, (n, 4).

        Not those round it: the whole home lies on one side of each.
        """
        walls = self.wall_segments
        parts = [_has_on_both_sides(wall, walls.reshape(-1, 2)) for wall in walls]
        return walls[np.array(parts)]

    @property
    def tall_diagonals(self) -> Floats:
        """Diagonals of tall furniture, (n, 4).

        From outside, a line of sight through a box crosses one of them or both.
        """
        ends = [(*b.corners[i], *b.corners[i + 2]) for b in self._tall for i in (0, 1)]
        return np.array(ends, dtype=np.float64).reshape(-1, 4)

    @property
    def _tall(self) -> list[Furniture]:
        return [box for box in self.furniture if box.tall]

    @property
    def region_circles(self) -> Floats:
        """Activity regions as (n_regions, 3) rows of x, y, radius [m]."""
        return np.array([(*r.center, r.radius) for r in self.regions], dtype=np.float64)

    def region(self, name: str) -> Region | None:
        """The region with this name, else the first with this activity, else None."""
        for region in self.regions:
            if region.name == name:
                return region
        return next((r for r in self.regions if r.activity == name), None)


def _has_on_both_sides(wall: Floats, points: Floats) -> bool:
    """Whether points lie on both sides of the line through a wall."""
    x1, y1, x2, y2 = wall
    side = (x2 - x1) * (points[:, 1] - y1) - (y2 - y1) * (points[:, 0] - x1)
    return bool(side.min() < -ON_THE_LINE and side.max() > ON_THE_LINE)


def _sides(boxes: Iterable[Furniture]) -> Floats:
    """The sides of boxes, four rows of x1, y1, x2, y2 for each [m]."""
    sides = [(*box.corners[i - 1], *box.corners[i]) for box in boxes for i in range(4)]
    return np.array(sides, dtype=np.float64).reshape(-1, 4)


def load_floorplan(name: str) -> FloorPlan:
    """Reads a shipped home by name, or a TOML file by path, as it is now.

    Raises:
        HouseholdError: If it cannot be found or a field is wrong.
    """
    return load(locate(name, "home"), FloorPlan)
