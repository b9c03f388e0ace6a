"""What is wrong with a floor plan: faults of its fields, and of how they fit together.

Every fault is one line "path: what; allowed: what would do", the path being the one
inside the TOML file. All are told at once, but for those that follow from another one:
nobody can walk to a place that lies outdoors.
"""

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from household.config.faults import MOST, Fault, Sound, first_faults
from household.config.mending import mended
from household.config.toml import load, read_toml, shipped
from household.errors import HouseholdError
from household.home.enclosure import FINE, is_outdoors, middle_of, outdoors, sides_of
from household.home.floorplan import Door, FloorPlan, Furniture, Region, Room, Wall
from household.home.geometry import distance_to_box, distance_to_segments
from household.home.navigation.routes import CLEARANCE, routes_of

LARGEST = 100.0
"""Longest side of a home [m]; a villa is 20 m, and memory grows with the area."""

SHORTEST = 0.01
"""Shortest wall or door, and nearest thing to look at [m]: a direction needs length."""

THICKEST = 0.5
"""Of a wall [m]: an old stone house."""

MOST_WALL = 5000.0
"""Length of all walls together [m]; a villa has 150 m, and time grows with it."""

SPARE = "smart_room"
"""The shipped home that stands in for what is missing, while the rest is checked."""


def checked(plan: FloorPlan, origin: str) -> FloorPlan:
    """The plan itself, if nothing is wrong with it.

    Args:
        plan: The home to check.
        origin: The file's name, for the error message.

    Raises:
        HouseholdError: Names the file and the first fault, in one line.
    """
    found = problems(plan)
    if found:
        raise HouseholdError(f"{origin}: {found[0]}")
    return plan


def problems(plan: FloorPlan) -> tuple[str, ...]:
    """Every fault of a floor plan, in the order in which to mend them.

    Args:
        plan: The home to check.

    Returns:
        One line per fault, "path: what; allowed: what would do"; empty if none.
    """
    return tuple(str(fault) for fault in plan_faults(plan))


@lru_cache(maxsize=64)
def plan_faults(plan: FloorPlan) -> tuple[Fault, ...]:
    """The same with their paths."""
    return tuple(home_faults(msgspec.to_builtins(plan)))


def file_faults(path: Path) -> tuple[Fault, ...]:
    """Every fault of a home's file.

    Raises:
        HouseholdError: If the file cannot be read.
    """
    try:
        return plan_faults(load(path, FloorPlan))
    except HouseholdError:  # If not by a field, then it cannot be read here either.
        return tuple(home_faults(read_toml(path)))


def home_faults(data: dict[str, Any]) -> Iterator[Fault]:
    """Every fault of a home as it stands in a file.

    Args:
        data: What the file holds.

    Yields:
        First what is wrong with single fields, then how the sound ones fit together.
    """
    wrong = first_faults(data, FloorPlan)
    yield from wrong
    if len(wrong) > MOST:
        return
    yield from home_misfits(data, wrong)


def home_misfits(data: dict[str, Any], wrong: Sequence[Fault]) -> Iterator[Fault]:
    """How the parts of a home do not fit together.

    Args:
        data: What the file holds.
        wrong: Faults of single fields; nothing is said about those.
    """
    if wrong:
        data = mended(data, FloorPlan, read_toml(shipped("home")[SPARE]))
    yield from _misfits(msgspec.convert(data, FloorPlan), Sound(wrong))


def _misfits(plan: FloorPlan, sound: Sound) -> Iterator[Fault]:
    """How the parts of a plan do not fit together."""
    yield from _names(plan, sound)
    yield from _lengths(plan, sound)
    yield from _directions(plan, sound)
    sizes = tuple(_sizes(plan, sound))
    yield from sizes
    if sound("walls", "doors", "furniture", "wall_thickness") and not sizes:
        places = [i for i in range(len(plan.regions)) if sound(f"regions[{i}]")]
        yield from _ground(plan, places)


