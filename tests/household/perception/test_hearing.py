"""What is heard where: numbers by hand."""

import math

import numpy as np
import pytest

from household import household_v0
from household.home.floorplan import Door, FloorPlan, Region, Wall
from household.perception.hearing import Acoustics, attenuate
from household.perception.obstruction import (
    Barriers,
    Obstructions,
    update_obstructions,
)
from household.perception.relations import Entities
from household.perception.senses import Senses
from household.scenario.scenario import (
    PerceptionModel,
    PersonSpec,
    RobotSpec,
    ScriptStep,
)

NO_WALLS = np.zeros((0, 4))


def loss_between(one, other, walls=NO_WALLS, wall_loss=25.0):
    return losses([one, other], walls, wall_loss)[0, 1]


def losses(position, walls=NO_WALLS, wall_loss=25.0, silent=0):
    """What sounds lose between each two who have just come there."""
    n = len(position)
    columns = np.ascontiguousarray(np.array(walls, dtype=float).T)
    barriers = Barriers(walls=columns, tall=np.zeros((4, 0)))
    obstructions = Obstructions(
        position=np.full((n, 2), np.nan),
        moved=np.zeros(n, dtype=bool),
        crossed=np.zeros((n, n), dtype=np.int64),
        hidden=np.zeros((n, n), dtype=bool),
    )
    loss = np.full((n, n), np.inf)
    update_obstructions(obstructions, barriers, np.array(position, dtype=float))
    attenuate(obstructions, Acoustics(wall_loss, silent), loss)
    return loss


def test_a_sound_is_given_as_it_is_at_one_meter():
    assert loss_between((2.0, 2.0), (3.0, 2.0)) == pytest.approx(0.0)


@pytest.mark.parametrize(("meters", "loss"), [(2, 6.02), (4, 12.04), (8, 18.06)])
def test_a_sound_loses_six_decibels_with_each_doubling_of_the_distance(meters, loss):
    assert loss_between((0.0, 0.0), (0.0, meters)) == pytest.approx(loss, abs=0.005)


def test_a_sound_gets_no_louder_nearer_than_a_hand():
    touching, near = (loss_between((0.0, 0.0), (0.0, d)) for d in (0.01, 0.3))
    assert touching == near == pytest.approx(20.0 * math.log10(0.3))


@pytest.mark.parametrize("n", [0, 1, 2, 3])
def test_every_wall_in_between_takes_as_much_again(n):
    walls = [(1.0 + i, -1.0, 1.0 + i, 1.0) for i in range(3)][:n] or NO_WALLS
    loss = loss_between((0.0, 0.0), (4.0, 0.0), walls, wall_loss=30.0)
    assert loss == pytest.approx(12.0412 + 30.0 * n, abs=1e-3)


def test_loss_is_the_same_in_both_directions_and_no_ear_is_its_own_source():
    loss = losses([(0.0, 0.0), (3.0, 1.0), (7.0, 2.0)])
    np.testing.assert_array_equal(loss, loss.T)
    assert np.isinf(loss.diagonal()).all()
    assert np.isfinite(loss).sum() == 6


def test_nothing_is_worked_out_between_those_who_make_no_sound():
    """Two silent ones, then one that is heard by both and hears them."""
    loss = losses([(0.0, 0.0), (3.0, 1.0), (7.0, 2.0)], silent=2)
    finite = [[False, False, True], [False, False, True], [True, True, False]]
    assert np.isfinite(loss).tolist() == finite


