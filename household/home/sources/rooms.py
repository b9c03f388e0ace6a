"""Rooms by lot: a rectangle is cut into rooms, joined by doors, and walled.

All walls are level or upright, so a room is a box and a wall a stretch of its side.
"""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np

from household.config.toml import Point
from household.home.floorplan import Door, Wall
from household.home.sources.furnishing import Box

Segment = tuple[Point, Point]

DOORWAY = 1.2
"""Width of an inner door [m]: two people pass each other."""

FRONT_DOOR = 1.0
"""Width of the front door [m]."""

DOORPOST = 0.3
"""Least wall on either side of a door [m]."""

NARROWEST = 2.2
"""Least side of a room [m]."""

Boxes = dict[str, Box]
"""Rooms by name, between the middles of their walls [m]."""


def split_home(rng: np.random.Generator, areas: Mapping[str, float]) -> Boxes:
    """Cuts a rectangle into rooms, in random order.

    Args:
        rng: Chooses the order, the shape and the cuts.
        areas: Area that each room should have [m2], by its name.

    Returns:
        Rooms that fill the rectangle; their corners lie on a grid of 0.1 m.
    """
    names = [str(name) for name in rng.permutation(list(areas))]
    area = sum(areas.values())
    width = np.sqrt(area * rng.uniform(1.0, 1.7))
    whole = (0.0, 0.0, round(float(width), 1), round(float(area / width), 1))
    return _split(rng, whole, names, areas)


def _split(
    rng: np.random.Generator, box: Box, names: Sequence[str], areas: Mapping[str, float]
) -> Boxes:
    """Cuts a rectangle across its longer side, and both parts again."""
    if len(names) == 1:
        return {names[0]: box}
    shares = np.cumsum([areas[name] for name in names])
    shares /= shares[-1]
    at = int(np.abs(shares[:-1] - rng.uniform(0.4, 0.6)).argmin())
    left, low, right, high = box
    if right - left > high - low:
        cut = round(float(left + shares[at] * (right - left)), 1)
        parts = (left, low, cut, high), (cut, low, right, high)
    else:
        cut = round(float(low + shares[at] * (high - low)), 1)
        parts = (left, low, right, cut), (left, cut, right, high)
    return _split(rng, parts[0], names[: at + 1], areas) | _split(
        rng, parts[1], names[at + 1 :], areas
    )


def doors_between(rng: np.random.Generator, boxes: Boxes, loops: float) -> list[Door]:
    """Joins all rooms, if their walls are long enough for that.

    Args:
        rng: Chooses the doors.
        boxes: The rooms.
        loops: Chance of a door between two rooms that are joined already.

    Returns:
        The front door, shut, and the inner doors; none at all if a room is too narrow
        or stays cut off.
    """
    sides = np.array([(b[2] - b[0], b[3] - b[1]) for b in boxes.values()])
    hub = hub_of(boxes)
    outer = [
        s for s in _outer_walls(boxes)[hub] if _length(s) >= FRONT_DOOR + 2 * DOORPOST
    ]
    if sides.min() < NARROWEST or not outer:
        return []
    front = _gap_in(rng, outer[int(rng.integers(len(outer)))], FRONT_DOOR)
    inner = _passages(rng, boxes, hub, loops)
    if not inner and len(boxes) > 1:
        return []
    shut = Door(start=front[0], end=front[1], open=False)
    return [shut, *(Door(start=a, end=b) for a, b in inner)]


def hub_of(boxes: Boxes) -> str:
    """The room behind the front door."""
    return "hall" if "hall" in boxes else "living room"


def _passages(
    rng: np.random.Generator, boxes: Boxes, hub: str, loops: float
) -> list[Segment]:
    """Doorways that join all rooms, the hub's first; none if rooms stay apart."""
    shared = {
        pair: wall
        for pair in combinations(boxes, 2)
        if (wall := _shared(boxes[pair[0]], boxes[pair[1]]))
        and _length(wall) >= DOORWAY + 2 * DOORPOST
    }
    pairs = [list(shared)[i] for i in rng.permutation(len(shared))]
    part = {name: name for name in boxes}
    doorways = []
    for a, b in sorted(pairs, key=lambda pair: hub not in pair):
        if part[a] != part[b]:
            part = {n: part[a] if p == part[b] else p for n, p in part.items()}
        elif rng.random() >= loops:
            continue
        doorways.append(_gap_in(rng, shared[a, b], DOORWAY))
    return doorways if len(set(part.values())) == 1 else []


def _gap_in(rng: np.random.Generator, wall: Segment, width: float) -> Segment:
    """A random stretch of an upright or level wall that leaves room for the posts."""
    (x, y), (_, y2) = wall
    slack = max(_length(wall) - width - 2 * DOORPOST, 0.0)
    start = DOORPOST + math.floor(10 * rng.uniform(0.0, slack)) / 10
    if y == y2:
        return (round(x + start, 2), y), (round(x + start + width, 2), y)
    return (x, round(y + start, 2)), (x, round(y + start + width, 2))


def _length(wall: Segment) -> float:
    return round(math.dist(*wall), 6)


def _shared(a: Box, b: Box) -> Segment | None:
    """The wall that two rooms have in common, or nothing."""
    low_x, low_y = max(a[0], b[0]), max(a[1], b[1])
    high_x, high_y = min(a[2], b[2]), min(a[3], b[3])
    upright, level = (
        low_x == high_x and low_y < high_y,
        low_y == high_y and low_x < high_x,
    )
    return ((low_x, low_y), (high_x, high_y)) if upright or level else None


def _outer_walls(boxes: Boxes) -> dict[str, list[Segment]]:
    """For each room the sides that it shares with no other."""
    corners = np.array(list(boxes.values()))
    left, low = corners[:, :2].min(axis=0)
    right, high = corners[:, 2:].max(axis=0)
    whole = (float(left), float(low), float(right), float(high))
    around = [
        (whole[0] - 1, whole[1], whole[0], whole[3]),
        (whole[2], whole[1], whole[2] + 1, whole[3]),
        (whole[0], whole[1] - 1, whole[2], whole[1]),
        (whole[0], whole[3], whole[2], whole[3] + 1),
    ]
    return {
        name: [side for other in around if (side := _shared(box, other))]
        for name, box in boxes.items()
    }


def walls_between(boxes: Boxes, doors: Sequence[Door]) -> tuple[Wall, ...]:
    """Every room's sides, once each, with gaps for the doors, open or shut."""
    sides = [side for walls in _outer_walls(boxes).values() for side in walls]
    pairs = combinations(boxes.values(), 2)
    sides += [side for a, b in pairs if (side := _shared(a, b))]
    return tuple(wall for side in sides for wall in _cut(side, doors))


def _cut(side: Segment, doors: Sequence[Door]) -> list[Wall]:
    """What a level or upright wall is left with between its doors."""
    axis = 0 if side[0][1] == side[1][1] else 1
    level = side[0][1 - axis]
    ends = [side[0][axis], side[1][axis]]
    for door in doors:
        on_line = door.start[1 - axis] == door.end[1 - axis] == level
        if on_line and side[0][axis] <= door.start[axis] < side[1][axis]:
            ends += [door.start[axis], door.end[axis]]
    ends.sort()
    points: list[Point] = [(e, level) if axis == 0 else (level, e) for e in ends]
    stretches = zip(points[::2], points[1::2], strict=True)
    return [Wall(start=a, end=b) for a, b in stretches]
