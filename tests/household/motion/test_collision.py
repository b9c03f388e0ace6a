"""Nobody comes to be inside an obstacle, whatever its step, radius and the walls."""

import math
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from household import household_v0
from household.home.geometry import crosses, distance_to_segments
from household.motion.collision import WEDGED, Obstacles, keep_out

A_LITTLE = 1e-9
"""Of rounding [m]."""

WALL = (2.2, 0.0, 2.2, 1.2)


def obstacles_at(segments, half_thickness):
    rows = np.array(segments, dtype=np.float64).reshape(-1, 4)
    one, other = rows[:, :2].T, rows[:, 2:].T
    boxes = np.array([*np.minimum(one, other), *np.maximum(one, other)])
    return Obstacles(rows, np.full(len(rows), half_thickness), boxes)


def moved(obstacles, radius, before, after):
    """Where a body comes to be that sets out from one point to another."""
    position = np.array([after], dtype=np.float64)
    keep_out(np.array([radius]), obstacles, np.array([before]), position)
    return position[0]


def depth(obstacles, radius, point):
    """How far a body overlaps the obstacles [m]; negative: clear of them."""
    gaps = distance_to_segments(np.array([point]), obstacles.segments)[0]
    return float((radius + obstacles.thickness - gaps).max())


@pytest.mark.parametrize("short", [0.0, 4.6e-10, 1e-9, 2e-9, -4.6e-10, 1e-12, 1e-6])
def test_a_body_whose_middle_comes_to_lie_on_a_wall_goes_back(short):
    """As a child did, whose step is its radius and half a wall."""
    obstacles = obstacles_at([WALL], 0.05)
    there = moved(obstacles, 0.25, (1.9, 1.1132), (2.2 - short, 1.113))
    assert depth(obstacles, 0.25, there) <= WEDGED
    assert there[0] == pytest.approx(1.9)


def test_a_body_is_not_pulled_through_a_gap_that_it_does_not_fit_into():
    """A step so long that it lands beyond; the middle of the gap is in no wall."""
    gap = [(2.0, 0.0, 2.0, 1.0), (2.0, 1.3, 2.0, 2.3)]
    obstacles = obstacles_at(gap, 0.05)
    for step in (0.6, 1.0, 3.0):
        there = moved(obstacles, 0.25, (1.7, 1.15), (1.7 + step, 1.15))
        assert there[0] < 2.0
        assert depth(obstacles, 0.25, there) <= WEDGED


def test_a_long_step_along_a_wall_leads_along_the_wall():
    obstacles = obstacles_at([(0.0, 0.0, 9.0, 0.0)], 0.05)
    there = moved(obstacles, 0.25, (1.0, 0.3), (4.0, -1.0))
    assert there[0] == pytest.approx(4.0)
    assert there[1] == pytest.approx(0.3)


class Walk(NamedTuple):
    """Steps of one body among obstacles.

    Attributes:
        segments: Rows of x1, y1, x2, y2 [m].
        thickness: Half of the walls' [m].
        radius: [m].
        first: Index of the segment that the body touches at first.
        along: Where, as a share of the segment.
        side: 1 or -1.
        steps: Length [m] and direction [rad] of each, from straight at the wall.
    """

    segments: list[tuple[float, float, float, float]]
    thickness: float
    radius: float
    first: int
    along: float
    side: int
    steps: list[tuple[float, float]]


coordinates = st.floats(-3.0, 3.0)
points = st.tuples(coordinates, coordinates)


def lengths_near(radius, thickness):
    """Steps that end in the middle of a wall, or nearly, and any others."""
    slips = (0.0, 1e-16, -1e-16, 5e-10, -5e-10, 2e-9, -2e-9, 1e-6)
    exact = [n * (radius + thickness) + slip for n in (1.0, 0.5, 2.0) for slip in slips]
    return st.one_of(st.sampled_from(exact), st.floats(1e-12, 4.0))


@st.composite
def walks(draw):
    radius = draw(st.one_of(st.sampled_from((0.15, 0.25)), st.floats(0.05, 1.0)))
    thickness = draw(st.sampled_from((0.0, 0.0005, 0.025, 0.05, 0.25)))
    grid = st.builds(lambda i: i / 4, st.integers(-12, 12))
    corners = st.one_of(points, st.tuples(grid, grid))
    pairs = st.tuples(corners, corners).filter(lambda ends: math.dist(*ends) > 0.05)
    segments = draw(
        st.lists(pairs.map(lambda ends: (*ends[0], *ends[1])), min_size=1, max_size=6)
    )
    turns = st.one_of(st.just(0.0), st.floats(-4.0, 4.0))
    steps = st.tuples(lengths_near(radius, thickness), turns)
    return Walk(
        segments,
        thickness,
        radius,
        draw(st.integers(0, len(segments) - 1)),
        draw(st.floats(0.0, 1.0)),
        draw(st.sampled_from((1, -1))),
        draw(st.lists(steps, min_size=1, max_size=12)),
    )