def _names(plan: FloorPlan, sound: Sound) -> Iterator[Fault]:
    """Things are told apart by their names."""
    kinds: dict[str, Sequence[Furniture | Region | Room]] = {
        "rooms": plan.rooms,
        "furniture": plan.furniture,
        "regions": plan.regions,
    }
    for kind, things in kinds.items():
        first: dict[str, int] = {}
        for i, thing in enumerate(things):
            if not sound(f"{kind}[{i}].name"):
                continue
            j = first.setdefault(thing.name, i)
            if j != i:
                yield Fault(
                    f"{kind}[{i}].name",
                    f"{thing.name!r} is also {kind}[{j}]; allowed: a name of its own",
                )


def _lengths(plan: FloorPlan, sound: Sound) -> Iterator[Fault]:
    """Walls and doors have a length."""
    parts: dict[str, Sequence[Wall | Door]] = {"walls": plan.walls, "doors": plan.doors}
    for kind, lines in parts.items():
        for i, line in enumerate(lines):
            if sound(f"{kind}[{i}]") and _is_a_point(line):
                yield Fault(
                    f"{kind}[{i}]", "has no length; allowed: two different points"
                )


def _is_a_point(line: Wall | Door) -> bool:
    return math.dist(line.start, line.end) < SHORTEST


def _directions(plan: FloorPlan, sound: Sound) -> Iterator[Fault]:
    """Looks have a direction."""
    for i, region in enumerate(plan.regions):
        here = f"regions[{i}]."
        near = math.dist(region.center, region.facing) < SHORTEST
        if near and sound(here + "center", here + "facing"):
            yield Fault(
                here + "facing", "is the center itself; allowed: a point to look at"
            )


def _sizes(plan: FloorPlan, sound: Sound) -> Iterator[Fault]:
    """A home is of a sensible size."""
    if plan.wall_thickness > THICKEST and sound("wall_thickness"):
        yield Fault(
            "wall_thickness", f"{plan.wall_thickness} m; allowed: at most {THICKEST} m"
        )
    side = float((plan.upper - plan.lower).max())
    if not 1.0 <= side <= LARGEST and sound("walls", "doors"):
        yield Fault(
            "walls",
            f"{side:.4g} m from end to end; allowed: 1 m to {LARGEST:.0f} m",
        )
    x1, y1, x2, y2 = plan.wall_segments.T
    total = float(np.hypot(x2 - x1, y2 - y1).sum())
    if total > MOST_WALL and sound("walls", "doors"):
        yield Fault("walls", f"{total:.4g} m in all; allowed: up to {MOST_WALL:.0f} m")


def _ground(plan: FloorPlan, places: list[int]) -> Iterator[Fault]:
    """What people meet with who walk through a home.

    Args:
        plan: Of a sensible size, with sound walls, doors and furniture.
        places: The regions that are sound.
    """
    covered = {i: why for i in places if (why := _fault_at(plan, i))}
    for i, why in covered.items():
        region = plan.regions[i]
        yield Fault(f"regions[{i}].center", f"{region.name!r} is {why}")
    yield from _doors(plan)
    places = [i for i in places if i not in covered]
    open_air = outdoors(plan, plan.wall_segments)
    leaks = [i for i in places if is_outdoors(plan, open_air, plan.regions[i].center)]
    if leaks:
        yield from _leaks(plan, leaks)
    yield from _ways(plan, [i for i in places if i not in leaks])
    yield from _circles(plan, places)


def _fault_at(plan: FloorPlan, place: int) -> str:
    """Why nobody can stand at the center of a region, or nothing."""
    spot = np.array([plan.regions[place].center])
    if (spot[0] < plan.lower).any() or (spot[0] > plan.upper).any():
        return "outside the plan; allowed: a place within the walls"
    for box in plan.furniture:
        if distance_to_box(spot, box.center, box.size, box.angle)[0] == 0:
            return f"covered by furniture {box.name!r}; allowed: a free place beside it"
    if not routes_of(plan).has_room(plan.regions[place].center):
        return (
            "where no body fits; allowed: a place that clears walls and furniture by "
            f"{CLEARANCE + 0.05:.2f} m"
        )
    return ""


