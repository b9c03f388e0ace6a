"""Collisions with obstacles: bodies stay out of walls and furniture.

Physics engines let a fast body sink into a wall for a tick before they push it back;
in a crowd that can be some 10 cm. This corrects it after the engine's ticks.
"""

from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Indices
from household.compiled.jit import compiled
from household.home.floorplan import FloorPlan
from household.home.geometry import crosses

Point = tuple[float, float]
Box = tuple[float, float, float, float]

ROUNDS = 3
"""How often a body is pushed out: a corner pushes it from one side to the other."""

PUSHED = 0.5
"""How far obstacles push a body at most [m]: only those closer to it are looked at, and
a body that would be pushed further goes back."""

WEDGED = 0.005
"""A body that still overlaps by more after that [m] was pressed to where it does not
fit."""

LONG = 2.0
"""A step of more radii than this is taken in pieces of one radius each."""

ON_A_LINE = 1e-9
"""Nearer to a segment than this [m], nobody can say on which side of it a body is."""


class Obstacles(NamedTuple):
    """The walls and the sides of the furniture of a home.

    Attributes:
        segments: Shape (n_segments, 4), rows of x1, y1, x2, y2 [m].
        thickness: Half the thickness of each, shape (n_segments,) [m].
        boxes: Left, lower, right and upper edges of the box round each, shape
            (4, n_segments) [m].
    """

    segments: Annotated[Floats, "n_segments", 4]
    thickness: Annotated[Floats, "n_segments"]
    boxes: Annotated[Floats, 4, "n_segments"]


def obstacles_of(plan: FloorPlan) -> Obstacles:
    """The obstacles of a home."""
    segments = plan.solid_segments
    walls = len(plan.wall_segments)
    thickness = np.zeros(len(segments))
    thickness[:walls] = plan.wall_thickness / 2
    one, other = segments[:, :2].T, segments[:, 2:].T
    boxes = np.array([*np.minimum(one, other), *np.maximum(one, other)])
    return Obstacles(segments, thickness, boxes)


@compiled
def keep_out(
    radius: Annotated[Floats, "n"],
    obstacles: Obstacles,
    before: Annotated[Floats, "n", 2],
    after: Annotated[Floats, "n", 2],
) -> None:
    """Moves bodies that overlap an obstacle out of it.

    A body whose middle went through a segment goes back to where it was. One that
    overlaps a segment is pushed out along the shortest line. One that was pressed into
    a gap too narrow for it, or to where no way leads out, goes back, too. A step longer
    than a body is wide is taken in pieces: else it could lead through a gap that the
    body does not fit into, and a step straight at a wall would end where it began.

    Args:
        radius: Of each body, shape (n,) [m].
        obstacles: Of the home.
        before: Where the bodies were, clear of all obstacles, shape (n, 2) [m].
        after: Where the engine moved them, shape (n, 2) [m]; changed in place.
    """
    for i in range(len(after)):
        a, b = (before[i, 0], before[i, 1]), (after[i, 0], after[i, 1])
        if a == b or _is_clear(a, b, radius[i], obstacles):
            continue
        dx, dy = b[0] - a[0], b[1] - a[1]
        radii = np.sqrt(dx * dx + dy * dy) / radius[i]
        pieces = int(np.ceil(radii)) if radii > LONG else 1
        here = a
        for _ in range(pieces):
            x, y = here[0] + dx / pieces, here[1] + dy / pieces
            here = _moved(here, b if pieces == 1 else (x, y), radius[i], obstacles)
        after[i, 0], after[i, 1] = here


@compiled
def _moved(a: Point, b: Point, radius: float, obstacles: Obstacles) -> Point:
    """Where a body comes to be that goes from a to b; back at a if there is no way."""
    close = _close_to(a, b, radius + PUSHED, obstacles)
    after = b
    meets = _goes_through(a, b, obstacles, close)
    if meets:
        b = a
    for _ in range(ROUNDS):
        x, y, overlaps = _pushed_out(b, radius, obstacles, close)
        meets |= overlaps
        if (x, y) == b:
            break
        b = x, y
    # A push may lead into a gap too narrow, through the other side of it, or to
    # segments that were not looked at; and there may be no way out.
    aside = max(abs(b[0] - after[0]), abs(b[1] - after[1]))
    if meets and (
        (b != a and aside > PUSHED)
        or _goes_through(a, b, obstacles, close)
        or not _fits(b, radius, obstacles, close)
    ):
        return a
    return b