def check_walk(walk):
    """Follows a walk that begins flush with a wall; returns whether it could begin."""
    obstacles = obstacles_at(walk.segments, walk.thickness)
    x1, y1, x2, y2 = walk.segments[walk.first]
    length = math.hypot(x2 - x1, y2 - y1)
    normal = np.array([y1 - y2, x2 - x1]) / length * walk.side
    foot = np.array([x1, y1]) + walk.along * np.array([x2 - x1, y2 - y1])
    here = foot + normal * (walk.radius + walk.thickness)
    if depth(obstacles, walk.radius, here) > A_LITTLE:
        return False
    for step, turn in walk.steps:
        cos, sin = math.cos(turn), math.sin(turn)
        ahead = -np.array(
            [normal[0] * cos - normal[1] * sin, normal[0] * sin + normal[1] * cos]
        )
        there = moved(obstacles, walk.radius, here, here + step * ahead)
        assert np.isfinite(there).all()
        assert depth(obstacles, walk.radius, there) <= WEDGED + A_LITTLE
        if step <= walk.radius:  # Longer ones may lead round the end of a wall.
            assert not any(crosses(*here, *there, s) for s in obstacles.segments)
        here = there
    return True


@settings(max_examples=150, deadline=None)
@given(walks())
def test_no_step_radius_and_thickness_bring_a_body_into_a_wall(walk):
    check_walk(walk)


@pytest.mark.slow
@settings(max_examples=20_000, deadline=None)
@given(walks())
def test_no_step_radius_and_thickness_bring_a_body_into_a_wall_at_length(walk):
    check_walk(walk)


@settings(max_examples=100, deadline=None)
@given(
    radius=st.floats(0.05, 1.0),
    thickness=st.sampled_from((0.0005, 0.025, 0.05, 0.25)),
    turn=st.floats(-4.0, 4.0),
    shift=points,
    steps=st.lists(st.tuples(st.floats(0.01, 4.0), st.floats(-4.0, 4.0)), max_size=30),
)
def test_nobody_leaves_a_closed_room_however_it_is_turned_and_shifted(
    radius, thickness, turn, shift, steps
):
    cos, sin = math.cos(turn), math.sin(turn)
    corners = np.array([(-2, -1.5), (2, -1.5), (2, 1.5), (-2, 1.5)])
    turned = corners @ np.array([[cos, sin], [-sin, cos]]) + np.array(shift)
    sides = [(*turned[i - 1], *turned[i]) for i in range(4)]
    obstacles = obstacles_at(sides, thickness)
    here = np.array(shift)
    for step, angle in steps:
        aim = here + step * np.array([math.cos(angle), math.sin(angle)])
        here = moved(obstacles, radius, here, aim)
        local = (here - np.array(shift)) @ np.array([[cos, -sin], [sin, cos]])
        clear = radius + thickness - WEDGED - A_LITTLE
        assert (np.abs(local) <= np.array([2.0, 1.5]) - clear).all()


def studio(people, position):
    """Many people in a studio, as two scenarios had them that were found by chance."""
    return {
        "name": "h",
        "home": "studio",
        "max_cycles": 1500,
        "behaviors": ["sleep", "play", "bark", "follow", "vacuum", "retreat"],
        "people": [{"name": f"p{i}", "persona": p} for i, p in enumerate(people)],
        "robots": [{"position": list(position)}],
    }


SIX = studio(
    ["moody", "strict", "silent", "child", "child", "paper_actor"], (2.75, 3.25)
)
TWELVE = studio(
    [
        *("paper_actor", "strict", "easygoing", "elder", "silent", "elder"),
        *("child", "child", "light_sleeper", "punisher", "easygoing", "punisher"),
    ],
    (5.85, 3.15),
)


@pytest.mark.parametrize(
    ("household", "seed", "decisions"),
    [(SIX, 7, 360), (SIX, 175, 50), (TWELVE, 9919, 60), (TWELVE, 93, 50)],
)
def test_no_child_walks_into_the_walls_of_the_studio(
    household, seed, decisions, deepest
):
    """With these seeds a child's step ended in the middle of a wall: with the first of
    each when this was found, with the second when it was mended."""
    env = household_v0.parallel_env(**household)
    env.reset(seed=seed)
    rng, n = np.random.default_rng(seed), len(household["people"])
    for _ in range(decisions):
        env.step({"robot_0": int(rng.integers(len(env.behaviors)))})
        people = env.simulation.crowd.position[:n]
        assert deepest(env.scenario.plan, people, 0.25) <= 0.01
