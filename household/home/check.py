"""What is wrong with a floor plan that is well-formed: faults of meaning, not of type.

Every fault is one line "path: what; allowed: what would do", the path being the one
inside the TOML file.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache

import msgspec
import numpy as np
from scipy.ndimage import label

from household.compiled.arrays import Floats, Indices, Mask
from household.config.toml import Point
from household.errors import HouseholdError
from household.home.floorplan import Door, FloorPlan, Furniture, Region, Room, Wall
from household.home.geometry import distance_to_box, distance_to_segments
from household.home.navigation.routes import CLEARANCE, routes_of

LARGEST = 100.0
"""Longest side of a home [m]; a villa is 20 m, and memory grows with the area."""

SHORTEST = 0.01
"""Shortest wall or door, and nearest thing to look at [m]: a direction needs length."""

FINE = 0.05
"""Cell [m] of the search for gaps: half the usual wall, so that no wall leaks."""

THICKEST = 0.5
"""Of a wall [m]: an old stone house."""

RIM = 6
"""Cells round the plan, so that all that is outdoors hangs together."""

Named = Sequence[Furniture | Region | Room]


def checked(plan: FloorPlan, origin: str) -> FloorPlan:
    """The plan itself, if nothing is wrong with it.

    Args:
        plan: The home to check.
        origin: The file's name, for the error message.

    Raises:
        HouseholdError: Names the file and the first fault, in one line.
    """
    faults = problems(plan)
    if faults:
        raise HouseholdError(f"{origin}: {faults[0]}")
    return plan


@lru_cache(maxsize=64)
def problems(plan: FloorPlan) -> tuple[str, ...]:
    """Every fault of a floor plan, in the order in which to mend them.

    Args:
        plan: The home to check.

    Returns:
        One line per fault, "path: what; allowed: what would do"; empty if none.
    """
    for stage in STAGES:
        faults = tuple(fault for check in stage for fault in check(plan))
        if faults:
            return faults
    return ()


def _numbers(plan: FloorPlan) -> Iterator[str]:
    """TOML knows nan and inf, geometry does not."""
    for path, value in _leaves(msgspec.to_builtins(plan), ""):
        if isinstance(value, float) and not abs(value) <= 1e6:
            yield f"{path}: {value} is not a length or an angle; allowed: finite values"


def _leaves(data: object, path: str) -> Iterator[tuple[str, object]]:
    """Every value inside nested plain data, with its path."""
    if isinstance(data, dict):
        for name, value in data.items():
            yield from _leaves(value, f"{path}.{name}" if path else str(name))
    elif isinstance(data, list | tuple):
        for i, value in enumerate(data):
            yield from _leaves(value, f"{path}[{i}]")
    else:
        yield path, data


def _names(plan: FloorPlan) -> Iterator[str]:
    """Things are told apart by their names."""
    kinds: dict[str, Named] = {
        "rooms": plan.rooms,
        "furniture": plan.furniture,
        "regions": plan.regions,
    }
    for kind, things in kinds.items():
        first: dict[str, int] = {}
        for i, thing in enumerate(things):
            j = first.setdefault(thing.name, i)
            if j != i:
                yield (
                    f"{kind}[{i}].name: {thing.name!r} is also {kind}[{j}]; "
                    "allowed: a name of its own"
                )


def _lengths(plan: FloorPlan) -> Iterator[str]:
    """Walls and doors have a length, looks a direction, and a home a sensible size."""
    parts: dict[str, Sequence[Wall | Door]] = {"walls": plan.walls, "doors": plan.doors}
    for kind, lines in parts.items():
        for i, line in enumerate(lines):
            if math.dist(line.start, line.end) < SHORTEST:
                yield f"{kind}[{i}]: has no length; allowed: two different points"
    for i, region in enumerate(plan.regions):
        if math.dist(region.center, region.facing) < SHORTEST:
            yield (
                f"regions[{i}].facing: is the center itself; "
                "allowed: a point to look at"
            )
    if plan.wall_thickness > THICKEST:
        yield f"wall_thickness: {plan.wall_thickness} m; allowed: at most {THICKEST} m"
    side = float((plan.upper - plan.lower).max())
    if not 1.0 <= side <= LARGEST:
        yield f"walls: {side:.4g} m from end to end; allowed: 1 m to {LARGEST:.0f} m"


def _centers(plan: FloorPlan) -> Iterator[str]:
    """A person's body fits where its activity is."""
    for i, region in enumerate(plan.regions):
        fault = _fault_at(plan, region.center)
        if fault:
            yield f"regions[{i}].center: {region.name!r} is {fault}"


def _fault_at(plan: FloorPlan, point: Point) -> str:
    """Why nobody can stand at a point, or nothing."""
    spot = np.array([point])
    if (spot[0] < plan.lower).any() or (spot[0] > plan.upper).any():
        return "outside the plan; allowed: a place within the walls"
    for box in plan.furniture:
        if distance_to_box(spot, box.center, box.size, box.angle)[0] == 0:
            return f"covered by furniture {box.name!r}; allowed: a free place beside it"
    if not routes_of(plan).free[routes_of(plan).cell(spot[0])]:
        return (
            "where no body fits; allowed: a place that clears walls and furniture by "
            f"{CLEARANCE + 0.05:.2f} m"
        )
    return ""


