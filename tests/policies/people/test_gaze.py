"""Gaze: what is heard and how time passes -> whom to look at."""

import itertools
import math

import numpy as np
import pytest

from household.compiled.arrays import NOBODY
from household.people.mind import OWN_ACTIVITY
from household.scenario.persona import Persona
from policies.people.gaze import Aims, Gaze

ROBOTS = (2, 3)
QUIET = np.zeros(4)
LIVES = 1500


def turned(gaze, percepts):
    """Where people look who have no reason to look anywhere."""
    gaze.turn(percepts, no_aims(len(gaze.look)))
    return gaze.look


def no_aims(n):
    return Aims(np.full(n, OWN_ACTIVITY), np.full(n, NOBODY))


@pytest.fixture
def gaze(percepts):
    """Makes somebody who looks around; gives where it looks, second by second."""

    def make(seed=0, myself=0, n_people=2, **traits):
        usual = {"robot_interest": 0.0, "people_interest": 0.0, "reflex": 0.0}
        persona = Persona(name="test", **(usual | traits))
        rngs = [np.random.default_rng((seed, i)) for i in range(n_people)]
        habits = Gaze([persona] * n_people, rngs)

        def look(levels):
            # Of all moments the same records, as in a household.
            seen, aims, looks = percepts(n_people), no_aims(n_people), []
            for level in levels:
                seen.surroundings.level[:] = level
                habits.turn(seen, aims)
                looks.append(int(habits.look[myself]))
            return looks

        return look

    return make


def heard(robot, level):
    levels = np.zeros(4)
    levels[robot] = level
    return levels


@pytest.fixture
def first_looks(percepts):
    """Makes many people of one kind; gives where each looks in its very first moment.

    The first `LIVES` numbers are theirs, the last two those of robots, of which the
    second may be heard.
    """

    def look(level=0.0, **traits):
        usual = {"robot_interest": 0.0, "people_interest": 0.0, "reflex": 0.0}
        persona = Persona(name="test", **(usual | traits))
        rngs = [np.random.default_rng(seed) for seed in range(LIVES)]
        levels = np.zeros(LIVES + 2)
        levels[-1] = level
        habits = Gaze([persona] * LIVES, rngs)
        return turned(habits, percepts(LIVES, level=levels))

    return look


def chance(p):
    return pytest.approx(p, abs=4 * math.sqrt(p * (1 - p) / LIVES))


def test_who_takes_no_interest_looks_at_its_own_activity(gaze):
    assert set(gaze()([QUIET] * 100)) == {OWN_ACTIVITY}


def test_who_is_interested_in_robots_alone_looks_at_each_of_them(gaze):
    looks = gaze(robot_interest=1.0, gaze_dwell=1.0)([QUIET] * 400)
    assert set(looks) == set(ROBOTS)


def test_who_is_interested_in_people_looks_at_the_others_and_not_at_itself(gaze):
    assert set(gaze(people_interest=1.0)([QUIET] * 100)) == {1}
    assert set(gaze(people_interest=1.0, myself=1)([QUIET] * 100)) == {0}


def test_interests_are_the_chances_of_each_glance(first_looks):
    looks = first_looks(robot_interest=0.3, people_interest=0.2)
    assert np.mean(looks >= LIVES) == chance(0.3)
    assert np.mean((looks >= 0) & (looks < LIVES)) == chance(0.2)
    assert np.mean(looks == OWN_ACTIVITY) == chance(0.5)


def test_both_robots_are_looked_at_alike(first_looks):
    looks = first_looks(robot_interest=1.0)
    assert np.mean(looks == LIVES) == chance(0.5)
    assert np.mean(looks == LIVES + 1) == chance(0.5)


def test_who_lives_alone_with_a_robot_has_nobody_else_to_look_at(percepts):
    persona = Persona(name="alone", people_interest=1.0, robot_interest=0.0, reflex=0.0)
    habits = Gaze([persona], [np.random.default_rng(0)])
    looks = {int(turned(habits, percepts(1, 1))[0]) for _ in range(50)}
    assert looks == {OWN_ACTIVITY}


