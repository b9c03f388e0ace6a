"""Bodies in a home: what is solid, who pushes whom, and the ways round it."""

import itertools
import math

import numpy as np
import pytest

from household import household_v0
from household.arrays import NOBODY
from household.crowd import Build, Crowd
from household.home.floorplan import Door, Furniture, load_floorplan
from household.home.routes import (
    Routes,
    distance_to_box,
    distance_to_segments,
    routes_of,
)
from household.home.shortest import (
    DIAGONAL,
    HERE,
    STRAIGHT,
    beyond,
    onward_to,
)
from household.home.straight import find_way
from household.records import shipped
from household.solid import keep_out
from household.steering import PUSHY
from household.world import World

HOMES = tuple(shipped("home/homes"))
PERSON, ROBOT = 0.25, 0.15
OVERLAP = 0.01  # Nobody overlaps a wall by more than this [m].


def people(n):
    return np.full(n, PERSON), np.full(n, 70.0)


def walkers(n, speed=1.2):
    return Build(*people(n), np.full(n, speed))


def deepest(plan, position, radius):
    """How far bodies overlap walls and furniture [m]; negative: clear of all."""
    gap = distance_to_segments(position, plan.wall_segments).min(axis=1)
    depth = plan.wall_thickness / 2 + radius - gap
    for box in plan.furniture:
        away = distance_to_box(position, box.center, box.size, box.angle)
        depth = np.maximum(depth, radius - away)
    return float(depth.max())


@pytest.fixture
def crowd_in():
    def make(plan, position, speed=1.2):
        n = len(position)
        crowd = Crowd(plan, walkers(n, speed), 0.2, 0.1)
        crowd.place(np.array(position, dtype=float), np.zeros(n))
        return crowd

    return make


def walk(crowd, goals, most):
    """Sends everybody on its way; returns when each arrived [s] and all positions."""
    for i, goal in enumerate(goals):
        assert crowd.send(i, goal, 0.0)
    arrived, track = {}, [crowd.position.copy()]
    for moment in range(round(most / 0.2)):
        crowd.advance()
        track.append(crowd.position.copy())
        for i in range(len(goals)):
            if i not in arrived and not crowd.walks(i):
                arrived[i] = 0.2 * (moment + 1)
    return arrived, np.array(track)


@pytest.mark.parametrize("pace", [1.2, 3.0])
def test_nobody_passes_a_wall_however_it_runs_against_it(room, pace):
    box = Furniture(name="box", center=(5.5, 2.5), size=(1.0, 1.0), angle=30.0)
    plan = room(walls=((4.0, 0.0, 4.0, 5.0),), furniture=(box,))
    rng = np.random.default_rng(1)
    position = np.array([[1.0, 1.0], [2.5, 4.0], [6.0, 0.6], [7.0, 4.2]])
    west = position[:, 0] < 4.0
    world = World(plan, *people(4))
    world.place(position)
    for _ in range(60):
        angle = rng.uniform(0.0, 2 * math.pi, 4)
        velocity = pace * np.column_stack([np.cos(angle), np.sin(angle)])
        for _ in range(10):
            world.velocity[:] = velocity
            position = world.advance(position, 0.1, 2)
            assert deepest(plan, position, PERSON) <= OVERLAP
    np.testing.assert_array_equal(position[:, 0] < 4.0, west)


def test_a_crowd_that_presses_into_a_corner_presses_nobody_into_the_wall(room):
    plan = room()
    start = [(0.5 + 0.6 * i, 0.5 + 0.6 * j) for i in range(4) for j in range(3)]
    world = World(plan, *people(12))
    position = np.array(start)
    world.place(position)
    for _ in range(50):
        world.velocity[:] = -1.2
        position = world.advance(position, 0.1, 2)
        assert deepest(plan, position, PERSON) <= OVERLAP


def test_a_gap_too_narrow_for_a_body_does_not_let_it_in_however_it_is_pressed(room):
    """Between the wall and a chair's corner; the engine would squeeze it in."""
    chair = Furniture(name="chair", center=(7.35, 1.0), size=(0.8, 0.8), angle=45.0)
    plan = room(furniture=(chair,))
    world = World(plan, *people(3))
    position = np.array([[7.69, 1.7], [7.69, 2.25], [7.2, 2.2]])
    world.place(position)
    for _ in range(40):
        world.velocity[:] = [[0.0, -1.2], [0.0, -1.2], [0.7, -0.9]]
        position = world.advance(position, 0.1, 2)
        assert deepest(plan, position, PERSON) <= OVERLAP


