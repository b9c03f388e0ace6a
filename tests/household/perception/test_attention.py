"""Who attends to whom: numbers by hand."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from household import household_v0
from household.home.floorplan import Region
from household.perception.relations import Entities
from household.perception.senses import Senses
from household.scenario.scenario import (
    PerceptionModel,
    PersonSpec,
    RobotSpec,
    ScriptStep,
)

CLOSED = -1.0
WIDE = math.radians(60.0)

TWO = [(1.0, 2.5), (6.0, 2.5)]


@pytest.mark.parametrize("turns", [-3, -1, 1, 4])
def test_a_head_that_turned_all_the_way_round_sees_the_same(sensing, turns):
    once = sensing(TWO)
    often = sensing(TWO, gaze=[2 * math.pi * turns, 0.0])
    np.testing.assert_allclose(often.attention, once.attention, atol=1e-12)


def test_who_sleeps_sees_nobody_and_attends_to_nobody(sensing):
    relations = sensing(TWO, half_view=[CLOSED, WIDE], salience=[1.0, 10.0])
    assert not relations.sees[0].any()
    assert not relations.attends[0].any()
    assert relations.attention[0].sum() == 0.0


def test_robots_attend_too(sensing):
    # The second looks back west; nothing holds its attention back but absorption.
    relations = sensing([(1.0, 2.5), (3.0, 2.5)], gaze=[0.0, math.pi])
    assert relations.attends.tolist() == [[False, True], [True, False]]


def test_attention_is_the_formula_worked_by_hand(sensing):
    """Three meters ahead counts half; 30 degrees off, exp(-1/2) of that."""
    aside = (1.0 + 3.0 * math.cos(math.pi / 6), 1.0 + 1.5)
    relations = sensing([(1.0, 1.0), (4.0, 1.0), aside], salience=[1.0, 1.6, 1.0])
    ahead, off = 1.6 / 2.0, 0.6065306597 / 2.0
    total = 0.3 + ahead + off
    np.testing.assert_allclose(
        relations.attention[0], [0.0, ahead / total, off / total], rtol=1e-9
    )
    np.testing.assert_allclose(relations.attention[0, 1], 0.57009, atol=1e-5)


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
def test_rows_of_the_attention_matrix_sum_below_one(room, everybody):
    table = np.array(everybody)
    position = np.ascontiguousarray(table[:, :2])
    n = len(table)
    gaze, salience, absorption = table.T[2:].copy()
    half_view, source = np.full(n, math.pi), np.zeros(n)
    senses = Senses(room(), PerceptionModel(), n)
    entities = Entities(position, gaze, half_view, salience, absorption, source)
    senses.perceive(entities, now=0.0)
    share = senses.relations.attention
    assert (share >= 0.0).all()
    assert (share.sum(axis=1) < 1.0).all()
    assert (share.diagonal() == 0.0).all()


def test_attending_begins_above_one_threshold_and_ends_below_a_lower_one(sensing, room):
    """Shares 0.30, 0.45, 0.30, 0.20, 0.30: only the path tells the equal ones apart."""
    senses = Senses(room(), PerceptionModel(), 2)
    attends, began = [], []
    for now, share in enumerate((0.30, 0.45, 0.30, 0.20, 0.30)):
        # At 3 m salience counts half: share = (s / 2) / (0.3 + s / 2).
        salience = 2.0 * 0.3 * share / (1.0 - share)
        relations = sensing(
            [(1.0, 2.5), (4.0, 2.5)],
            senses=senses,
            salience=[1.0, salience],
            now=float(now),
        )
        assert relations.attention[0, 1] == pytest.approx(share)
        attends.append(bool(relations.attends[0, 1]))
        began.append(relations.attention_began[0, 1])
    assert attends == [False, True, True, False, False]
    np.testing.assert_array_equal(began, [np.nan, 1.0, 1.0, np.nan, np.nan])


def test_a_new_episode_has_forgotten_who_attended(sensing, room):
    senses = Senses(room(), PerceptionModel(), 2)
    relations = sensing([(1.0, 2.5), (2.0, 2.5)], senses=senses, now=5.0)
    assert relations.attends.any()
    senses.forget()
    assert not relations.attends.any()
    assert not relations.sees.any()
    assert np.isnan(relations.attention_began).all()


def test_a_person_who_faces_the_robot_attends_to_it(household_of):
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