def _doors(plan: FloorPlan) -> Iterator[Fault]:
    """A door that stands open lets people through."""
    narrowest = 2 * CLEARANCE + plan.wall_thickness
    walls = np.array([(*wall.start, *wall.end) for wall in plan.walls])
    for i, door in enumerate(plan.doors):
        if not door.open or _is_a_point(door):
            continue
        width = math.dist(door.start, door.end)
        if width < narrowest:
            yield Fault(
                f"doors[{i}]",
                f"{width:.2f} m wide, nobody fits through; "
                f"allowed: at least {narrowest:.2f} m, or open = false",
            )
        gaps = distance_to_segments(np.array([middle_of(door)]), walls)[0]
        if gaps.min() < FINE:
            yield Fault(
                f"doors[{i}]",
                f"walls[{gaps.argmin()}] runs across it; allowed: a gap between walls",
            )


def _leaks(plan: FloorPlan, leaks: list[int]) -> Iterator[Fault]:
    """Walls and closed doors keep the people in, but not these ones."""
    shut = [(*d.start, *d.end) for d in plan.doors if d.open and not _is_a_point(d)]
    walls = [plan.wall_segments, *np.array(shut)[:, None]] if shut else None
    sealed = outdoors(plan, np.vstack(walls) if walls else plan.wall_segments)
    for i, door in enumerate(plan.doors):
        if not door.open or _is_a_point(door):
            continue
        if any(is_outdoors(plan, sealed, side) for side in sides_of(plan, door)):
            yield Fault(
                f"doors[{i}].open", "true, but it leads outdoors; allowed: false"
            )
    for i in leaks:
        region = plan.regions[i]
        if is_outdoors(plan, sealed, region.center):
            yield Fault(
                f"regions[{i}].center",
                f"{region.name!r} is outdoors, or the walls have a gap; "
                "allowed: a place that walls and closed doors enclose",
            )


def _ways(plan: FloorPlan, places: list[int]) -> Iterator[Fault]:
    """Every activity can be walked to from the entrance."""
    enters = [i for i in places if plan.regions[i].activity == "entering"]
    for entrance in (enters or places)[:1]:
        routes, start = routes_of(plan), plan.regions[entrance]
        for i in places:
            region = plan.regions[i]
            if not routes.connects(np.array(start.center), np.array(region.center)):
                yield Fault(
                    f"regions[{i}].center",
                    f"{region.name!r} is unreachable from region {start.name!r}; "
                    "allowed: a place that people can walk to",
                )


def _circles(plan: FloorPlan, places: list[int]) -> Iterator[Fault]:
    """No place belongs to two activities, none to one that goes on behind a wall."""
    for at, i in enumerate(places):
        region, here = plan.regions[i], f"regions[{i}].radius"
        for j in places[:at]:
            other = plan.regions[j]
            room = math.dist(region.center, other.center) - other.radius
            if region.activity != other.activity and region.radius > room + 1e-9:
                yield Fault(
                    here,
                    f"{region.radius} m reaches into regions[{j}] {other.name!r}; "
                    "allowed: circles of different activities apart",
                )
        limit = _reach(plan, region)
        if region.radius > limit:
            yield Fault(
                here,
                f"{region.radius} m takes in people behind a wall; "
                f"allowed: at most {limit:.2f} m",
            )


def _reach(plan: FloorPlan, region: Region) -> float:
    """Radius [m] that ends where someone could stand behind the nearest wall."""
    center = np.array([region.center])
    gap = float(distance_to_segments(center, plan.wall_segments).min())
    return gap + plan.wall_thickness / 2 + CLEARANCE
