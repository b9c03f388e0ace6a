"""Who sees whom: facts of geometry."""

import math

import pytest

from household.home.floorplan import Door, Furniture
from household.perception.senses import Senses
from household.scenario.scenario import PerceptionModel

TWO = [(1.0, 2.5), (6.0, 2.5)]
SHELF = Furniture(name="shelf", center=(4.0, 2.5), size=(0.3, 2.0), tall=True)
TABLE = Furniture(name="table", center=(4.0, 2.5), size=(0.3, 2.0))
WALLS = ((4.0, 0.0, 4.0, 2.0), (4.0, 3.0, 4.0, 5.0))


def test_nothing_between_them_shows_the_robot(sensing):
    assert sensing(TWO).sees.tolist() == [[False, True], [False, False]]


def test_a_wall_between_them_hides_the_robot(sensing, room):
    plan = room(walls=((4.0, 1.0, 4.0, 4.0),))
    assert not sensing(TWO, plan=plan).sees.any()
    assert not sensing(TWO, plan=plan).attends.any()


def test_a_wall_that_ends_a_finger_before_the_line_of_sight_hides_nothing(
    sensing, room
):
    assert sensing(TWO, plan=room(walls=((4.0, 0.0, 4.0, 2.49),))).sees[0, 1]
    assert not sensing(TWO, plan=room(walls=((4.0, 0.0, 4.0, 2.51),))).sees[0, 1]


@pytest.mark.parametrize(("is_open", "seen"), [(True, True), (False, False)])
def test_an_open_door_shows_the_robot_and_a_closed_one_hides_it(
    sensing, room, is_open, seen
):
    door = Door(start=(4.0, 2.0), end=(4.0, 3.0), open=is_open)
    assert sensing(TWO, plan=room(walls=WALLS, doors=(door,))).sees[0, 1] == seen


@pytest.mark.parametrize(("piece", "seen"), [(SHELF, False), (TABLE, True)])
def test_tall_furniture_hides_the_robot_and_low_furniture_does_not(
    sensing, room, piece, seen
):
    assert sensing(TWO, plan=room(furniture=(piece,))).sees[0, 1] == seen


def test_turned_furniture_hides_what_its_turned_box_covers(sensing, room):
    turned = Furniture(
        name="shelf", center=(4.0, 2.5), size=(0.3, 2.0), angle=90.0, tall=True
    )
    plan = room(furniture=(turned,))
    assert not sensing(TWO, plan=plan).sees[0, 1]
    # The box now reaches from x = 3 to 5, but only from y = 2.35 to 2.65.
    assert sensing([(4.0, 3.0), (6.0, 3.0)], plan=plan).sees[0, 1]


def test_what_is_behind_the_back_is_not_seen(sensing):
    assert not sensing(TWO, gaze=[math.pi, 0.0]).sees[0, 1]


@pytest.mark.parametrize(("degrees", "seen"), [(59.0, True), (61.0, False)])
@pytest.mark.parametrize("turn", [-1, 1])
def test_the_field_of_view_ends_at_half_its_angle_on_either_side(
    sensing, degrees, seen, turn
):
    gaze = [turn * math.radians(degrees), 0.0]
    assert sensing(TWO, gaze=gaze).sees[0, 1] == seen


def test_nobody_sees_itself(sensing):
    assert not sensing([(1.0, 1.0), (1.0, 1.5), (2.0, 1.0)]).sees.diagonal().any()


def test_who_stands_still_sees_the_same_as_before_until_somebody_moves(sensing, room):
    """Positions that did not change are not looked at anew, with the same result."""
    senses = Senses(room(walls=((4.0, 1.0, 4.0, 4.0),)), PerceptionModel(), 2)
    for gaze in ([0.0, 0.0], [0.0, math.pi], [0.0, 0.0]):
        assert not sensing(TWO, senses=senses, gaze=gaze).sees.any()
    assert sensing([(1.0, 4.5), (6.0, 4.5)], senses=senses).sees[0, 1]
