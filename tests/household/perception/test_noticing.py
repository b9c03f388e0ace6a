"""Noticing: what robots see of people who come, from where bodies were alone."""

import numpy as np
import pytest

from household.perception.noticing import Noticing
from household.scenario.scenario import PerceptionModel

ROBOT = (5.0, 0.0)


def noticing(late=0.0, noise=0.0, n=2, period=1.0, seed=0):
    model = PerceptionModel(notice_delay=late, notice_noise=noise)
    made = Noticing(model, n, period)
    made.begin([np.random.default_rng([seed, i]) for i in range(n)])
    return made


def seen(path, robot=ROBOT, elapsed=0.5, attends=np.nan, period=1.0, **how):
    """What a robot noticed of a person who touches it.

    Args:
        path: Where the person was at each moment, and where it is as it touches.
        robot: Where the robot is; or where it was at each of these moments.
        elapsed: Time from the last moment to the touch [s].
    """
    robots = np.broadcast_to(np.array(robot, dtype=float), (len(path), 2))
    watching = noticing(period=period, **how)
    for k, (one, other) in enumerate(zip(path[:-1], robots[:-1], strict=True)):
        watching.remember(k, np.array([one, other], dtype=float))
    now = (len(path) - 2) * period + elapsed
    last = np.array([path[-1], robots[-1]], dtype=float)
    return watching.touch(0, 1, last, now, attends)


def along(*xs):
    return [(x, 0.0) for x in xs]


@pytest.mark.parametrize(
    ("path", "came"),
    [
        # It stands until 2 s, then walks over.
        (along(0, 0, 0, 1.2, 2.4, 3.6, 4.2), 2.0),
        (along(0, 1.2, 2.4, 3.6, 4.2), 0.0),
        # It sets out within the very last period.
        (along(3.8, 3.8, 4.2), 1.0),
        # It stands, within reach.
        (along(4.2, 4.2, 4.2), None),
        # It first goes the other way.
        (along(3.0, 2.0, 1.0, 2.2, 3.4, 4.2), 2.0),
        # It stands still on the way for a second.
        (along(0, 1.2, 1.2, 2.4, 3.6, 4.2), 2.0),
        # Others push it a little before it sets out.
        (along(3.0, 3.05, 3.1, 4.2), 2.0),
        # It goes by.
        (along(4.4, 5.6), None),
    ],
)
def test_somebody_comes_since_it_walks_and_gets_nearer(path, came):
    assert seen(path)[0] == came


def test_who_goes_around_a_table_is_seen_coming_while_it_gets_nearer():
    around = [(0.0, 0.0), (0.5, 1.0), (1.5, 1.5), (3.0, 1.5), (4.3, 0.0)]
    assert seen(around)[0] == 0.0


def test_a_robot_that_comes_to_somebody_sees_nobody_come():
    away = [(9.0, 0.0), (8.0, 0.0), (7.0, 0.0), (6.0, 0.0)]
    assert seen([ROBOT] * 4, robot=away)[0] is None


def test_somebody_who_follows_a_robot_comes_since_it_began_to():
    robot = along(2.0, 2.5, 3.0, 3.5, 3.9)
    assert seen(along(0.0, 0.0, 1.2, 2.4, 3.2), robot=robot)[0] == 1.0


def test_what_is_noticed_is_late_but_not_after_the_touch():
    path = along(0, 0, 1.2, 2.4, 3.6, 4.2)
    assert seen(path, late=0.7) == (1.7, None)
    assert seen(path, late=0.7, attends=2.0) == (1.7, 2.7)
    assert seen(path, late=30.0, attends=2.0) == (4.5, 4.5)


def test_what_is_noticed_is_inexact_around_the_delay():
    watching = noticing(late=0.5, noise=0.3)
    for k, x in enumerate((0.0, 0.0, 1.2, 2.4, 3.6)):
        watching.remember(k, np.array([(x, 0.0), ROBOT]))
    last = np.array([(4.2, 0.0), ROBOT])
    noticed = np.array([watching.touch(0, 1, last, 4.5, 1.0) for _ in range(4000)])
    # Both began at 1 s; the errors of one tell nothing of the other's.
    error = 0.3 / np.sqrt(4000)
    assert noticed.mean(axis=0) == pytest.approx([1.5, 1.5], abs=4 * error)
    assert noticed.std(axis=0) == pytest.approx([0.3, 0.3], rel=0.05)
    assert abs(np.corrcoef(noticed.T)[0, 1]) < 4 / np.sqrt(4000)


def test_each_person_is_noticed_with_errors_of_its_own():
    position = np.array([(0.0, 0.0), (0.0, 0.0), ROBOT])
    watching, other = noticing(noise=0.3, n=3), noticing(noise=0.3, n=3)
    other.touch(1, 2, position, 9.0, 5.0)
    first = watching.touch(0, 2, position, 9.0, 5.0)
    assert other.touch(0, 2, position, 9.0, 5.0) == first
    assert other.touch(1, 2, position, 9.0, 5.0) != first


def test_who_comes_from_far_is_seen_as_far_back_as_the_robot_remembers():
    """A walk of 100 s, of which it remembers the last minute."""
    path = [(0.5 * k, 0.0) for k in range(102)]
    assert seen(path, robot=(60.0, 0.0))[0] == 100.0 - 59.0


def test_who_is_slower_than_anybody_walks_does_not_come():
    assert seen(along(0.0, 0.04, 0.08, 0.12, 0.14))[0] is None


def test_shorter_moments_are_told_apart():
    path = along(0, 0, 0.12, 0.24, 0.36, 0.4)
    came, _ = seen(path, robot=(1.0, 0.0), period=0.1, elapsed=0.05)
    assert came == pytest.approx(0.1)