def test_what_is_heard_is_the_source_less_the_loss_and_never_below_silence(room):
    plan = room(walls=((4.0, 0.0, 4.0, 4.0),))
    senses = Senses(plan, PerceptionModel(wall_loss=25.0), 2)
    levels = {}
    for source in (85.0, 30.0):
        entities = Entities(
            position=np.array([[2.0, 2.0], [6.0, 2.0]]),
            gaze=np.zeros(2),
            half_view=np.full(2, -1.0),
            salience=np.ones(2),
            absorption=np.ones(2),
            source=np.array([0.0, source]),
        )
        senses.perceive(entities, now=0.0)
        levels[source] = senses.relations.level[0].tolist()
    # 4 m and a wall: 12.04 + 25 dB; who is asleep hears all the same.
    assert levels[85.0] == pytest.approx([0.0, 47.96], abs=0.005)
    assert levels[30.0] == [0.0, 0.0]


@pytest.fixture(scope="module")
def three_rooms():
    """Rooms of 4 m x 4 m in a row; the doors are off the line from bed to bed."""
    outer = ((0, 0, 12, 0), (12, 0, 12, 4), (12, 4, 0, 4), (0, 4, 0, 0))
    inner = ((4, 0, 4, 2.8), (4, 3.8, 4, 4), (8, 0, 8, 2.8), (8, 3.8, 8, 4))
    return FloorPlan(
        name="three_rooms",
        walls=tuple(
            Wall(start=(x1, y1), end=(x2, y2)) for x1, y1, x2, y2 in (*outer, *inner)
        ),
        doors=tuple(Door(start=(x, 2.8), end=(x, 3.8)) for x in (4.0, 8.0)),
        regions=(
            Region(
                name="bed", activity="sleeping", center=(2.0, 1.0), facing=(0.0, 1.0)
            ),
        ),
    )


@pytest.mark.parametrize(
    ("robot", "wakes"),
    [((3.0, 2.5), True), ((6.0, 1.0), True), ((10.0, 1.0), False)],
    ids=["beside", "next door", "farthest room"],
)
def test_a_bark_next_door_wakes_a_light_sleeper_and_in_the_farthest_room_not(
    household_of, three_rooms, robot, wakes
):
    sleeper = PersonSpec(
        name="ann",
        persona="light_sleeper",
        script=(ScriptStep(place="bed", duration=(900.0, 900.0)),),
    )
    scenario = household_of(
        home=three_rooms, people=(sleeper,), robots=(RobotSpec(position=robot),)
    )
    env = household_v0.parallel_env(scenario)
    env.reset(seed=1)
    for _ in range(5):
        env.step({"robot_0": 1})
    assert not env.simulation.people.appearance.eyes_open[0]
    env.step({"robot_0": 0})
    # 85 dB less 12.04 and 25 next door: 48; less 18.06 and 50 in the farthest: 17.
    assert env.simulation.people.appearance.eyes_open[0] == wakes


def test_a_sound_sleeper_sleeps_on_where_a_light_one_wakes(household_of, three_rooms):
    awake = {}
    for persona in ("light_sleeper", "paper_actor"):
        sleeper = PersonSpec(
            name="ann",
            persona=persona,
            script=(ScriptStep(place="bed", duration=(900.0, 900.0)),),
        )
        env = household_v0.parallel_env(
            household_of(
                home=three_rooms,
                people=(sleeper,),
                robots=(RobotSpec(position=(6.0, 1.0)),),
            )
        )
        env.reset(seed=1)
        for behavior in (1, 1, 1, 0):
            env.step({"robot_0": behavior})
        awake[persona] = env.simulation.people.appearance.eyes_open[0]
    assert awake == {"light_sleeper": True, "paper_actor": False}


def test_a_robot_that_is_done_is_silent(household_of):
    """A bark takes 2 s; the third second is quiet unless the robot barks again."""
    # Without norms nobody minds the noise and walks over.
    env = household_v0.parallel_env(household_of(norms={}))
    env.reset(seed=1)
    heard = []
    for action in ({"robot_0": 0}, {}, {}, {}):
        env.step(action)
        heard.append(float(env.simulation.senses.relations.level[0, 1]))
    # The robot is 5 m away: 85 - 13.98 dB.
    assert heard == pytest.approx([71.02, 71.02, 0.0, 0.0], abs=0.01)