@compiled
def _is_clear(a: Point, b: Point, radius: float, obstacles: Obstacles) -> bool:
    """Whether a body that goes from a to b stays away from the boxes of all segments.

    This is nearly always so.
    """
    thickness, boxes = obstacles.thickness, obstacles.boxes
    box, near = _box_round(a, b), False
    for k in range(len(thickness)):
        near |= _near(box, radius + thickness[k], boxes, k)
    return not near


@compiled
def _away(point: Point, one: Point, other: Point) -> float:
    """Distance of a point from the line between two others."""
    x, y = _offset(point, one, other)
    return np.sqrt(x * x + y * y)


@compiled
def _close_to(a: Point, b: Point, reach: float, obstacles: Obstacles) -> Indices:
    """Indices of the segments whose boxes are within reach of the line from a to b."""
    thickness, boxes = obstacles.thickness, obstacles.boxes
    box, near = _box_round(a, b), np.empty(len(thickness), np.bool_)
    for k in range(len(thickness)):
        near[k] = _near(box, reach + thickness[k], boxes, k)
    close, count = np.empty(len(thickness), np.intp), 0
    for k in range(len(thickness)):
        if near[k]:
            close[count] = k
            count += 1
    return close[:count]


@compiled
def _goes_through(a: Point, b: Point, obstacles: Obstacles, close: Indices) -> bool:
    """Whether the line from a to b crosses one of the segments that are close."""
    crossed = False
    for k in close:
        crossed |= crosses(*a, *b, obstacles.segments[k])
    return crossed


@compiled
def _pushed_out(
    b: Point, radius: float, obstacles: Obstacles, close: Indices
) -> tuple[float, float, bool]:
    """Where a body comes to be that is pushed out of one segment after the other.

    And whether it overlapped any; one whose middle lies on a segment is pushed nowhere.
    """
    segments, thickness = obstacles.segments, obstacles.thickness
    (x, y), overlaps = b, False
    for k in close:
        least = radius + thickness[k]
        gx, gy = _offset((x, y), *_ends(segments[k]))
        gap = np.sqrt(gx * gx + gy * gy)
        if gap < least:
            overlaps = True
            if gap > ON_A_LINE:
                x += gx / gap * (least - gap)
                y += gy / gap * (least - gap)
    return x, y, overlaps


@compiled
def _fits(b: Point, radius: float, obstacles: Obstacles, close: Indices) -> bool:
    """Whether a body overlaps no segment by more than `WEDGED`."""
    segments, thickness = obstacles.segments, obstacles.thickness
    for k in close:
        if _away(b, *_ends(segments[k])) < radius + thickness[k] - WEDGED:
            return False
    return True


@compiled
def _ends(segment: Floats) -> tuple[Point, Point]:
    """Where a segment begins and ends."""
    return (segment[0], segment[1]), (segment[2], segment[3])


@compiled
def _offset(point: Point, one: Point, other: Point) -> Point:
    """From the nearest point of the line between two others to a point."""
    dx, dy = other[0] - one[0], other[1] - one[1]
    ox, oy = point[0] - one[0], point[1] - one[1]
    along = (ox * dx + oy * dy) / max(dx * dx + dy * dy, 1e-12)
    along = min(max(along, 0.0), 1.0)
    return ox - along * dx, oy - along * dy


@compiled
def _box_round(a: Point, b: Point) -> Box:
    """The left, lower, right and upper edge of the box round two points."""
    return min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1])


@compiled
def _near(box: Box, reach: float, boxes: Floats, k: int) -> bool:
    """Whether a box comes within reach of another.

    Four comparisons that spare most segments the exact look; without a branch, so that
    the processor looks at several segments at once.
    """
    return (
        (box[0] <= boxes[2, k] + reach)
        & (box[1] <= boxes[3, k] + reach)
        & (box[2] >= boxes[0, k] - reach)
        & (box[3] >= boxes[1, k] - reach)
    )