def test_who_is_pushed_out_of_a_wall_is_not_pushed_into_a_cupboard(room):
    """Its middle slipped between a wall (x = 8) and a cupboard (from x = 8.1 on).

    Out of the wall means to x = 8.2, past the cupboard's side: it goes back instead.
    """
    cupboard = Furniture(name="cupboard", center=(8.4, 0.65), size=(0.6, 1.1))
    plan = room(size=(12.0, 5.0), walls=((8.0, 0.0, 8.0, 2.4),), furniture=(cupboard,))
    world = World(plan, np.array([ROBOT]), np.array([2.0]))
    start = np.array([[8.2, 1.35]])
    # As the engine left it once, when a crowd pressed a robot into that corner.
    position = np.array([[8.09, 1.19]])
    keep_out(
        np.array([ROBOT]), world.solid, world.thickness, world.boxes, start, position
    )
    np.testing.assert_array_equal(position, start)


def test_bodies_push_each_other_and_the_heavy_one_yields_less(room):
    world = World(room(), np.array([PERSON, ROBOT]), np.array([70.0, 2.0]))
    position = np.array([[2.0, 2.5], [3.0, 2.5]])
    world.place(position)
    for _ in range(10):
        world.velocity[:] = [[1.2, 0.0], [0.0, 0.0]]
        position = world.advance(position, 0.1, 2)
    assert position[1, 0] > 3.5
    # Bodies are soft, but not so soft that one walks through the other.
    assert position[1, 0] - position[0, 0] > PERSON
    position = np.array([[2.0, 2.5], [3.0, 2.5]])
    world.place(position)
    for _ in range(10):
        world.velocity[:] = [[0.0, 0.0], [-0.5, 0.0]]
        position = world.advance(position, 0.1, 2)
    assert abs(position[0, 0] - 2.0) < 0.2


def test_who_stands_alone_stays_where_it_is(room):
    world = World(room(), *people(1))
    start = np.array([[2.0, 2.5]])
    world.place(start)
    assert world.advance(start, 0.1, 50).tolist() == [[2.0, 2.5]]


def test_a_free_body_moves_as_fast_as_it_is_told(room):
    world = World(room(), *people(1))
    start = np.array([[2.0, 2.5]])
    world.place(start)
    world.velocity[:] = 1.2, -0.5
    moved = world.advance(start, 0.1, 10)
    np.testing.assert_allclose(moved, [[3.2, 2.0]], atol=1e-9)


def test_bodies_that_moved_without_the_engine_are_where_they_are_for_it(room):
    """Two that were far apart for the engine push each other where they stand now."""
    world = World(room(), *people(2))
    world.place(np.array([[2.0, 2.5], [6.0, 2.5]]))
    near = np.array([[5.45, 2.5], [6.0, 2.5]])
    world.velocity[:] = [[1.2, 0.0], [0.0, 0.0]]
    moved = world.advance(near, 0.1, 5)
    assert moved[0, 0] > 5.45
    assert moved[1, 0] > 6.1
    assert moved[1, 0] - moved[0, 0] > PERSON


class Asked:
    """Counts how often the engine is asked."""

    def __init__(self, crowd, monkeypatch):
        self.times, step = 0, crowd.space.step

        def counted(tick):
            self.times += 1
            step(tick)

        monkeypatch.setattr(crowd.space, "step", counted)


CLOSE = [(4.4, 2.9), (3.6, 2.9), (3.6, 2.1), (4.4, 2.1)]
"""Round (4, 2.5)."""