def _doors(plan: FloorPlan) -> Iterator[str]:
    """A door that stands open lets people through."""
    narrowest = 2 * CLEARANCE + plan.wall_thickness
    walls = np.array([(*wall.start, *wall.end) for wall in plan.walls])
    for i, door in enumerate(plan.doors):
        if not door.open:
            continue
        width = math.dist(door.start, door.end)
        if width < narrowest:
            yield (
                f"doors[{i}]: {width:.2f} m wide, nobody fits through; "
                f"allowed: at least {narrowest:.2f} m, or open = false"
            )
        gaps = distance_to_segments(np.array([_middle(door)]), walls)[0]
        if gaps.min() < FINE:
            yield (
                f"doors[{i}]: walls[{gaps.argmin()}] runs across it; "
                "allowed: a gap between walls"
            )


def _middle(door: Door) -> Point:
    return (door.start[0] + door.end[0]) / 2, (door.start[1] + door.end[1]) / 2


def _closed(plan: FloorPlan) -> Iterator[str]:
    """Walls and closed doors keep the people in."""
    outdoors = _outdoors(plan, plan.wall_segments)
    leaks = [i for i, r in enumerate(plan.regions) if _at(plan, outdoors, r.center)]
    if not leaks:
        return
    shut = [(*door.start, *door.end) for door in plan.doors if door.open]
    sealed = _outdoors(plan, np.vstack([plan.wall_segments, *shut]))
    for i, door in enumerate(plan.doors):
        if door.open and any(_at(plan, sealed, side) for side in _sides(plan, door)):
            yield f"doors[{i}].open: true, but it leads outdoors; allowed: false"
    for i in leaks:
        if _at(plan, sealed, plan.regions[i].center):
            yield (
                f"regions[{i}].center: {plan.regions[i].name!r} is outdoors, or the "
                "walls have a gap; allowed: a place that walls and closed doors enclose"
            )


def _sides(plan: FloorPlan, door: Door) -> tuple[Point, Point]:
    """A point just off either face of a door's leaf [m]."""
    (x, y), width = _middle(door), math.dist(door.start, door.end)
    reach = (plan.wall_thickness / 2 + 4 * FINE) / width
    dx = (door.start[1] - door.end[1]) * reach
    dy = (door.end[0] - door.start[0]) * reach
    return (x + dx, y + dy), (x - dx, y - dy)


def _outdoors(plan: FloorPlan, segments: Floats) -> Mask:
    """Marks the cells of a fine grid that can be reached from outside the walls."""
    reach = max(plan.wall_thickness / 2, FINE)
    edge = int(reach / FINE) + 2
    last = _cell(plan, plan.upper)
    open_ = np.ones((last[0] + RIM + 1, last[1] + RIM + 1), dtype=np.bool_)
    for row in segments:
        low = np.maximum(_cell(plan, np.minimum(row[:2], row[2:])) - edge, 0)
        high = _cell(plan, np.maximum(row[:2], row[2:])) + edge + 1
        near = open_[low[0] : high[0], low[1] : high[1]]
        points = np.indices(near.shape).reshape(2, -1).T + low
        middles = plan.lower + (points - RIM + 0.5) * FINE
        gaps = distance_to_segments(middles, row[None])
        near &= (gaps > reach).reshape(near.shape)
    parts, _ = label(open_)
    outdoors: Mask = parts == parts[0, 0]
    return outdoors


def _cell(plan: FloorPlan, point: Floats) -> Indices:
    """Indices of the fine cell that holds a point."""
    cell: Indices = np.floor((point - plan.lower) / FINE).astype(int) + RIM
    return cell


def _at(plan: FloorPlan, outdoors: Mask, point: Point) -> bool:
    """Whether a point is outdoors."""
    cell = np.clip(_cell(plan, np.array(point)), 0, np.array(outdoors.shape) - 1)
    return bool(outdoors[tuple(cell)])


def _ways(plan: FloorPlan) -> Iterator[str]:
    """Every activity can be walked to from the entrance."""
    enters = (r for r in plan.regions if r.activity == "entering")
    entrance = next(enters, plan.regions[0])
    routes, start = routes_of(plan), np.array(entrance.center)
    for i, region in enumerate(plan.regions):
        if not routes.connects(start, np.array(region.center)):
            yield (
                f"regions[{i}] {region.name!r}: unreachable from region "
                f"{entrance.name!r}; allowed: a place that people can walk to"
            )


def _circles(plan: FloorPlan) -> Iterator[str]:
    """No place belongs to two activities, none to one that goes on behind a wall."""
    for i, region in enumerate(plan.regions):
        for j, other in enumerate(plan.regions[:i]):
            room = math.dist(region.center, other.center) - other.radius
            if region.activity != other.activity and region.radius > room + 1e-9:
                yield (
                    f"regions[{i}].radius: {region.radius} m reaches into regions[{j}] "
                    f"{other.name!r}; allowed: circles of different activities apart"
                )
        limit = _reach(plan, region)
        if region.radius > limit:
            yield (
                f"regions[{i}].radius: {region.radius} m takes in people behind a "
                f"wall; allowed: at most {limit:.2f} m"
            )


def _reach(plan: FloorPlan, region: Region) -> float:
    """Radius [m] that ends where someone could stand behind the nearest wall."""
    center = np.array([region.center])
    gap = float(distance_to_segments(center, plan.wall_segments).min())
    return gap + plan.wall_thickness / 2 + CLEARANCE


Check = Callable[[FloorPlan], Iterator[str]]

STAGES: tuple[tuple[Check, ...], ...] = (
    (_numbers,),
    (_names, _lengths),
    (_centers, _doors),
    (_closed,),
    (_ways, _circles),
)
"""A stage is worth running only where the ones before it found nothing."""
