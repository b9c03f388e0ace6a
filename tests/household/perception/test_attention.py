"""Who sees whom and who attends to whom: facts of geometry and numbers by hand."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from household import household_v0
from household.home.floorplan import Door, Furniture, Region
from household.home.geometry import crosses
from household.perception import kernel
from household.perception.senses import Beings, Senses
from household.scenario.scenario import (
    PerceptionModel,
    PersonSpec,
    RobotSpec,
    ScriptStep,
)

CLOSED = -1.0
WIDE = math.radians(60.0)


@pytest.fixture
def sensing(room):
    """Lets entities perceive one moment; they look east unless told otherwise."""

    def perceive(position, *, plan=None, senses=None, now=0.0, **changes):
        n = len(position)
        senses = senses or Senses(plan or room(), PerceptionModel(), n)
        usual = {
            "position": np.array(position, dtype=float),
            "gaze": np.zeros(n),
            "half_view": np.full(n, WIDE),
            "salience": np.ones(n),
            "absorption": np.full(n, 0.3),
            "source": np.zeros(n),
        }
        arrays = {k: np.array(v, dtype=float) for k, v in changes.items()}
        senses.perceive(Beings(**(usual | arrays)), now)
        return senses

    return perceive


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


@pytest.mark.parametrize("turns", [-3, -1, 1, 4])
def test_a_head_that_turned_all_the_way_round_sees_the_same(sensing, turns):
    once = sensing(TWO)
    often = sensing(TWO, gaze=[2 * math.pi * turns, 0.0])
    np.testing.assert_allclose(often.attention, once.attention, atol=1e-12)


def test_who_sleeps_sees_nobody_and_attends_to_nobody(sensing):
    senses = sensing(TWO, half_view=[CLOSED, WIDE], salience=[1.0, 10.0])
    assert not senses.sees[0].any()
    assert not senses.attends[0].any()
    assert senses.attention[0].sum() == 0.0


def test_robots_attend_too(sensing):
    # The second looks back west; nothing holds its attention back but absorption.
    senses = sensing([(1.0, 2.5), (3.0, 2.5)], gaze=[0.0, math.pi])
    assert senses.attends.tolist() == [[False, True], [True, False]]


def test_nobody_attends_to_itself(sensing):
    assert not sensing([(1.0, 1.0), (1.0, 1.5), (2.0, 1.0)]).sees.diagonal().any()


def test_attention_is_the_formula_worked_by_hand(sensing):
    """Three meters ahead counts half; 30 degrees off, exp(-1/2) of that."""
    aside = (1.0 + 3.0 * math.cos(math.pi / 6), 1.0 + 1.5)
    senses = sensing([(1.0, 1.0), (4.0, 1.0), aside], salience=[1.0, 1.6, 1.0])
    ahead, off = 1.6 / 2.0, 0.6065306597 / 2.0
    total = 0.3 + ahead + off
    np.testing.assert_allclose(
        senses.attention[0], [0.0, ahead / total, off / total], rtol=1e-9
    )
    np.testing.assert_allclose(senses.attention[0, 1], 0.57009, atol=1e-5)


def test_attention_falls_with_distance_and_rises_with_salience(sensing):
    near, far = (sensing([(1.0, 2.5), (x, 2.5)]).attention[0, 1] for x in (2.0, 6.0))
    loud = sensing(TWO, salience=[1.0, 1.6]).attention[0, 1]
    assert near > loud > far


def test_attention_is_a_limited_resource(sensing):
    """A second robot takes attention from the first."""
    alone = sensing([(1.0, 2.5), (4.0, 2.5)]).attention[0, 1]
    shared = sensing([(1.0, 2.5), (4.0, 2.5), (4.0, 2.4)]).attention[0]
    assert shared[1] < alone
    assert shared.sum() < 1.0


@settings(max_examples=100, deadline=None)
@given(
    st.lists(
        st.tuples(
            st.floats(0.1, 7.9),
            st.floats(0.1, 4.9),
            st.floats(-7.0, 7.0),
            st.floats(0.1, 10.0),
            st.floats(0.01, 3.0),
        ),
        min_size=2,
        max_size=8,
    )
)
def test_rows_of_the_attention_matrix_sum_below_one(entities):
    table = np.array(entities)
    position = np.ascontiguousarray(table[:, :2])
    n = len(table)
    hidden, half_view = np.zeros((n, n), dtype=np.int64), np.full(n, math.pi)
    sees, facing, share = np.empty((n, n), bool), np.empty((n, n)), np.empty((n, n))
    gaze, salience, absorption = table.T[2:].copy()
    kernel.sight(position, gaze, half_view, hidden, sees, facing)
    kernel.attention(position, sees, facing, salience, absorption, 0.5, 3.0, share)
    assert (share >= 0.0).all()
    assert (share.sum(axis=1) < 1.0).all()
    assert (share.diagonal() == 0.0).all()


corner = st.tuples(st.integers(-20, 20), st.integers(-20, 20))


def properly_crosses(a, b, c, d):
    """Whether two segments cross, by solving for where; None if that is on an edge."""
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = a, b, c, d
    determinant = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if determinant == 0:
        return None
    t = Fraction((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx), determinant)
    u = Fraction((cx - ax) * (by - ay) - (cy - ay) * (bx - ax), determinant)
    if t in (0, 1) or u in (0, 1):
        return None
    return 0 < t < 1 and 0 < u < 1


@settings(max_examples=300, deadline=None)
@given(corner, corner, corner, corner)
def test_lines_of_sight_are_crossed_exactly_where_geometry_says(a, b, c, d):
    expected = properly_crosses(a, b, c, d)
    if expected is not None:
        ends = np.array([a, b], dtype=float)
        columns = np.array([[*c, *d]], dtype=float).T.copy()
        assert kernel.between(ends, 0, 1, columns) == expected
        assert kernel.between(ends, 1, 0, columns) == expected
        assert crosses(*ends[0], *ends[1], columns[:, 0]) == expected


def test_attending_begins_above_one_threshold_and_ends_below_a_lower_one(sensing):
    """Shares 0.30, 0.45, 0.30, 0.20, 0.30: only the path tells the equal ones apart."""
    senses, attends, began = None, [], []
    for now, share in enumerate((0.30, 0.45, 0.30, 0.20, 0.30)):
        # At 3 m salience counts half: share = (s / 2) / (0.3 + s / 2).
        salience = 2.0 * 0.3 * share / (1.0 - share)
        senses = sensing(
            [(1.0, 2.5), (4.0, 2.5)],
            senses=senses,
            salience=[1.0, salience],
            now=float(now),
        )
        assert senses.attention[0, 1] == pytest.approx(share)
        attends.append(bool(senses.attends[0, 1]))
        began.append(senses.attention_began[0, 1])
    assert attends == [False, True, True, False, False]
    np.testing.assert_array_equal(began, [np.nan, 1.0, 1.0, np.nan, np.nan])


def test_a_new_episode_has_forgotten_who_attended(sensing):
    senses = sensing([(1.0, 2.5), (2.0, 2.5)], now=5.0)
    assert senses.attends.any()
    senses.forget()
    assert not senses.attends.any()
    assert not senses.sees.any()
    assert np.isnan(senses.attention_began).all()


def test_a_door_between_episodes_of_standing_still_changes_nothing(sensing, room):
    """Positions that did not change are not looked at anew, with the same result."""
    plan = room(walls=((4.0, 1.0, 4.0, 4.0),))
    senses = sensing(TWO, plan=plan)
    for gaze in ([0.0, math.pi], [0.0, 0.0]):
        assert not sensing(TWO, senses=senses, gaze=gaze).sees.any()
    assert sensing([(1.0, 4.5), (6.0, 4.5)], senses=senses).sees[0, 1]


def test_a_person_who_faces_the_robot_is_told_to_attend_to_it(household_of):
    looking = ScriptStep(place="phone", duration=(900.0, 900.0), look_at="robot_0")
    scenario = household_of(
        people=(PersonSpec(name="ann", persona="paper_actor", script=(looking,)),),
        robots=(RobotSpec(position=(3.0, 2.5)),),
    )
    env = household_v0.parallel_env(scenario)
    env.reset(seed=1)
    assert env.situation("robot_0").attends == {("ann", "robot_0")}
    assert env.attended("robot_0")


def test_who_falls_asleep_attends_to_no_robot_whatever_it_does(household_of, room):
    bed = Region(name="bed", activity="sleeping", center=(1.0, 2.5), facing=(8.0, 2.5))
    scenario = household_of(
        home=room(regions=(bed,)),
        people=(
            PersonSpec(
                name="ann",
                persona="paper_actor",
                script=(
                    ScriptStep(place="bed", duration=(900.0, 900.0), look_at="robot_0"),
                ),
            ),
        ),
        robots=(RobotSpec(position=(3.0, 2.5)),),
        norms={},
    )
    env = household_v0.parallel_env(scenario)
    env.reset(seed=1)
    env.step({"robot_0": 1})
    for _ in range(10):
        env.step({"robot_0": 1})
        assert env.situation("robot_0").attends == frozenset()
