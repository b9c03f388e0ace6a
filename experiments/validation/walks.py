"""Tests of walking, after those of the RiMEA guideline, each for a hall in any frame.

The halls are like those of the guideline, with fewer people: a household has 64 at
most.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from experiments.analysis.statistics import FloatArray
from experiments.validation.diary import live
from experiments.validation.halls import (
    Frame,
    Point,
    Walk,
    building,
    lattice,
    walk,
)
from household.config.toml import shipped
from household.home.floorplan import FloorPlan, Region
from household.home.geometry import crosses, distance_to_segments
from household.scenario.persona import Persona, load_persona
from household.scenario.population import Population, individual
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario, ScriptStep
from household.simulation.simulation import PERSON_RADIUS

SPEED = 1.33
"""Of walkers whose speed is not what is tested [m/s]."""

NEVER = 99.0
"""What a test gives where somebody went through a wall or did not get there."""


def corridor_time(frame: Frame) -> float:
    """Test 1: how long somebody takes for 40 m of a corridor 2 m wide [s]."""
    hall = building([(0, 0), (44, 0), (44, 2), (0, 2)])
    walked = walk(frame, hall, [((1.0, 1.0), (42.5, 1.0))], SPEED)
    return float(walked.passed(0, 41.0)[0])


def reaction_error(frame: Frame) -> float:
    """Test 5: how far 10 people are off the times at which they are to set out [s]."""
    # Who is nearest to the door leaves first, so that nobody is pushed aside before.
    places = sorted(lattice((1.0, 0.8), 5, 2, 1.3), reverse=True)
    calm = Persona(name="calm", praise=0.0, sanction=0.0)
    times = np.linspace(10.0, 100.0, len(places))
    goal = Region(
        name="exit", activity="entering", center=(9.0, 2.5), facing=(10.0, 2.5)
    )
    spots = [
        Region(
            name=f"spot {i}", activity="working", center=c, radius=0.4, facing=(0, 0)
        )
        for i, c in enumerate(places)
    ]
    door = [((8.0, 0.0), (8.0, 2.0)), ((8.0, 3.0), (8.0, 5.0))]
    hall = building([(0, 0), (10, 0), (10, 5), (0, 5)], door, [goal, *spots])
    scenario = Scenario(
        name="reaction times",
        home=frame.plan(hall),
        max_cycles=110,
        behaviors=("sleep", "play"),
        people=tuple(
            PersonSpec(
                name=f"person_{i}",
                persona=calm,
                start=frame.point(place),
                script=(
                    ScriptStep(place=f"spot {i}", until=float(time)),
                    ScriptStep(place="exit", until=200.0),
                ),
            )
            for i, (place, time) in enumerate(zip(places, times, strict=True))
        ),
        robots=(RobotSpec(position=frame.point((7.0, 4.3))),),
    )
    diary = live(scenario, (1.0, 0.0), seed=0)
    began = [
        diary.time[:-1][walks].min() if (walks := diary.moved(i)).any() else NEVER
        for i in range(len(places))
    ]
    return float(np.abs(np.array(began) - times).max())


def corner_overlap(frame: Frame) -> float:
    """Test 6: how far 20 people who go round a corner get into walls [m]."""
    hall = building([(0, 0), (12, 0), (12, 12), (10, 12), (10, 2), (0, 2)])
    ways = list(zip(lattice((0.5, 0.4), 7, 3), lattice((10.4, 7.4), 3, 7), strict=True))
    walked = walk(frame, hall, ways[:20], SPEED)
    return overlap(hall, walked) if not _missing(walked.passed(1, 6.0)) else NEVER


def overlap(hall: FloorPlan, walked: Walk) -> float:
    """Returns how far bodies got into walls at most [m]; `NEVER` if through one."""
    walls = hall.wall_segments
    for before, after in pairwise(walked.track):
        for (ax, ay), (bx, by) in zip(before, after, strict=True):
            if any(crosses(ax, ay, bx, by, wall) for wall in walls):
                return NEVER
    gap = distance_to_segments(walked.track.reshape(-1, 2), walls).min()
    return float(max(0.0, PERSON_RADIUS + hall.wall_thickness / 2 - gap))


def speed_error(frame: Frame) -> float:
    """Test 7: how far 50 different people are off their own walking speeds, a share."""
    names, population = tuple(shipped("persona")), Population()
    speeds = [
        individual(
            load_persona(names[i % len(names)]), population, 1.0, i
        ).walking_speed
        for i in range(50)
    ]
    hall = building([(0, 0), (44, 0), (44, 2), (0, 2)])
    taken = [
        walk(frame, hall, [((1.0, 1.0), (42.5, 1.0))], speed).passed(0, 41.0)[0]
        for speed in speeds
    ]
    return float(np.abs(40.0 / np.array(taken) / speeds - 1.0).max())


def astray(frame: Frame) -> float:
    """Test 10: how many of 23 people in 12 cabins do not get to their own exit."""
    inner: list[tuple[Point, Point]] = []
    ways: list[tuple[Point, Point]] = []
    main, second = lattice((-5.4, 0.4), 6, 3), lattice((19.4, 0.4), 6, 3)
    for cabin in range(12):
        x, upper = 3.0 * (cabin % 6), cabin >= 6
        edge, back = (2.0, 5.0) if upper else (0.0, -3.0)
        inner += [((x, edge), (x + 1.05, edge)), ((x + 1.95, edge), (x + 3.0, edge))]
        inner += [((x, edge), (x, back)), ((x + 3.0, edge), (x + 3.0, back))]
        goals = main if cabin % 6 < 4 else second
        starts = [(x + 1.0, (edge + back) / 2), (x + 2.0, (edge + back) / 2)]
        ways += [(start, goals.pop()) for start in starts]
    hall = building([(-6, -3), (24, -3), (24, 5), (-6, 5)], [*inner, *_ends()])
    walked = walk(frame, hall, ways[:23], SPEED)
    where, exits = walked.track[-1, :, 0], walked.goals[:, 0]
    there = np.where(exits < 0.0, where < -0.5, where > 18.5)
    return float((~there).sum())


def _ends() -> list[tuple[Point, Point]]:
    """Walls along the corridor, before and behind its cabins."""
    return [((x, y), (x + 6.0, y)) for x in (-6.0, 18.0) for y in (0.0, 2.0)]


def second_jam(frame: Frame) -> float:
    """Test 12: the crowd before the second of two doors by that before the first.

    The first lets no more people through than the second.
    """
    doors = [
        ((x, y1), (x, y2)) for x in (8.0, 16.0) for y1, y2 in ((0.0, 3.5), (4.5, 8.0))
    ]
    hall = building([(0, 0), (28, 0), (28, 8), (0, 8)], doors)
    ways = zip(
        lattice((0.6, 1.0), 6, 8, 0.8), lattice((21.0, 1.0), 6, 8, 0.8), strict=True
    )
    walked = walk(frame, hall, list(ways), SPEED, most=240.0)
    if _missing(walked.passed(0, 17.0)):
        return NEVER
    first, second = (_crowd_before(walked, (x, 4.0)) for x in (8.0, 16.0))
    return second / first


def _crowd_before(walked: Walk, door: Point) -> float:
    """The most people at once who are within 2 m of a door and not yet through it."""
    way = np.array(door) - walked.track
    near = (np.linalg.norm(way, axis=2) <= 2.0) & (way[:, :, 0] > 0.0)
    return float(near.sum(axis=1).max())


def detour(frame: Frame) -> float:
    """Test 14: the way taken through a wall by the shortest one.

    With two openings, and with the farther one alone; the worse of the two.
    """
    parts = [(0.0, 4.5), (5.5, 8.5), (9.5, 10.0)]
    wall = [((6.0, low), (6.0, high)) for low, high in parts]
    outline, way = [(0, 0), (12, 0), (12, 10), (0, 10)], ((2.0, 5.0), (10.0, 5.0))
    opened = building(outline, wall)
    closed = building(outline, [*wall, ((6.0, 4.5), (6.0, 5.5))])
    # Round the corner at (6, 8.5), as near as a body and half a wall let one.
    shortest = (8.0, 2 * math.hypot(4.0, 3.5 + PERSON_RADIUS + 0.05))
    lengths = [
        _length(walk(frame, hall, [way], SPEED).track[:, 0])
        for hall in (opened, closed)
    ]
    return max(is_ / least for is_, least in zip(lengths, shortest, strict=True))


def _length(track: FloatArray) -> float:
    return float(np.linalg.norm(np.diff(track, axis=0), axis=1).sum())


def corner_time(frame: Frame) -> float:
    """Test 15: how long 40 people take round a corner, on a scale.

    0: as in a straight corridor that is as long as the inner wall, 1: as in one that is
    as long as the outer wall.
    """
    crowd = lattice((0.6, 0.8), 10, 4, 0.7)
    bent = building([(0, 0), (14, 0), (14, 28), (10, 28), (10, 4), (0, 4)])
    goals = lattice((10.6, 19.0), 4, 10, 0.7)
    # Who is ahead goes farthest, so that nobody has to pass anybody who has arrived.
    ordered = sorted(crowd, key=lambda start: -start[0])
    far = sorted(goals, key=lambda goal: -goal[1])
    turned = walk(frame, bent, list(zip(ordered, far, strict=True)), SPEED)
    times = [_last(turned.passed(1, 14.0))]
    for length in (20.0, 28.0):
        straight = building([(0, 0), (44, 0), (44, 4), (0, 4)])
        ends = sorted(lattice((length + 5.0, 0.8), 10, 4, 0.7), key=lambda end: -end[0])
        ahead = walk(frame, straight, list(zip(ordered, ends, strict=True)), SPEED)
        times.append(_last(ahead.passed(0, length)))
    bent_time, inner, outer = times
    return (bent_time - inner) / (outer - inner)


def _last(times: FloatArray) -> float:
    return NEVER if _missing(times) else float(times.max())


def _missing(times: FloatArray) -> bool:
    return bool(np.isnan(times).any())
