"""Delays are measured from judgements to what can be seen of a reaction."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.validation import delays
from experiments.validation.diary import Given


def touch(judged, time, strength=1.0, person=0):
    return Given(
        person=person,
        robot=0,
        bout=0,
        judged=judged,
        time=time,
        kind="caress",
        strength=strength,
    )


@pytest.fixture
def walks(diary):
    """Makes a diary in which the first person walks between some moments."""

    def make(begins, ends):
        position = diary().position.copy()
        steps = np.clip(np.arange(10.0) - begins, 0.0, ends - begins)
        position[:, 0, 0] += steps
        return diary(position=position)

    return make


def test_who_stands_reacts_by_touching(diary):
    assert delays.reaction(diary(), touch(2.0, 3.4)) == pytest.approx(1.4)


def test_who_has_to_walk_reacts_by_setting_out(walks):
    assert delays.reaction(walks(3, 6), touch(2.0, 6.2)) == pytest.approx(1.0)
    assert delays.reaction(walks(2, 6), touch(2.0, 6.2)) == pytest.approx(0.0)


def test_a_walk_that_begins_after_the_touch_is_none_of_the_reaction(walks):
    assert delays.reaction(walks(5, 8), touch(2.0, 2.2)) == pytest.approx(0.2)


def test_of_who_walks_already_nothing_new_can_be_seen(walks):
    assert delays.reaction(walks(1, 6), touch(2.0, 6.2)) is None


def test_a_lesson_is_summed_up_in_five_figures(diary):
    # The first three in the first third, the last three in the last one.
    early = [touch(0.0, 1.0), touch(1.0, 2.0), touch(2.0, 4.0, 0.5)]
    late = [touch(6.0, 6.5), touch(7.0, 7.5), touch(8.0, 13.0, 0.5)]
    told = delays.lesson_delays(diary(touches=[*early, *late]))
    times = np.array([1.0, 1.0, 2.0, 0.5, 0.5, 5.0])
    assert told == pytest.approx(
        {
            delays.MEDIAN.name: 1.0,
            delays.SPREAD.name: np.log(times).std(),
            delays.WINDOW.name: 5 / 6,
            delays.STRENGTH.name: 0.75 / 3.5,  # (1 + 1 + .5 + .5) / 4, (2 + 5) / 2
            delays.DECLINE.name: 2.0 / (4.0 / 3.0),
        }
    )


def test_at_home_the_walk_counts_for_the_touch_but_not_for_the_reaction(walks):
    both = (touch(2.0, 8.5), touch(2.0, 2.2, person=1))
    told = delays.home_delays(replace(walks(3, 9), touches=both))
    assert told[delays.MEDIAN.name] == pytest.approx(0.6)
    assert told[delays.TOUCH.name] == pytest.approx(0.5)


def test_where_nobody_was_touched_nothing_is_known(diary):
    told = delays.lesson_delays(diary())
    assert all(np.isnan(value) for value in told.values())
