"""Speeds and distances are measured from where bodies are."""

import numpy as np
import pytest

from experiments.validation.diary import Given
from experiments.validation.moving import approaches, stroll, walking_speed


@pytest.fixture
def walker(diary):
    """The first person walks to the robot at (2, 2), for 4 s, and touches it."""
    position = diary().position.copy()
    path = np.interp(np.arange(10.0), [2.0, 6.0], [0.0, 1.2])
    position[:, 0] = np.stack([path, path], axis=1)
    touch = Given(0, 0, 0, 1.0, 5.8, "tap", 1.0)
    return diary(position=position, touches=[touch])


def test_the_speed_is_that_in_the_middle_of_a_walk(walker):
    assert walking_speed(walker, 0) == pytest.approx(0.3 * np.sqrt(2.0))
    assert np.isnan(walking_speed(walker, 1))


def test_the_gap_is_from_body_to_body(walker):
    assert approaches(walker) == [pytest.approx(0.8 * np.sqrt(2.0) - 0.25 - 0.15)]


def test_who_stood_at_hand_did_not_approach(diary):
    assert approaches(diary(touches=[Given(0, 0, 0, 1.0, 1.2, "tap", 1.0)])) == []


def test_an_elder_walks_slower_than_a_child():
    (elder,), (child,) = stroll("elder", 0).values(), stroll("child", 0).values()
    assert 0.5 < elder < 0.71
    assert 1.2 < child < 1.51
