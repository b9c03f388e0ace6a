"""The engine's bodies: obstacles, and who pushes whom."""

import math

import numpy as np
import pytest

from household.home.floorplan import Furniture
from household.motion.collision import keep_out
from household.motion.physics import Physics
from household.simulation.simulation import PERSON_RADIUS as PERSON
from household.simulation.simulation import ROBOT_RADIUS as ROBOT

OVERLAP = 0.01  # Nobody overlaps a wall by more than this [m].


@pytest.mark.parametrize("pace", [1.2, 3.0])
def test_nobody_passes_a_wall_however_it_runs_against_it(room, pace, people, deepest):
    box = Furniture(name="box", center=(5.5, 2.5), size=(1.0, 1.0), angle=30.0)
    plan = room(walls=((4.0, 0.0, 4.0, 5.0),), furniture=(box,))
    rng = np.random.default_rng(1)
    position = np.array([[1.0, 1.0], [2.5, 4.0], [6.0, 0.6], [7.0, 4.2]])
    west = position[:, 0] < 4.0
    physics = Physics(plan, *people(4))
    for _ in range(60):
        angle = rng.uniform(0.0, 2 * math.pi, 4)
        velocity = pace * np.column_stack([np.cos(angle), np.sin(angle)])
        for _ in range(10):
            physics.velocity[:] = velocity
            position = physics.advance(position, 0.1, 2)
            assert deepest(plan, position, PERSON) <= OVERLAP
    np.testing.assert_array_equal(position[:, 0] < 4.0, west)


def test_a_crowd_that_presses_into_a_corner_presses_nobody_into_the_wall(
    room, people, deepest
):
    plan = room()
    start = [(0.5 + 0.6 * i, 0.5 + 0.6 * j) for i in range(4) for j in range(3)]
    physics = Physics(plan, *people(12))
    position = np.array(start)
    for _ in range(50):
        physics.velocity[:] = -1.2
        position = physics.advance(position, 0.1, 2)
        assert deepest(plan, position, PERSON) <= OVERLAP


def test_a_gap_too_narrow_for_a_body_does_not_let_it_in_however_it_is_pressed(
    room, people, deepest
):
    """Between the wall and a chair's corner; the engine would squeeze it in."""
    chair = Furniture(name="chair", center=(7.35, 1.0), size=(0.8, 0.8), angle=45.0)
    plan = room(furniture=(chair,))
    physics = Physics(plan, *people(3))
    position = np.array([[7.69, 1.7], [7.69, 2.25], [7.2, 2.2]])
    for _ in range(40):
        physics.velocity[:] = [[0.0, -1.2], [0.0, -1.2], [0.7, -0.9]]
        position = physics.advance(position, 0.1, 2)
        assert deepest(plan, position, PERSON) <= OVERLAP


def test_who_is_pushed_out_of_a_wall_is_not_pushed_into_a_cupboard(room):
    """Its middle slipped between a wall (x = 8) and a cupboard (from x = 8.1 on).

    Out of the wall means to x = 8.2, past the cupboard's side: it goes back instead.
    """
    cupboard = Furniture(name="cupboard", center=(8.4, 0.65), size=(0.6, 1.1))
    plan = room(size=(12.0, 5.0), walls=((8.0, 0.0, 8.0, 2.4),), furniture=(cupboard,))
    physics = Physics(plan, np.array([ROBOT]), np.array([2.0]))
    start = np.array([[8.2, 1.35]])
    # As the engine left it once, when a crowd pressed a robot into that corner.
    position = np.array([[8.09, 1.19]])
    keep_out(np.array([ROBOT]), physics.obstacles, start, position)
    np.testing.assert_array_equal(position, start)


def test_bodies_push_each_other_and_the_heavy_one_yields_less(room):
    physics = Physics(room(), np.array([PERSON, ROBOT]), np.array([70.0, 2.0]))
    position = np.array([[2.0, 2.5], [3.0, 2.5]])
    for _ in range(10):
        physics.velocity[:] = [[1.2, 0.0], [0.0, 0.0]]
        position = physics.advance(position, 0.1, 2)
    assert position[1, 0] > 3.5
    # Bodies are soft, but not so soft that one walks through the other.
    assert position[1, 0] - position[0, 0] > PERSON
    position = np.array([[2.0, 2.5], [3.0, 2.5]])
    for _ in range(10):
        physics.velocity[:] = [[0.0, 0.0], [-0.5, 0.0]]
        position = physics.advance(position, 0.1, 2)
    assert abs(position[0, 0] - 2.0) < 0.2


def test_who_stands_alone_stays_where_it_is(room, people):
    physics = Physics(room(), *people(1))
    start = np.array([[2.0, 2.5]])
    assert physics.advance(start, 0.1, 50).tolist() == [[2.0, 2.5]]


def test_a_free_body_moves_as_fast_as_it_is_told(room, people):
    physics = Physics(room(), *people(1))
    start = np.array([[2.0, 2.5]])
    physics.velocity[:] = 1.2, -0.5
    moved = physics.advance(start, 0.1, 10)
    np.testing.assert_allclose(moved, [[3.2, 2.0]], atol=1e-9)


def test_bodies_that_moved_without_the_engine_are_where_they_are_for_it(room, people):
    """Two that were far apart for the engine push each other where they stand now."""
    physics = Physics(room(), *people(2))
    near = np.array([[5.45, 2.5], [6.0, 2.5]])
    physics.velocity[:] = [[1.2, 0.0], [0.0, 0.0]]
    moved = physics.advance(near, 0.1, 5)
    assert moved[0, 0] > 5.45
    assert moved[1, 0] > 6.1
    assert moved[1, 0] - moved[0, 0] > PERSON


def test_where_a_crowd_is_pushed_depends_on_nothing_that_happened_before(room):
    """Bit for bit as in an engine that has seen nothing yet, whatever this one saw."""
    box = Furniture(name="box", center=(5.5, 2.5), size=(1.0, 1.0), angle=30.0)
    plan = room(walls=((4.0, 0.0, 4.0, 3.0),), furniture=(box,))
    for seed in range(6):
        rng = np.random.default_rng(seed)
        radius = rng.choice([PERSON, ROBOT], 20)
        mass = np.where(radius == PERSON, 70.0, 2.0)
        lived = Physics(plan, radius, mass)
        position, pushed = rng.uniform((0.5, 0.5), (7.5, 4.5), (20, 2)), 0
        for _ in range(30):
            velocity = rng.uniform(0.0, 1.2) * (rng.uniform(1.0, 4.0, 2) - position)
            fresh = Physics(plan, radius, mass)
            lived.velocity[:] = fresh.velocity[:] = velocity
            moved = lived.advance(position, 0.1, 2)
            assert moved.tobytes() == fresh.advance(position, 0.1, 2).tobytes()
            pushed += not np.allclose(moved, position + 0.2 * velocity)
            position = moved
        assert pushed > 20