@pytest.mark.parametrize(
    ("start", "goal", "asked"),
    [
        ([(1.0, 2.5)], (7.0, 2.5), False),
        # Past somebody who stands aside, and past a wall with a hand's breadth between.
        ([(1.0, 2.5), (4.0, 3.2)], (7.0, 2.5), False),
        ([(1.0, 0.4)], (7.0, 0.4), False),
        # Somebody stands in the way, or on the goal.
        ([(1.0, 2.5), (4.0, 2.5)], (7.0, 2.5), False),
        ([(1.0, 2.5), (7.0, 2.5)], (7.0, 2.5), False),
        # Four stand round it, with a hand's breadth between them.
        ([(4.0, 2.5), *CLOSE], (7.0, 2.5), True),
    ],
    ids=[
        "alone",
        "past somebody",
        "along a wall",
        "round somebody",
        "onto somebody",
        "out of a ring",
    ],
)
def test_the_engine_is_asked_only_where_bodies_may_touch(
    room, crowd_in, monkeypatch, start, goal, asked
):
    crowd = crowd_in(room(), start)
    engine = Asked(crowd, monkeypatch)
    assert crowd.send(0, goal, 0.0)
    for _ in range(60):
        crowd.advance()
    taken = any(tuple(body) == goal for body in start)
    assert math.dist(crowd.position[0], goal) < (0.6 if taken else 0.1)
    assert (engine.times > 0) == asked


