"""Walking: giving way, pushing and arriving."""

import math

import numpy as np
import pytest

from household.compiled.arrays import NOBODY
from household.motion.bodies import BodyParams, Goals, Pursuit
from household.motion.crowd import Crowd
from household.motion.steering import PUSHY
from household.simulation.simulation import PERSON_RADIUS as PERSON

OVERLAP = 0.01  # Nobody overlaps a wall by more than this [m].


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

FAR = (7.5, 4.5)
"""In a corner, where nobody walks. For one body alone the loops of `Crowd` would all be
compiled once more: the only row of a table is contiguous, those of several are not."""


@pytest.mark.parametrize(
    ("start", "goal", "asked"),
    [
        ([(1.0, 2.5), FAR], (7.0, 2.5), False),
        # Past somebody who stands aside, and past a wall with a hand's breadth between.
        ([(1.0, 2.5), (4.0, 3.2)], (7.0, 2.5), False),
        ([(1.0, 0.4), FAR], (7.0, 0.4), False),
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
    crowd.send(0, goal)
    for _ in range(60):
        crowd.advance()
    taken = any(tuple(body) == goal for body in start)
    assert math.dist(crowd.position[0], goal) < (0.6 if taken else 0.1)
    assert (engine.times > 0) == asked


def test_who_walks_does_not_move_who_stands_but_goes_round(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    crowd.send(0, (7.0, 2.5))
    aside = 0.0
    while crowd.walks(0):
        crowd.advance()
        aside = max(aside, abs(crowd.position[0, 1] - 2.5))
        assert math.dist(*crowd.position) >= 0.5
    assert crowd.position[1].tolist() == [4.0, 2.5]
    assert 0.5 < aside < 0.8


def test_two_who_meet_pass_without_touching_and_without_the_engine(
    room, crowd_in, monkeypatch, walk
):
    crowd = crowd_in(room(), [(1.0, 2.5), (7.0, 2.5)])
    engine = Asked(crowd, monkeypatch)
    arrived, track = walk(crowd, [(7.0, 2.5), (1.0, 2.5)], 12.0)
    assert sorted(arrived) == [0, 1]
    assert np.linalg.norm(track[:, 0] - track[:, 1], axis=1).min() >= 2 * PERSON
    assert engine.times == 0


def test_a_walker_with_all_sides_blocked_waits_without_turning_and_then_pushes(
    room, crowd_in
):
    crowd = crowd_in(room(), [(4.0, 2.5), *CLOSE])
    crowd.send(0, (7.0, 2.5))
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
        crowd.send(0, (7.0, 2.0))
        crowd.send(1, (1.0, 3.0))
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
        crowd.send(0, (7.0, 4.0))
        left = 40
        while left:
            left -= crowd.advance(min(at_once, left))
        ends.append([crowd.position.copy(), crowd.heading.copy()])
    np.testing.assert_array_equal(ends[0][0], ends[1][0])
    np.testing.assert_array_equal(ends[0][1], ends[1][1])


def test_who_is_after_somebody_stops_to_look_within_reach(room, crowd_in):
    """From 6 m away, 0.24 m in each period: 0.8 m are reached in the 22nd."""
    crowd = crowd_in(room(), [(1.0, 2.5), (7.0, 2.5)])
    crowd.send(0, (7.0, 2.5))
    after = Pursuit(np.array([1]), 0.8)
    assert crowd.advance(100, after) == 22
    assert math.dist(*crowd.position) <= 0.8
    # From then on it looks in every period, also while it stands.
    assert crowd.advance(100, after) == 1
    crowd.halt(0)
    assert crowd.advance(100, after) == 1
    assert crowd.advance(100) == 100


def test_a_walk_takes_as_long_as_its_way_at_the_walking_speed(room, crowd_in, walk):
    arrived, _ = walk(crowd_in(room(), [(1.0, 2.5), FAR]), [(7.0, 2.5)], most=8.0)
    assert 5.0 - 0.05 <= arrived[0] <= 5.0 + 0.2


def test_two_people_pass_each_other_in_a_corridor(room, crowd_in, walk, deepest):
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
def test_two_people_who_meet_in_a_doorway_both_get_through(
    room, crowd_in, offset, walk
):
    """0.9 m wide: only one at a time fits, and they meet right in it."""
    plan = room(walls=((4.0, 0.0, 4.0, 2.05), (4.0, 2.95, 4.0, 5.0)))
    crowd = crowd_in(plan, [(1.0, 2.5), (7.0 + offset, 2.5)])
    arrived, track = walk(crowd, [(7.0, 2.5), (1.0, 2.5)], most=40.0)
    assert set(arrived) == {0, 1}
    np.testing.assert_allclose(track[-1], [[7.0, 2.5], [1.0, 2.5]], atol=0.1)


def test_four_people_change_sides_through_one_doorway(room, crowd_in, walk):
    plan = room(walls=((4.0, 0.0, 4.0, 2.05), (4.0, 2.95, 4.0, 5.0)))
    west, east = [(1.0, 1.0), (1.0, 4.0)], [(7.0, 1.0), (7.0, 4.0)]
    crowd = crowd_in(plan, west + east)
    arrived, track = walk(crowd, east + west, most=60.0)
    assert set(arrived) == {0, 1, 2, 3}
    assert (track[-1][:2, 0] > 4.0).all()
    assert (track[-1][2:, 0] < 4.0).all()


def test_who_stands_in_the_way_is_walked_round(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    crowd.send(0, (7.0, 2.5))
    for _ in range(50):
        crowd.advance()
    np.testing.assert_allclose(crowd.position[0], [7.0, 2.5], atol=0.1)
    assert math.dist(crowd.position[1], (4.0, 2.5)) < 0.5


def bound(crowd, goals):
    return [crowd.is_bound_for(i, goal) for i, goal in enumerate(goals)]


def test_all_are_asked_at_once_who_has_arrived(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5), (6.0, 1.0), (7.0, 4.0)])
    crowd.send(1, (4.0, 4.0))
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


def test_all_who_need_a_new_path_set_out_but_those_who_are_to_stay(room, crowd_in):
    crowd = crowd_in(room(), [(1.0, 1.0), (1.0, 4.0), (4.0, 2.5), (7.0, 4.0)])
    goals = [(6.0, 1.0), (1.0, 4.0), (4.0, 1.0)]
    nobody = np.full(3, NOBODY)
    crowd.send_who_needs_replan(Goals(np.array(goals), nobody), but=[2])
    assert crowd.walking.tolist() == [True, False, False, False]
    # The second goes after the last body instead of staying in its place.
    after = Goals(np.array(goals), np.array([NOBODY, 3, NOBODY]))
    crowd.send_who_needs_replan(after)
    assert crowd.walking.tolist() == [True, True, True, False]
    assert bound(crowd, [(6.0, 1.0), (7.0, 4.0), (4.0, 1.0)]) == [True] * 3


def test_paths_with_many_turns_make_room_for_themselves(room, crowd_in):
    ends = [(0.0, 4.0) if k % 2 else (1.0, 5.0) for k in range(11)]
    walls = tuple((x, low, x, high) for x, (low, high) in enumerate(ends, start=1))
    plan = room(size=(12.0, 5.0), walls=walls)
    crowd = crowd_in(plan, [(0.5, 1.5), (0.5, 2.5), (0.5, 3.5)])
    goals = [(11.5, 1.5), (11.5, 2.5), (0.5, 4.5)]
    crowd.send_who_needs_replan(Goals(np.array(goals), np.full(3, NOBODY)))
    assert bound(crowd, goals) == [True] * 3
    assert crowd.walking.all()


def closed_off(room):
    """A room whose right end nobody can get into."""
    return room(walls=((5.0, 0.0, 5.0, 5.0),))


def test_where_no_path_leads_people_stand_still_and_robots_do_once_they_would_walk(
    room, crowd_in
):
    crowd = crowd_in(closed_off(room), [(1.0, 1.0), (1.0, 2.5), (1.0, 4.0)])
    goals, nobody = np.array([(7.0, 1.0), (3.0, 2.5)]), np.full(2, NOBODY)
    crowd.send_who_needs_replan(Goals(goals, nobody))
    crowd.send(2, (7.0, 4.0))
    assert crowd.walking.tolist() == [False, True, True]
    crowd.advance()
    assert crowd.walking.tolist() == [False, True, False]
    np.testing.assert_array_equal(crowd.position[[0, 2]], [(1.0, 1.0), (1.0, 4.0)])
    assert crowd.position[1, 0] > 1.0


@pytest.mark.parametrize("stop", ["halt", "place"])
def test_who_is_stopped_before_it_walks_stays_where_it_is(room, crowd_in, stop):
    start = [(1.0, 2.5), FAR]
    crowd = crowd_in(room(), start)
    crowd.send(0, (7.0, 2.5))
    if stop == "halt":
        crowd.halt(0)
    else:
        crowd.place(np.array(start), np.zeros(2))
    crowd.advance(5)
    assert not crowd.walking.any()
    np.testing.assert_array_equal(crowd.position, start)


def test_who_was_sent_and_stopped_no_longer_stays_near_where_others_stood(
    room, crowd_in
):
    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    crowd.send(0, (4.0, 2.5))
    for _ in range(100):
        crowd.advance()
    assert crowd.is_bound_for(0, (4.0, 2.5))
    crowd.send(0, (7.0, 4.0))
    crowd.halt(0)
    assert not crowd.is_bound_for(0, (4.0, 2.5))


def test_paths_found_beforehand_lead_where_those_found_on_the_way_do(room, crowd_in):
    walls = ((3.0, 0.0, 3.0, 4.0), (5.0, 1.0, 5.0, 5.0))
    start, ways = [(1.0, 1.0), (1.0, 2.5), (7.0, 4.0)], {0: (7.0, 2.5), 2: (1.0, 4.0)}
    tracks = []
    for beforehand in (False, True):
        crowd = crowd_in(room(walls=walls), start)
        track = []
        for moment in range(60):
            if moment % 20 == 0:
                for i, goal in ways.items():
                    crowd.send(i, goal if moment != 20 else start[i])
            if beforehand:
                assert crowd.find_paths() == (moment % 20 == 0)
                assert not crowd.find_paths()
            crowd.advance()
            track.append(crowd.position.copy())
        tracks.append(track)
    np.testing.assert_array_equal(*tracks)


def test_who_is_kept_from_a_place_is_bound_for_it_while_it_stays_near(room):
    radius, mass = np.full(2, PERSON), np.array([70.0, 1e6])
    crowd = Crowd(room(), BodyParams(radius, mass, np.full(2, 1.2)), 0.2, 0.1)
    crowd.place(np.array([(1.0, 2.5), (4.0, 2.5)]), np.zeros(2))
    crowd.send(0, (4.0, 2.5))
    for _ in range(100):
        crowd.advance()
    assert not crowd.walks(0)
    assert 0.1 < math.dist(crowd.where[0], (4.0, 2.5)) <= 1.0
    for goal, is_bound in (((4.0, 2.5), True), ((3.2, 2.5), False)):
        assert crowd.is_bound_for(0, goal) == is_bound
        there = np.zeros(1, dtype=bool)
        crowd.arrived(np.array([goal]), there)
        assert there.tolist() == [is_bound]
        alone = Goals(np.array([goal]), np.full(1, NOBODY))
        crowd.send_who_needs_replan(alone)
        assert crowd.walks(0) != is_bound
