"""Praise, silence and mistakes are counted by touches and by judgements."""

import numpy as np
import pytest

from experiments.validation import kinds
from experiments.validation.diary import Given, Judgement


def judged(bout, value):
    return Judgement(person=0, robot=0, bout=bout, time=float(bout), value=value)


def given(bout, kind, strength=1.0):
    return Given(
        person=0,
        robot=0,
        bout=bout,
        judged=float(bout),
        time=bout + 0.2,
        kind=kind,
        strength=strength,
    )


@pytest.fixture
def told(diary):
    """Nine judgements; six are answered, one of them wrongly."""
    values = [1.0, 1.0, -1.0, 0.5, -0.5, 1.0, -1.0, 1.0, -1.0]
    touches = [
        *(given(0, "caress"), given(1, "caress"), given(2, "tap", 0.5)),
        given(5, "tap", 0.5),
        *(given(6, "tap"), given(7, "caress")),
    ]
    judgements = [judged(bout, value) for bout, value in enumerate(values)]
    return diary(touches=touches, judgements=judgements)


def test_praise_is_the_share_of_caresses(told):
    assert kinds.praise(told) == pytest.approx(3 / 6)
    assert kinds.praise_to_taps(told) == pytest.approx(3 / 3)


def test_silence_is_what_remains_unanswered(told):
    assert kinds.silence(told) == pytest.approx(3 / 9)


def test_a_mistake_is_a_touch_against_the_judgement(told):
    assert kinds.mistakes(told) == pytest.approx(1 / 6)


def test_praise_and_strong_taps_are_compared_from_third_to_third(told):
    # The episode lasts 9 s; at 0, 1 and 2 s, then at 5, then at 6 and 7 s.
    assert kinds.praise_left(told) == pytest.approx(1 / 2)
    assert kinds.strong_taps_gained(told) == pytest.approx(1 / 2)


def test_without_touches_only_silence_is_known(diary):
    silent = diary(judgements=[judged(0, 1.0)])
    assert kinds.silence(silent) == 1.0
    assert np.isnan(kinds.praise(silent))
    assert np.isnan(kinds.praise_to_taps(silent))
    assert np.isnan(kinds.praise_left(silent))


def test_a_punisher_never_praises_and_a_silent_teacher_hardly_speaks():
    punisher = kinds.watch("punisher", 0)
    assert punisher[kinds.PRAISE_GOOD.name] == 0.0
    assert kinds.watch("silent", 0)[kinds.SILENCE.name] > 0.8
    assert punisher[kinds.SILENCE.name] < 0.8