def test_who_walks_does_not_move_who_stands_but_goes_round(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    assert crowd.send(0, (7.0, 2.5), 0.0)
    aside = 0.0
    while crowd.walks(0):
        crowd.advance()
        aside = max(aside, abs(crowd.position[0, 1] - 2.5))
        assert math.dist(*crowd.position) >= 0.5
    assert crowd.position[1].tolist() == [4.0, 2.5]
    assert 0.5 < aside < 0.8


def test_two_who_meet_pass_without_touching_and_without_the_engine(
    room, crowd_in, monkeypatch
):
    crowd = crowd_in(room(), [(1.0, 2.5), (7.0, 2.5)])
    engine = Asked(crowd, monkeypatch)
    arrived, track = walk(crowd, [(7.0, 2.5), (1.0, 2.5)], 12.0)
    assert sorted(arrived) == [0, 1]
    assert np.linalg.norm(track[:, 0] - track[:, 1], axis=1).min() >= 2 * PERSON
    assert engine.times == 0


def test_who_is_hemmed_in_waits_without_turning_and_then_pushes(room, crowd_in):
    crowd = crowd_in(room(), [(4.0, 2.5), *CLOSE])
    assert crowd.send(0, (7.0, 2.5), 0.0)
    here, ahead, moved = [], [], []
    for _ in range(10):
        crowd.advance()
        here.append(tuple(crowd.position[0]))
        ahead.append(float(crowd.heading[0]))
        moved.append(np.abs(crowd.position[1:] - CLOSE).max())
    assert moved[round(PUSHY / 0.2)] == 0.0
    assert moved[-1] > 0.0
    waits = [k for k in range(1, 10) if here[k] == here[k - 1]]
    assert waits
    assert all(ahead[k] == ahead[k - 1] != 0.0 for k in waits)


def test_walking_freely_is_what_the_engine_would_have_made_of_it(room, crowd_in):
    """To the last bit, period by period, with two who pass each other."""
    tracks = []
    for with_engine in (False, True):
        crowd = crowd_in(room(), [(1.0, 2.0), (7.0, 3.0)])
        assert crowd.send(0, (7.0, 2.0), 0.0)
        assert crowd.send(1, (1.0, 3.0), 0.0)
        track = []
        for _ in range(20):
            crowd._pressed = with_engine
            crowd.advance()
            track.append(crowd.position.copy())
        tracks.append(track)
    np.testing.assert_array_equal(*tracks)


def test_several_periods_at_once_are_the_same_as_one_by_one(room, crowd_in):
    ends = []
    for at_once in (1, 5):
        crowd = crowd_in(room(), [(1.0, 2.5), (5.0, 1.0)])
        crowd.send(0, (7.0, 4.0), 0.0)
        left = 40
        while left:
            left -= crowd.advance(min(at_once, left))
        ends.append([crowd.position.copy(), crowd.heading.copy()])
    np.testing.assert_array_equal(ends[0][0], ends[1][0])
    np.testing.assert_array_equal(ends[0][1], ends[1][1])


def test_who_is_after_somebody_stops_to_look_within_reach(room, crowd_in):
    """From 6 m away, 0.24 m in each period: 0.8 m are reached in the 22nd."""
    crowd = crowd_in(room(), [(1.0, 2.5), (7.0, 2.5)])
    crowd.send(0, (7.0, 2.5), 0.0)
    after = np.array([1])
    assert crowd.advance(100, after, 0.8) == 22
    assert math.dist(*crowd.position) <= 0.8
    # From then on it looks in every period, also while it stands.
    assert crowd.advance(100, after, 0.8) == 1
    crowd.halt(0)
    assert crowd.advance(100, after, 0.8) == 1
    assert crowd.advance(100) == 100


@pytest.mark.parametrize("home", HOMES)
def test_a_way_that_is_not_kept_is_as_short_as_one_that_is(home):
    routes = Routes(load_floorplan(home))
    free, _, _, scratch, kept_at, kept, n_kept = routes.arrays
    height = free.shape[1]

    def length_of(goal, start, keep):
        onward = onward_to(height, scratch, kept_at, kept, n_kept, goal, start, keep)
        total, here = 0, start
        while onward[here] != HERE:
            total += STRAIGHT if onward[here] % 2 else DIAGONAL
            here = beyond(here, onward[here], height)
        return total

    rng = np.random.default_rng(0)
    indoors = np.flatnonzero(routes.free & (routes.parts != routes.parts[0, 0]))
    label = routes.parts.ravel()
    for goal, start in rng.choice(indoors, size=(100, 2)).tolist():
        if goal != start and label[goal] == label[start]:
            assert length_of(goal, start, False) == length_of(goal, start, True)


def length(start, way):
    return sum(math.dist(a, b) for a, b in itertools.pairwise([start, *way]))


def test_the_way_round_a_box_is_the_taut_string_within_a_few_percent(room):
    """From 2 m before the box to 2 m behind it, its corners cleared by 0.3 m.

    The string runs tangentially to the circle round the first corner, 2.236 m away:
    sqrt(5 - 0.09) = 2.216 m; round it by 34.27 degrees, 0.179 m; 2 m along the side;
    and the same again: 6.791 m.
    """
    box = Furniture(name="box", center=(4.0, 2.5), size=(2.0, 2.0))
    routes = routes_of(room(size=(8.0, 6.0), furniture=(box,)))
    start, goal = (1.0, 2.5), (7.0, 2.5)
    way = routes.plan(start, goal)
    # A grid cell of 0.1 m may round the corner a little on either side.
    assert 0.98 * 6.791 < length(start, way) < 1.04 * 6.791


def test_the_way_through_the_nearer_of_two_doors_is_taken(room):
    """Through (4, 1): twice hypot(3, 1.5), 6.708 m; through the other, 7.81 m."""
    walls = ((4.0, 0.0, 4.0, 0.5), (4.0, 1.5, 4.0, 4.0), (4.0, 4.9, 4.0, 5.0))
    start, goal = (1.0, 2.5), (7.0, 2.5)
    way = routes_of(room(walls=walls)).plan(start, goal)
    assert 0.98 * 6.708 < length(start, way) < 1.05 * 6.708


def test_a_free_line_is_walked_straight(room):
    way = routes_of(room()).plan((1.0, 1.0), (7.0, 4.0))
    np.testing.assert_allclose(way, [(7.0, 4.0)])


def test_no_way_leads_through_a_wall_without_a_door(room):
    routes = routes_of(room(walls=((4.0, 0.0, 4.0, 5.0),)))
    assert len(routes.plan((1.0, 1.0), (7.0, 1.0))) == 0


@pytest.mark.parametrize(("is_open", "leads"), [(True, True), (False, False)])
def test_a_way_leads_through_an_open_door_and_not_through_a_closed_one(
    room, is_open, leads
):
    plan = room(
        walls=((4.0, 0.0, 4.0, 2.0), (4.0, 3.0, 4.0, 5.0)),
        doors=(Door(start=(4.0, 2.0), end=(4.0, 3.0), open=is_open),),
    )
    way = routes_of(plan).plan((1.0, 1.0), (7.0, 1.0))
    assert (len(way) > 0) == leads


def test_a_way_may_turn_as_often_as_it_must(room, crowd_in):
    """Round the ends of eleven walls that stand out from either side in turn."""
    ends = [(0.0, 4.0) if k % 2 else (1.0, 5.0) for k in range(11)]
    walls = tuple((x, low, x, high) for x, (low, high) in enumerate(ends, start=1))
    plan = room(size=(12.0, 5.0), walls=walls)
    start, goal = (0.5, 2.5), (11.5, 2.5)
    way = routes_of(plan).plan(start, goal)
    assert len(way) > len(walls)
    # Whose goal moves a little walks on as before, and only ends elsewhere.
    bent, left = np.array(way), len(way) - 3
    count = find_way(
        *routes_of(plan).arrays, way[2], (11.5, 2.6), bent, 3, len(way), False
    )
    assert count == left
    np.testing.assert_array_equal(bent[:left], [*way[3:-1], (11.5, 2.6)])
    crowd = crowd_in(plan, [start, (0.5, 4.0)], speed=1.2)
    assert crowd.send(0, goal, 0.0)
    seconds = 0
    while crowd.walks(0):
        crowd.advance(5)
        seconds += 1
        assert seconds < 2 * length(start, way) / 1.2
    assert math.dist(crowd.position[0], goal) < 0.1


def test_no_way_depends_on_what_else_was_asked_before():
    plan = load_floorplan("family_apartment")
    spots = [region.center for region in plan.regions]
    asked = list(itertools.permutations(spots, 2))
    forth, back = Routes(plan), Routes(plan)
    ways = [forth.plan(*pair) for pair in asked]
    assert [back.plan(*pair) for pair in reversed(asked)] == ways[::-1]
    assert [forth.plan(*pair) for pair in asked] == ways


@pytest.mark.parametrize("home", HOMES)
def test_ways_through_shipped_homes_keep_a_body_clear_of_everything_solid(home):
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
        way = routes.plan(tuple(start), tuple(goal))
        assert len(way) > 0
        assert math.dist(way[-1], goal) < 0.2
        points = [start, *map(np.array, way)]
        line = np.vstack(
            [
                a + np.linspace(0, 1, 60)[:, None] * (b - a)
                for a, b in itertools.pairwise(points)
            ]
        )
        # The rim of a cell is up to 0.07 m from its middle, which is clear by 0.3 m.
        assert deepest(plan, line, PERSON) <= 0.02


def test_a_walk_takes_as_long_as_its_way_at_the_walking_speed(room, crowd_in):
    arrived, _ = walk(crowd_in(room(), [(1.0, 2.5)]), [(7.0, 2.5)], most=8.0)
    assert 5.0 - 0.05 <= arrived[0] <= 5.0 + 0.2


def test_two_people_pass_each_other_in_a_corridor(room, crowd_in):
    """1.4 m between the walls, 0.5 m a body: there is room for both."""
    plan = room(walls=((0.0, 1.5, 8.0, 1.5), (0.0, 3.0, 8.0, 3.0)))
    crowd = crowd_in(plan, [(1.0, 2.25), (7.0, 2.25)])
    arrived, track = walk(crowd, [(7.0, 2.25), (1.0, 2.25)], most=15.0)
    assert set(arrived) == {0, 1}
    np.testing.assert_allclose(track[-1], [[7.0, 2.25], [1.0, 2.25]], atol=0.1)
    apart = np.linalg.norm(track[:, 0] - track[:, 1], axis=1)
    assert apart.min() > PERSON
    assert max(deepest(plan, moment, PERSON) for moment in track) <= OVERLAP


@pytest.mark.parametrize("offset", [0.0, 0.1, -0.3])
def test_two_people_who_meet_in_a_doorway_both_get_through(room, crowd_in, offset):
    """0.9 m wide: only one at a time fits, and they meet right in it."""
    plan = room(walls=((4.0, 0.0, 4.0, 2.05), (4.0, 2.95, 4.0, 5.0)))
    crowd = crowd_in(plan, [(1.0, 2.5), (7.0 + offset, 2.5)])
    arrived, track = walk(crowd, [(7.0, 2.5), (1.0, 2.5)], most=40.0)
    assert set(arrived) == {0, 1}
    np.testing.assert_allclose(track[-1], [[7.0, 2.5], [1.0, 2.5]], atol=0.1)


def test_four_people_change_sides_through_one_doorway(room, crowd_in):
    plan = room(walls=((4.0, 0.0, 4.0, 2.05), (4.0, 2.95, 4.0, 5.0)))
    west, east = [(1.0, 1.0), (1.0, 4.0)], [(7.0, 1.0), (7.0, 4.0)]
    crowd = crowd_in(plan, west + east)
    arrived, track = walk(crowd, east + west, most=60.0)
    assert set(arrived) == {0, 1, 2, 3}
    assert (track[-1][:2, 0] > 4.0).all()
    assert (track[-1][2:, 0] < 4.0).all()


def test_who_stands_in_the_way_is_walked_round(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    assert crowd.send(0, (7.0, 2.5), 0.0)
    for _ in range(50):
        crowd.advance()
    np.testing.assert_allclose(crowd.position[0], [7.0, 2.5], atol=0.1)
    assert math.dist(crowd.position[1], (4.0, 2.5)) < 0.5


def bound(crowd, goals):
    return [crowd.is_bound_for(i, goal) for i, goal in enumerate(goals)]


def test_all_are_asked_at_once_who_has_arrived(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5), (6.0, 1.0), (7.0, 4.0)])
    assert crowd.send(1, (4.0, 4.0), 0.0)
    standing, walking = (1.05, 2.5), (4.0, 4.0)
    goals, there = [standing, walking, (6.15, 1.0)], np.zeros(3, dtype=bool)
    assert bound(crowd, goals) == [True, True, False]
    crowd.arrived(np.array(goals), there)
    assert there.tolist() == [True, False, False]
    elsewhere = [walking, (4.0, 2.5), (6.0, 1.0)]
    assert bound(crowd, elsewhere) == [False, False, True]
    # The second is still where it set out from, but no longer there to stay.
    crowd.arrived(np.array(elsewhere), there)
    assert there.tolist() == [False, False, True]


