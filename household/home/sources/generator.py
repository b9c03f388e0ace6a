"""Homes drawn by lot: a rectangle is split into rooms, joined by doors and furnished.

The same seed gives the same home. Every home is closed, has all six activities, and
all of it can be walked to. What is drawn from which range is our choice: common
sizes of rooms, doors and furniture.
"""

from collections.abc import Sequence

import numpy as np

from household.config.toml import Point
from household.errors import HouseholdError
from household.home.check import problems
from household.home.floorplan import Door, FloorPlan, Region, Room
from household.home.sources.furnishing import ROOM_KINDS, Box, Furnisher, Piece, middle
from household.home.sources.rooms import (
    FRONT_DOOR,
    Boxes,
    doors_between,
    hub_of,
    split_home,
    walls_between,
)

DOORSTEP = 0.9
"""How far into a room nothing stands in front of a door [m]."""

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
    areas = {room: room_area * share for room, (share, _) in program.items()}
    for _ in range(ATTEMPTS):
        boxes = split_home(rng, areas)
        doors = doors_between(rng, boxes, loops)
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
    furnisher.regions.append(_entrance(doors[0], boxes[hub_of(boxes)]))
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
        walls=walls_between(boxes, doors),
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
