"""Solid ground: bodies stay out of walls and furniture, whatever pushes them.

Physics engines let a fast body sink into a wall for a tick before they push it back;
in a crowd that can be a hand's breadth. This sets it right after the engine's ticks.
"""

import numpy as np

from household.compiled.arrays import Floats, Indices
from household.compiled.jit import compiled
from household.home.geometry import crosses

Point = tuple[float, float]
Box = tuple[float, float, float, float]

ROUNDS = 3
"""How often a body is pushed out: a corner pushes it from one side to the other."""

PUSHED = 0.5
"""How far walls push a body at most [m]: only what is closer is looked at, and who
would be pushed further goes back."""

WEDGED = 0.005
"""Who still overlaps by more after that [m] was pressed to where it does not fit."""


@compiled
def keep_out(
    radius: Floats,
    segments: Floats,
    thickness: Floats,
    boxes: Floats,
    before: Floats,
    after: Floats,
) -> None:
    """Puts bodies back that sank into something solid.

    A body whose middle went through a segment goes back to where it was; one that
    overlaps a segment is pushed out along the shortest way; one that was pressed into
    a gap too narrow for it, or through it, goes back, too.

    Args:
        radius: Shape (n,) [m].
        segments: Shape (m, 4), rows of x1, y1, x2, y2 [m].
        thickness: Half thickness of each segment, shape (m,) [m].
        boxes: Of the segments, from `boxes_round`, shape (4, m) [m].
        before: Where the bodies were, out of everything solid, shape (n, 2) [m].
        after: Where the engine moved them, shape (n, 2) [m]; changed in place.
    """
    for i in range(len(after)):
        a, b = (before[i, 0], before[i, 1]), (after[i, 0], after[i, 1])
        if a == b or _is_clear(a, b, radius[i], thickness, boxes):
            continue
        close = _close_to(a, b, radius[i] + PUSHED, thickness, boxes)
        moved = _goes_through(a, b, segments, close)
        if moved:
            b = a
        for _ in range(ROUNDS):
            pushed = _pushed_out(b, radius[i], segments, thickness, close)
            if pushed == b:
                break
            b, moved = pushed, True
        # A push may lead into a gap too narrow, through the other side of it, or to
        # where nobody has looked.
        aside = max(abs(b[0] - after[i, 0]), abs(b[1] - after[i, 1]))
        if moved and (
            (b != a and aside > PUSHED)
            or _goes_through(a, b, segments, close)
            or not _fits(b, radius[i], segments, thickness, close)
        ):
            b = a
        after[i, 0], after[i, 1] = b


@compiled
def _is_clear(
    a: Point, b: Point, radius: float, thickness: Floats, boxes: Floats
) -> bool:
    """Whether a body that goes from a to b stays away from the boxes of all segments.

    It nearly always does.
    """
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
def _close_to(
    a: Point, b: Point, reach: float, thickness: Floats, boxes: Floats
) -> Indices:
    """The segments whose boxes are within reach of the way from a to b."""
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
def _goes_through(a: Point, b: Point, segments: Floats, close: Indices) -> bool:
    """Whether the way from a to b crosses one of the segments that are close."""
    crossed = False
    for k in close:
        crossed |= crosses(*a, *b, segments[k])
    return crossed


@compiled
def _pushed_out(
    b: Point, radius: float, segments: Floats, thickness: Floats, close: Indices
) -> Point:
    """Where a body comes to be that is pushed out of one segment after the other."""
    x, y = b
    for k in close:
        least = radius + thickness[k]
        gx, gy = _offset((x, y), *_ends(segments[k]))
        gap = np.sqrt(gx * gx + gy * gy)
        if 1e-9 < gap < least:
            x += gx / gap * (least - gap)
            y += gy / gap * (least - gap)
    return x, y


@compiled
def _fits(
    b: Point, radius: float, segments: Floats, thickness: Floats, close: Indices
) -> bool:
    """Whether a body overlaps no segment, but for a little."""
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


def boxes_round(segments: Floats) -> Floats:
    """The box round each segment.

    Args:
        segments: Shape (m, 4), rows of x1, y1, x2, y2 [m].

    Returns:
        Shape (4, m): left, lower, right and upper edges [m].
    """
    one, other = segments[:, :2].T, segments[:, 2:].T
    return np.array([*np.minimum(one, other), *np.maximum(one, other)])