def test_all_who_are_astray_set_out_but_those_who_are_to_stay(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 1.0), (1.0, 4.0), (4.0, 2.5), (7.0, 4.0)])
    goals = [(6.0, 1.0), (1.0, 4.0), (4.0, 1.0)]
    nobody = np.full(3, NOBODY)
    crowd.send_astray(np.array(goals), nobody, 5.0, but=[2])
    assert crowd.walking.tolist() == [True, False, False, False]
    assert (crowd.walks_since(0), crowd.walks_since(2)) == (5.0, None)
    # The second goes after the last body instead of staying in its place.
    crowd.send_astray(np.array(goals), np.array([NOBODY, 3, NOBODY]), 6.0)
    assert crowd.walking.tolist() == [True, True, True, False]
    assert bound(crowd, [(6.0, 1.0), (7.0, 4.0), (4.0, 1.0)]) == [True] * 3
    assert crowd.walks_since(0) == 5.0


def test_ways_with_many_turns_make_room_for_themselves(room, crowd_in):
    ends = [(0.0, 4.0) if k % 2 else (1.0, 5.0) for k in range(11)]
    walls = tuple((x, low, x, high) for x, (low, high) in enumerate(ends, start=1))
    plan = room(size=(12.0, 5.0), walls=walls)
    crowd = crowd_in(plan, [(0.5, 1.5), (0.5, 2.5), (0.5, 3.5)])
    goals = [(11.5, 1.5), (11.5, 2.5), (0.5, 4.5)]
    crowd.send_astray(np.array(goals), np.full(3, NOBODY), 0.0)
    assert bound(crowd, goals) == [True] * 3
    assert crowd.walking.all()


