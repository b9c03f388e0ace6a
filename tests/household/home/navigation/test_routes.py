"""Paths through homes: short, clear of all obstacles, the same whoever asks."""

import itertools
import math

import numpy as np
import pytest

from household.config.toml import shipped
from household.home.floorplan import Door, Furniture, load_floorplan
from household.home.navigation.path import Waypoints, find_path
from household.home.navigation.routes import Routes, routes_of
from household.home.navigation.search import (
    DIAGONAL,
    HERE,
    STRAIGHT,
    beyond,
    steps_to,
)
from household.simulation.simulation import PERSON_RADIUS as PERSON

HOMES = tuple(shipped("home"))


@pytest.mark.parametrize("home", HOMES)
def test_a_path_that_is_not_kept_is_as_short_as_one_that_is(home):
    routes = Routes(load_floorplan(home))
    cache = routes.navigation.cache

    def length_of(goal, start, keep):
        steps = steps_to(cache, goal, start, keep)
        total, here = 0, start
        while steps[here] != HERE:
            total += STRAIGHT if steps[here] % 2 else DIAGONAL
            here = beyond(here, steps[here], cache.height)
        return total

    rng = np.random.default_rng(0)
    indoors = np.flatnonzero(routes.free & (routes.parts != routes.parts[0, 0]))
    label = routes.parts.ravel()
    for goal, start in rng.choice(indoors, size=(100, 2)).tolist():
        if goal != start and label[goal] == label[start]:
            assert length_of(goal, start, False) == length_of(goal, start, True)


def length(start, path):
    return sum(math.dist(a, b) for a, b in itertools.pairwise([start, *path]))


def test_the_path_round_a_box_is_the_taut_string_within_a_few_percent(room):
    """From 2 m before the box to 2 m behind it, its corners cleared by 0.3 m.

    The string runs tangentially to the circle round the first corner, 2.236 m away:
    sqrt(5 - 0.09) = 2.216 m; round it by 34.27 degrees, 0.179 m; 2 m along the side;
    and the same again: 6.791 m.
    """
    box = Furniture(name="box", center=(4.0, 2.5), size=(2.0, 2.0))
    routes = routes_of(room(size=(8.0, 6.0), furniture=(box,)))
    start, goal = (1.0, 2.5), (7.0, 2.5)
    path = routes.plan(start, goal)
    # A grid cell of 0.1 m may round the corner a little on either side.
    assert 0.98 * 6.791 < length(start, path) < 1.04 * 6.791


def test_the_path_through_the_nearer_of_two_doors_is_taken(room):
    """Through (4, 1): twice hypot(3, 1.5), 6.708 m; through the other, 7.81 m."""
    walls = ((4.0, 0.0, 4.0, 0.5), (4.0, 1.5, 4.0, 4.0), (4.0, 4.9, 4.0, 5.0))
    start, goal = (1.0, 2.5), (7.0, 2.5)
    path = routes_of(room(walls=walls)).plan(start, goal)
    assert 0.98 * 6.708 < length(start, path) < 1.05 * 6.708


def test_a_free_line_is_walked_straight(room):
    path = routes_of(room()).plan((1.0, 1.0), (7.0, 4.0))
    np.testing.assert_allclose(path, [(7.0, 4.0)])


def test_no_path_leads_through_a_wall_without_a_door(room):
    routes = routes_of(room(walls=((4.0, 0.0, 4.0, 5.0),)))
    assert len(routes.plan((1.0, 1.0), (7.0, 1.0))) == 0


@pytest.mark.parametrize(("is_open", "leads"), [(True, True), (False, False)])
def test_a_path_leads_through_an_open_door_and_not_through_a_closed_one(
    room, is_open, leads
):
    plan = room(
        walls=((4.0, 0.0, 4.0, 2.0), (4.0, 3.0, 4.0, 5.0)),
        doors=(Door(start=(4.0, 2.0), end=(4.0, 3.0), open=is_open),),
    )
    path = routes_of(plan).plan((1.0, 1.0), (7.0, 1.0))
    assert (len(path) > 0) == leads


def test_a_path_may_turn_as_often_as_it_must(room, crowd_in):
    """Round the ends of eleven walls that stand out from either side in turn."""
    ends = [(0.0, 4.0) if k % 2 else (1.0, 5.0) for k in range(11)]
    walls = tuple((x, low, x, high) for x, (low, high) in enumerate(ends, start=1))
    plan = room(size=(12.0, 5.0), walls=walls)
    start, goal = (0.5, 2.5), (11.5, 2.5)
    path = routes_of(plan).plan(start, goal)
    assert len(path) > len(walls)
    # Whose goal moves a little walks on as before, and only ends elsewhere.
    # A view of a table, as in a household: for others it would be compiled once more.
    bent, left = np.zeros((len(path), 3))[:, :2], len(path) - 3
    bent[:] = path
    walked = Waypoints(bent, 3, len(path))
    count = find_path(routes_of(plan).navigation, path[2], (11.5, 2.6), walked, False)
    assert count == left
    np.testing.assert_array_equal(bent[:left], [*path[3:-1], (11.5, 2.6)])
    crowd = crowd_in(plan, [start, (0.5, 4.0)], speed=1.2)
    crowd.send(0, goal)
    seconds = 0
    while crowd.walks(0):
        crowd.advance(5)
        seconds += 1
        assert seconds < 2 * length(start, path) / 1.2
    assert math.dist(crowd.position[0], goal) < 0.1


def test_no_path_depends_on_what_else_was_asked_before():
    plan = load_floorplan("family_apartment")
    spots = [region.center for region in plan.regions]
    asked = list(itertools.permutations(spots, 2))
    forth, back = Routes(plan), Routes(plan)
    paths = [forth.plan(*pair) for pair in asked]
    assert [back.plan(*pair) for pair in reversed(asked)] == paths[::-1]
    assert [forth.plan(*pair) for pair in asked] == paths


@pytest.mark.parametrize("home", HOMES)
def test_paths_through_shipped_homes_keep_a_body_clear_of_all_obstacles(home, deepest):
    plan = load_floorplan(home)
    routes = routes_of(plan)
    rng = np.random.default_rng(2)
    centers = [np.array(region.center) for region in plan.regions]
    free = np.argwhere(
        routes.free & (routes.parts == routes.parts[routes.cell(centers[0])])
    )
    corner = plan.lower - 0.6
    starts = [
        corner + (cell + rng.random(2)) * 0.1 for cell in rng.permutation(free)[:6]
    ]
    for start, goal in itertools.product([*centers, *starts], centers):
        path = routes.plan(tuple(start), tuple(goal))
        assert len(path) > 0
        assert math.dist(path[-1], goal) < 0.2
        points = [start, *map(np.array, path)]
        line = np.vstack(
            [
                a + np.linspace(0, 1, 60)[:, None] * (b - a)
                for a, b in itertools.pairwise(points)
            ]
        )
        # The rim of a cell is up to 0.07 m from its middle, which is clear by 0.3 m.
        assert deepest(plan, line, PERSON) <= 0.02
