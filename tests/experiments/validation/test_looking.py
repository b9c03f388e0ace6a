"""Head turns and mutual gaze are found in the way that heads and trunks point."""

import numpy as np
import pytest

from experiments.validation.looking import Turn, looks, mutual_gazes, turns

DOWN = -np.pi / 2


def pointing(moments, degrees, person=0):
    """Where heads point, if one person turns and nobody else does."""
    gaze = np.zeros((moments, 3))
    gaze[:, person] = np.radians(degrees)
    return gaze


def test_a_turn_goes_on_as_long_as_the_head_turns_in_one_direction(diary):
    gaze = pointing(8, [0, 0, 40, 100, 100, 70, 70, 60])
    assert turns(diary(8, gaze=gaze), 0) == [
        Turn(angle=pytest.approx(100.0), trunk=0.0, peak=pytest.approx(60.0)),
        Turn(angle=pytest.approx(30.0), trunk=0.0, peak=pytest.approx(30.0)),
    ]


def test_a_turn_past_half_a_circle_is_as_short_as_it_is(diary):
    gaze = pointing(3, [170, -170, -170])
    (turn,) = turns(diary(3, gaze=gaze), 0)
    assert turn.angle == pytest.approx(20.0)


def test_who_walks_or_sleeps_turns_no_head(diary):
    gaze = pointing(4, [0, 60, 60, 60])
    asleep = np.ones((4, 2), bool)
    asleep[1, 0] = False
    assert turns(diary(4, gaze=gaze, eyes_open=asleep), 0) == []
    position = diary(4).position.copy()
    position[1:, 0] += 1.0
    assert turns(diary(4, gaze=gaze, position=position), 0) == []


def test_the_trunk_takes_part_in_a_turn(diary):
    gaze, trunk = pointing(3, [0, 120, 120]), pointing(3, [0, 30, 30])
    told = diary(3, gaze=gaze, heading=trunk)
    assert turns(told, 0)[0].trunk == pytest.approx(30.0)
    assert looks(told)["head turns without the trunk"] == 0.0


def test_turns_are_counted_in_the_minutes_in_which_people_stand(diary):
    gaze = pointing(31, [0] + [90] * 30)
    told = looks(diary(31, gaze=gaze))
    assert told["head turns"] == pytest.approx(1.0)  # Of two people, half a minute.
    assert told["angle of a head turn"] == pytest.approx(90.0)


def test_eyes_meet_while_both_face_each_other(diary):
    gaze = np.zeros((10, 3))
    gaze[:, 1] = DOWN
    gaze[3:7, 1] = np.pi  # The second person stands to the right of the first.
    assert mutual_gazes(diary(gaze=gaze)) == [4.0]


def test_a_mutual_gaze_needs_sight_and_an_end(diary):
    gaze = np.zeros((10, 3))
    gaze[:, 1] = np.pi
    assert mutual_gazes(diary(gaze=gaze)) == []
    gaze[7:, 1] = DOWN
    assert mutual_gazes(diary(gaze=gaze)) == [7.0]
    behind_a_wall = np.zeros((10, 3, 3))
    assert mutual_gazes(diary(gaze=gaze, attention=behind_a_wall)) == []