def test_who_is_kept_from_a_place_is_bound_for_it_while_it_stays_near(room):
    radius, mass = np.full(2, PERSON), np.array([70.0, 1e6])
    crowd = Crowd(room(), Build(radius, mass, np.full(2, 1.2)), 0.2, 0.1)
    crowd.place(np.array([(1.0, 2.5), (4.0, 2.5)]), np.zeros(2))
    assert crowd.send(0, (4.0, 2.5), 0.0)
    for _ in range(100):
        crowd.advance()
    assert not crowd.walks(0)
    assert 0.1 < math.dist(crowd.where[0], (4.0, 2.5)) <= 1.0
    for goal, is_bound in (((4.0, 2.5), True), ((3.2, 2.5), False)):
        assert crowd.is_bound_for(0, goal) == is_bound
        there = np.zeros(1, dtype=bool)
        crowd.arrived(np.array([goal]), there)
        assert there.tolist() == [is_bound]
        crowd.send_astray(np.array([goal]), np.full(1, NOBODY), 100.0)
        assert crowd.walks(0) != is_bound


def test_heads_turn_no_faster_than_they_can_and_the_shorter_way(room, crowd_in):
    def look(*degrees: float) -> None:
        angles = np.radians(degrees)
        ahead = np.column_stack([np.cos(angles), np.sin(angles)])
        crowd.turn_heads(
            np.full(2, NOBODY), crowd.position + ahead, np.radians([30, 30])
        )

    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    crowd.gaze[:] = math.radians(170.0), 0.0
    look(-170.0, 10.0)
    turned = np.degrees(crowd.gaze) % 360.0
    np.testing.assert_allclose(turned, [190.0, 10.0])
    look(-90.0, 180.0)
    assert np.degrees(crowd.gaze[0]) % 360.0 == pytest.approx(220.0)
    assert abs(np.degrees(crowd.gaze[1]) - 10.0) == pytest.approx(30.0)


