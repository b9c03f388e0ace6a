"""Homes drawn by lot: a rectangle is split into rooms, joined by doors and furnished.

The same seed gives the same home. Every home is closed, has all six activities, and
all of it can be walked to. What is drawn from which range is our choice: common
sizes of rooms, doors and furniture.
"""

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from household.errors import HouseholdError
from household.home.check import problems
from household.home.floorplan import Door, FloorPlan, Region, Room, Wall
from household.home.furnishing import ROOM_KINDS, Box, Furnisher, Piece, middle
from household.records import Point

Segment = tuple[Point, Point]

DOORWAY = 1.2
"""Width of an inner door [m]: two people pass each other."""

FRONT_DOOR = 1.0
"""Width of the front door [m]."""

DOORPOST = 0.3
"""Least wall on either side of a door [m]."""

DOORSTEP = 0.9
"""How far into a room nothing stands in front of a door [m]."""

NARROWEST = 2.2
"""Least side of a room [m]."""

SHARE_PER_ACTIVITY = 0.25
"""What a room that takes in one more activity gains in area, in mean rooms."""

ATTEMPTS = 1000
"""Homes drawn before giving up; a villa takes some tens, a flat a few."""

MOST_ROOMS = 16
"""A large villa; beyond that most draws fail."""


def generate(
    rng: np.random.Generator | int,
    *,
    rooms: int = 6,
    room_area: float = 15.0,
    clutter: float = 0.8,
    loops: float = 0.3,
) -> FloorPlan:
    """Draws a home.

    Args:
        rng: Source of randomness, or a seed.
        rooms: Number of rooms, 1 to 16; few rooms take in what else had its own.
        room_area: Area of a room of mean size [m2], 10 to 40.
        clutter: Share of the furniture that nobody needs for an activity, in [0, 1].
        loops: Chance of a door between two rooms that are joined already, in [0, 1];
            0 gives a tree, in which every door is a bottleneck.

    Returns:
        A home without faults, named after its rooms and its seed if one is given.

    Raises:
        HouseholdError: If an argument is out of range, or no such home can be found.
    """
    _demand("rooms", rooms, 1, MOST_ROOMS)
    _demand("room_area", room_area, 10.0, 40.0)
    _demand("clutter", clutter, 0.0, 1.0)
    _demand("loops", loops, 0.0, 1.0)
    name = f"generated_{rooms}" + (
        "" if isinstance(rng, np.random.Generator) else f"_{rng}"
    )
    rng = np.random.default_rng(rng)
    program = _program(rooms)
    for _ in range(ATTEMPTS):
        boxes = _split_home(rng, program, room_area)
        doors = _doors(rng, boxes, loops)
        if doors:
            plan = _furnished(rng, name, boxes, doors, program, clutter)
            if plan is not None and not problems(plan):
                return plan
    raise HouseholdError(
        f"no home with {rooms} rooms of {room_area} m2 found; allowed: larger rooms"
    )


def _demand(name: str, value: float, low: float, high: float) -> None:
    """Refuses an argument that is out of range."""
    if not low <= value <= high:
        raise HouseholdError(
            f"{name}: {value} is out of range; allowed: {low} to {high}"
        )


Program = dict[str, tuple[float, tuple[Piece, ...]]]
"""What a home consists of: name of the room -> area in mean rooms, and its pieces."""


def _program(rooms: int) -> Program:
    """The commonest kinds of rooms; the first also takes in what they leave out."""
    kinds = list(ROOM_KINDS.items())
    program: Program = {}
    for i in range(rooms):
        name, content = kinds[i % len(kinds)]
        program[name if i < len(kinds) else f"{name} {i // len(kinds) + 1}"] = content
    present = {p.activity for _, pieces in program.values() for p in pieces}
    every = {p.activity: p for _, pieces in ROOM_KINDS.values() for p in pieces}
    missing = tuple(piece for key, piece in every.items() if key not in present)
    living = next(iter(program))
    area, pieces = program[living]
    program[living] = (area + SHARE_PER_ACTIVITY * len(missing), pieces + missing)
    return program


Boxes = dict[str, Box]
"""Rooms by name, between the middles of their walls [m]."""


