"""Walking is tested in halls that may lie anywhere."""

import numpy as np
import pytest

from experiments.validation import walks
from experiments.validation.halls import FRAMES, Frame, Walk, building, lattice, walk


@pytest.mark.parametrize("frame", FRAMES, ids=lambda frame: frame.name)
def test_a_frame_takes_points_away_and_back(frame):
    points = np.array([[1.0, 2.0], [-3.0, 0.5]])
    assert frame.back(frame.out(points)) == pytest.approx(points)


def test_a_frame_turns_a_hall_before_it_shifts_it():
    frame = Frame("somewhere", 90.0, (10.0, 0.0))
    hall = frame.plan(building([(0, 0), (4, 0), (4, 2), (0, 2)]))
    assert hall.walls[0].end == pytest.approx((10.0, 4.0))


@pytest.mark.parametrize("frame", FRAMES, ids=lambda frame: frame.name)
def test_a_walker_is_where_the_drawing_has_it_whatever_the_frame(frame):
    hall = building([(0, 0), (12, 0), (12, 2), (0, 2)])
    walked = walk(frame, hall, [((1.0, 1.0), (11.0, 1.0))], speed=1.0)
    assert walked.track[0, 0] == pytest.approx((1.0, 1.0))
    assert walked.track[-1, 0] == pytest.approx((11.0, 1.0), abs=0.1)
    assert walked.passed(0, 6.0)[0] == pytest.approx(5.0, abs=0.3)


def test_who_never_gets_there_has_no_time():
    track = np.zeros((3, 1, 2))
    assert np.isnan(Walk(track=track, goals=np.zeros((1, 2))).passed(0, 1.0)).all()


def test_bodies_in_a_wall_and_beyond_it_are_found():
    hall = building([(0, 0), (4, 0), (4, 4), (0, 4)])
    goals = np.zeros((1, 2))
    near = np.array([[[2.0, 2.0]], [[2.0, 0.2]]])
    assert walks.overlap(hall, Walk(track=near, goals=goals)) == pytest.approx(0.1)
    free = np.array([[[2.0, 2.0]], [[2.0, 1.0]]])
    assert walks.overlap(hall, Walk(track=free, goals=goals)) == 0.0
    through = np.array([[[2.0, 2.0]], [[2.0, -1.0]]])
    assert walks.overlap(hall, Walk(track=through, goals=goals)) == walks.NEVER


def test_a_lattice_is_filled_row_by_row():
    assert lattice((0.0, 1.0), 2, 2, 0.5) == [(0, 1), (0.5, 1), (0, 1.5), (0.5, 1.5)]


@pytest.mark.parametrize("frame", FRAMES, ids=lambda frame: frame.name)
def test_people_keep_their_speed_their_time_and_their_exit(frame):
    assert walks.corridor_time(frame) == pytest.approx(40.0 / walks.SPEED, abs=0.4)
    assert walks.reaction_error(frame) <= 1.0
    assert walks.astray(frame) == 0.0
    assert walks.detour(frame) < 1.05