def test_walkers_look_ahead_unless_at_somebody_and_who_has_nothing_to_look_at_too(
    room, crowd_in
):
    crowd = crowd_in(room(), [(1.0, 1.0), (4.0, 1.0), (1.0, 4.0)])
    crowd.heading[:] = crowd.gaze[:] = math.radians(40.0)
    nothing = (math.nan, math.nan)
    focus, most = np.array([(1.0, 2.0), nothing]), np.full(3, np.pi)
    crowd.walking[0] = True
    crowd.turn_heads(np.full(2, NOBODY), focus, most)
    np.testing.assert_allclose(np.degrees(crowd.gaze), 40.0)
    crowd.walking[0] = False
    crowd.turn_heads(np.array([NOBODY, 0]), focus, most)
    np.testing.assert_allclose(np.degrees(crowd.gaze) % 360.0, [90.0, 180.0, 40.0])


def test_nobody_begins_inside_anything_solid_or_anybody_else(shipped_scenario):
    env = household_v0.parallel_env(shipped_scenario)
    n, robots = len(env.life.people.everyone), len(env.possible_agents)
    radius = np.array([PERSON] * n + [ROBOT] * robots)
    for seed in range(5):
        env.reset(seed=seed)
        position = env.life.crowd.position
        assert deepest(env.scenario.plan, position, radius) <= OVERLAP
        gap = np.linalg.norm(position[:, None] - position, axis=2)
        touching = radius[:, None] + radius - OVERLAP
        np.fill_diagonal(gap, np.inf)
        assert (gap > touching).all()


def soak(scenario, decisions):
    """Nobody outdoors, in a wall, or walking on the spot for more than 30 s."""
    env = household_v0.parallel_env(scenario)
    plan = env.scenario.plan
    n, robots = len(env.life.people.everyone), len(env.possible_agents)
    radius = np.array([PERSON] * n + [ROBOT] * robots)
    rng = np.random.default_rng(3)
    since, there = np.zeros(n), np.zeros((n, 2))
    for decision in range(decisions):
        if not env.agents:
            env.reset(seed=0 if decision == 0 else None)
            since[:], there[:] = 0.0, env.life.crowd.position[:n]
        env.step({a: int(rng.integers(len(env.behaviors))) for a in env.agents})
        position = env.life.crowd.position
        assert (position > plan.lower).all()
        assert (position < plan.upper).all()
        assert deepest(plan, position, radius) <= OVERLAP
        walks = np.array([env.life.crowd.walks(i) for i in range(n)])
        moved = np.linalg.norm(position[:n] - there, axis=1) > 0.5
        restart = moved | ~walks
        since[restart] = env.time
        there[restart] = position[:n][restart]
        assert (env.time - since <= 30.0).all(), f"decision {decision}"


def test_nobody_leaves_sinks_or_gets_stuck(shipped_scenario):
    soak(shipped_scenario, 250)


@pytest.mark.slow
def test_nobody_of_twelve_leaves_sinks_or_gets_stuck_in_100_000_decisions():
    soak("party", 100_000)
