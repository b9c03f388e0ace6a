"""A diary tells what happens in a household, as the household itself tells it."""

import numpy as np
import pytest

from experiments.validation.delays import reaction
from experiments.validation.diary import live
from experiments.validation.teaching import MIXED, lesson


@pytest.fixture(scope="module")
def told():
    return lesson("paper_actor", MIXED, 0)


def test_every_touch_answers_a_judgement_of_the_same_bout(told):
    thought = {(one.bout, one.time) for one in told.judgements}
    assert len(told.touches) > 50
    assert {(one.bout, one.judged) for one in told.touches} <= thought


def test_a_reaction_comes_after_its_judgement_and_not_after_its_touch(told):
    for touch in told.touches:
        delay = reaction(told, touch)
        assert delay is None or 0.0 <= delay <= touch.time - touch.judged


def test_each_bout_of_a_lesson_is_judged_at_most_once(told):
    bouts = [one.bout for one in told.judgements]
    assert len(bouts) == len(set(bouts))
    assert {abs(one.value) for one in told.judgements} <= {0.5, 1.0}


def test_a_diary_has_a_row_for_each_moment(household_of):
    told = live(household_of(max_cycles=7), (0.5, 0.5), seed=1)
    assert told.time.tolist() == list(map(float, range(8)))
    assert told.position.shape == (8, 2, 2)
    assert told.people == 1
    assert not told.moved(0).any()
    assert np.isfinite(told.gaze).all()
