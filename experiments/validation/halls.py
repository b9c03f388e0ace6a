"""Buildings for tests of walking, and the same ones turned and shifted.

Tests speak of a building as it is drawn; a `Frame` puts it and everybody in it
somewhere else and brings tracks back, so that a test need not know.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from experiments.analysis.statistics import FloatArray
from household.home.floorplan import FloorPlan, Region, Wall
from household.motion.bodies import BodyParams
from household.motion.crowd import Crowd
from household.simulation.simulation import PERSON_MASS, PERSON_RADIUS

Point = tuple[float, float]

STEERING, PHYSICS = 0.2, 0.1
"""As in scenarios [s]."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Where a building lies.

    Attributes:
        name: For tables.
        angle: By which it is turned about the origin [degrees].
        shift: By which it is moved after that [m].
    """

    name: str
    angle: float = 0.0
    shift: Point = (0.0, 0.0)

    def out(self, points: Sequence[Point] | FloatArray) -> FloatArray:
        """Takes points of the drawing to where they lie, shape (..., 2) [m]."""
        return np.asarray(points, dtype=np.float64) @ self._turn.T + self.shift

    def back(self, points: FloatArray) -> FloatArray:
        """Takes points back into the drawing, shape (..., 2) [m]."""
        back: FloatArray = (points - self.shift) @ self._turn
        return back

    def point(self, point: Point) -> Point:
        """Takes one point to where it lies [m]."""
        x, y = self.out([point])[0].tolist()
        return x, y

    def plan(self, plan: FloorPlan) -> FloorPlan:
        """Takes a whole building there; walls and regions are all that it may have."""
        walls = tuple(
            Wall(start=self.point(wall.start), end=self.point(wall.end))
            for wall in plan.walls
        )
        regions = tuple(
            msgspec.structs.replace(
                region,
                center=self.point(region.center),
                facing=self.point(region.facing),
            )
            for region in plan.regions
        )
        return msgspec.structs.replace(plan, walls=walls, regions=regions)

    @property
    def _turn(self) -> FloatArray:
        angle = math.radians(self.angle)
        cos, sin = math.cos(angle), math.sin(angle)
        return np.array([[cos, -sin], [sin, cos]])


FRAMES = (
    Frame("as drawn"),
    Frame("turned by 90 degrees", 90.0),
    Frame("turned by 30 degrees and shifted", 30.0, (13.7, -8.2)),
)
"""In which every test is run."""


def building(
    outline: Sequence[Point],
    inner: Sequence[tuple[Point, Point]] = (),
    regions: Sequence[Region] = (),
) -> FloorPlan:
    """Draws a building.

    Args:
        outline: Corners of the outer walls, in order [m].
        inner: From where to where inner walls go [m].
        regions: What people do where; a spot in the middle unless given.
    """
    outer = zip(outline, (*outline[1:], outline[0]), strict=True)
    middle = Region(
        name="spot", activity="reading", center=outline[0], facing=outline[1]
    )
    return FloorPlan(
        name="hall",
        walls=tuple(Wall(start=a, end=b) for a, b in (*outer, *inner)),
        regions=tuple(regions) or (middle,),
    )


def lattice(
    corner: Point, columns: int, rows: int, spacing: float = 0.6
) -> list[Point]:
    """Places in rows, from the lower left corner on [m]."""
    x, y = corner
    return [
        (x + spacing * column, y + spacing * row)
        for row in range(rows)
        for column in range(columns)
    ]


@dataclass(frozen=True, eq=False, kw_only=True)
class Walk:
    """What came of sending people on their way.

    Attributes:
        track: Where everybody was, shape (t, n, 2), in the drawing [m].
        goals: Where they were sent, shape (n, 2) [m].
    """

    track: FloatArray
    goals: FloatArray

    def passed(self, axis: int, line: float) -> FloatArray:
        """When each first was beyond a line across an axis, (n,) [s]; NaN if never."""
        beyond = self.track[:, :, axis] >= line
        times = beyond.argmax(axis=0) * STEERING
        return np.where(beyond.any(axis=0), times, np.nan)


def walk(
    frame: Frame,
    plan: FloorPlan,
    ways: Sequence[tuple[Point, Point]],
    speed: float | Sequence[float] = 1.33,
    most: float = 120.0,
) -> Walk:
    """Sends people on their way, all at once.

    Args:
        frame: Where the building lies.
        plan: The building as drawn.
        ways: From where to where each goes [m].
        speed: Of all, or of each [m/s].
        most: How long they are watched at most [s].
    """
    n = len(ways)
    speeds = np.broadcast_to(np.asarray(speed, dtype=np.float64), n).copy()
    body = BodyParams(np.full(n, PERSON_RADIUS), np.full(n, PERSON_MASS), speeds)
    crowd = Crowd(frame.plan(plan), body, STEERING, PHYSICS)
    crowd.place(frame.out([start for start, _ in ways]), np.zeros(n))
    goals = [goal for _, goal in ways]
    for i, goal in enumerate(goals):
        crowd.send(i, frame.point(goal))
    track = [crowd.position.copy()]
    while crowd.walking.any() and len(track) <= most / STEERING:
        crowd.advance()
        track.append(crowd.position.copy())
    return Walk(track=frame.back(np.array(track)), goals=np.array(goals))