def _split_home(rng: np.random.Generator, program: Program, room_area: float) -> Boxes:
    """Cuts a rectangle into the program's rooms, in random order."""
    names = [str(name) for name in rng.permutation(list(program))]
    area = room_area * sum(share for share, _ in program.values())
    width = np.sqrt(area * rng.uniform(1.0, 1.7))
    whole = (0.0, 0.0, round(float(width), 1), round(float(area / width), 1))
    return _split(rng, whole, names, program)


def _split(
    rng: np.random.Generator, box: Box, names: Sequence[str], program: Program
) -> Boxes:
    """Cuts a rectangle across its longer side, and both parts again."""
    if len(names) == 1:
        return {names[0]: box}
    shares = np.cumsum([program[name][0] for name in names])
    shares /= shares[-1]
    at = int(np.abs(shares[:-1] - rng.uniform(0.4, 0.6)).argmin())
    left, low, right, high = box
    if right - left > high - low:
        cut = round(float(left + shares[at] * (right - left)), 1)
        parts = (left, low, cut, high), (cut, low, right, high)
    else:
        cut = round(float(low + shares[at] * (high - low)), 1)
        parts = (left, low, right, cut), (left, cut, right, high)
    return _split(rng, parts[0], names[: at + 1], program) | _split(
        rng, parts[1], names[at + 1 :], program
    )


def _doors(rng: np.random.Generator, boxes: Boxes, loops: float) -> list[Door]:
    """The front door, shut, and enough inner doors; none if rooms stay apart."""
    sides = np.array([(b[2] - b[0], b[3] - b[1]) for b in boxes.values()])
    hub = _hub(boxes)
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


def _hub(boxes: Boxes) -> str:
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


def _walls(boxes: Boxes, doors: Sequence[Door]) -> tuple[Wall, ...]:
    """Every room's sides, once each, with gaps for the doors."""
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


def _furnished(
    rng: np.random.Generator,
    name: str,
    boxes: Boxes,
    doors: Sequence[Door],
    program: Program,
    clutter: float,
) -> FloorPlan | None:
    """The home with all that it needs and some more; None if that does not fit."""
    steps = [_doorstep(door) for door in doors]
    furnisher = Furnisher(rng=rng, clear=steps)
    furnisher.regions.append(_entrance(doors[0], boxes[_hub(boxes)]))
    wanted = [(room, piece) for room in boxes for piece in program[room][1]]
    for room, piece in wanted:
        if piece.activity and not furnisher.add(piece, boxes[room], room):
            return None
    for room, piece in wanted:
        if not piece.activity and rng.random() < clutter:
            furnisher.add(piece, boxes[room], room)
    return FloorPlan(
        name=name,
        description=f"A generated home of {len(boxes)} rooms",
        walls=_walls(boxes, doors),
        doors=tuple(doors),
        furniture=tuple(furnisher.furniture),
        regions=tuple(furnisher.regions),
        rooms=tuple(Room(name=n, corners=_corners(b)) for n, b in boxes.items()),
    )


def _doorstep(door: Door) -> Box:
    """What stays free on both sides of a door."""
    (x, y), (x2, y2) = door.start, door.end
    dx, dy = (0.0, DOORSTEP) if y == y2 else (DOORSTEP, 0.0)
    return (x - dx, y - dy, x2 + dx, y2 + dy)


def _entrance(front: Door, room: Box) -> Region:
    """Where people appear: just inside the front door."""
    door = np.array(middle((*front.start, *front.end)))
    across = np.array([front.end[1] - front.start[1], front.end[0] - front.start[0]])
    inward = across / FRONT_DOOR * np.sign(np.array(middle(room)) - door)
    spot, ahead = door + 0.8 * inward, door + 2.0 * inward
    return Region(
        name="entrance",
        activity="entering",
        center=(round(float(spot[0]), 2), round(float(spot[1]), 2)),
        radius=0.55,
        facing=(round(float(ahead[0]), 2), round(float(ahead[1]), 2)),
    )


def _corners(box: Box) -> tuple[Point, ...]:
    left, low, right, high = box
    return ((left, low), (right, low), (right, high), (left, high))