def test_a_glance_lasts_its_dwell_time_on_average(gaze):
    """4 s on average; in whole seconds an exponential glance is rounded up.

    The mean of ceil(x) is 1 / (1 - exp(-1/4)), 4.52 s.
    """
    looks = gaze(robot_interest=1.0, gaze_dwell=4.0)([QUIET] * 40_000)
    # Half of the glances go on to the same robot, so that a run is two glances.
    changes = sum(a != b for a, b in itertools.pairwise(looks))
    glances = 2 * changes
    assert 40_000 / glances == pytest.approx(1 / (1 - math.exp(-0.25)), rel=0.06)


def test_a_loud_robot_draws_the_eye(gaze):
    for robot in ROBOTS:
        assert gaze(reflex=1.0)([heard(robot, 70.0)]) == [robot]


@pytest.mark.parametrize(("level", "p"), [(40.0, 0.0), (55.0, 0.4), (70.0, 0.8)])
def test_the_reflex_is_as_strong_as_the_sound(first_looks, level, p):
    assert np.mean(first_looks(level, reflex=0.8) == LIVES + 1) == chance(p)


def test_of_two_robots_the_louder_draws_the_eye(gaze):
    both = np.array([0.0, 0.0, 71.0, 80.0])
    assert gaze(reflex=1.0)([both]) == [3]


def test_people_who_talk_do_not_startle(gaze):
    assert gaze(reflex=1.0)([heard(1, 90.0)]) == [OWN_ACTIVITY]


def test_in_silence_nothing_startles(gaze):
    assert set(gaze(reflex=1.0)([QUIET] * 50)) == {OWN_ACTIVITY}


def test_after_the_noise_the_gaze_rests_for_a_while_and_goes_back(gaze):
    looks = gaze(reflex=1.0, gaze_dwell=3.0)([heard(2, 80.0), *[QUIET] * 60])
    assert looks[0] == 2
    assert looks[-1] == OWN_ACTIVITY
    assert looks == sorted(looks, reverse=True)


def test_the_same_stream_looks_the_same_way(gaze):
    traits = {"robot_interest": 0.4, "people_interest": 0.3, "reflex": 0.5}
    levels = [heard(2, 60.0) if i % 7 == 0 else QUIET for i in range(200)]
    assert gaze(5, **traits)(levels) == gaze(5, **traits)(levels)
    assert gaze(5, **traits)(levels) != gaze(6, **traits)(levels)


def test_a_moving_robot_draws_the_eye_that_sees_it(percepts):
    persona = Persona(
        name="ann", reflex=1.0, robot_interest=0.0, people_interest=0.0, gaze_dwell=1.0
    )
    sees = [False, False, False, True]
    moving = [True, True]

    def looks(**what):
        rngs = [np.random.default_rng(3), np.random.default_rng(4)]
        habits = Gaze([persona] * 2, rngs)
        return {int(turned(habits, percepts(**what))[0]) for _ in range(40)}

    assert looks() == {OWN_ACTIVITY}
    assert looks(moving=moving) == {OWN_ACTIVITY}  # nobody sees them
    assert looks(sees=sees) == {OWN_ACTIVITY}  # they stand still
    assert 3 in looks(sees=sees, moving=moving)
    assert 2 not in looks(sees=sees, moving=moving)  # the one that is not seen


def test_people_look_each_in_its_own_way(percepts):
    """One draws robots alone, one people alone, one nothing but what it does."""
    personas = [
        Persona(name="a", robot_interest=1.0, people_interest=0.0, reflex=0.0),
        Persona(name="b", robot_interest=0.0, people_interest=1.0, reflex=0.0),
        Persona(name="c", robot_interest=0.0, people_interest=0.0, reflex=0.0),
    ]
    rngs = [np.random.default_rng(i) for i in range(3)]
    habits = Gaze(personas, rngs)
    looks = np.array([turned(habits, percepts(3, 2)).copy() for _ in range(200)])
    assert [set(column) for column in looks.T.tolist()] == [{3, 4}, {0, 2}, {-1}]
