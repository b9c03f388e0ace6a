import math

import pytest

from learners.errors import ExperienceError

NUMBERS = [math.nan, math.inf, -math.inf]


@pytest.mark.parametrize("value", [*NUMBERS, 1.01, -1.01])
def test_a_touch_has_a_value_between_minus_one_and_one(touch, value):
    with pytest.raises(ExperienceError, match="value"):
        touch(value=value)


@pytest.mark.parametrize("mood", [*NUMBERS, 1.5])
def test_a_mood_lies_between_minus_one_and_one(touch, mood):
    with pytest.raises(ExperienceError, match="mood"):
        touch(mood=mood)


@pytest.mark.parametrize("time", NUMBERS)
def test_times_are_finite(touch, entry, time):
    with pytest.raises(ExperienceError, match="finite"):
        touch(time=time)
    with pytest.raises(ExperienceError, match="finite"):
        entry(time=0.0, next_time=time)


@pytest.mark.parametrize("began", ["approach_began", "attention_began"])
@pytest.mark.parametrize("time", [5.1, math.nan])
def test_nothing_about_a_touch_begins_after_it(touch, began, time):
    with pytest.raises(ExperienceError, match="not before the touch"):
        touch(time=5.0, **{began: time})


def test_an_entry_does_not_end_before_it_begins(entry):
    with pytest.raises(ExperienceError, match="before it began"):
        entry(time=2.0, next_time=1.0)


def test_feedback_does_not_come_from_the_future(entry, touch):
    with pytest.raises(ExperienceError, match="future"):
        entry("s", 0, 0.0, touch(time=1.5))
