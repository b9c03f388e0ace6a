"""How long people take to react, and how that goes with strength and with time."""

from __future__ import annotations

import numpy as np

from experiments.analysis.statistics import FloatArray
from experiments.validation.diary import Diary, Given
from experiments.validation.figures import Published, around
from experiments.validation.scenes import Measured, Scene
from experiments.validation.teaching import MIXED, lesson

CHARM = "CHARM (arXiv 2506.13079), 46 people; computed from its data"

STRONG = 0.75
"""A touch of at least this strength counts as a strong one."""

MEDIAN = Published(
    name="delay of a reaction, median",
    unit="s",
    said="1.01 (medians of persons .59 to 2.37)",
    low=0.59,
    high=2.37,
    source=CHARM,
    reading="From a judgement to the first thing that can be seen: a walk that begins, "
    "or the touch. There a robot waited for the rating.",
)
SPREAD = Published(
    name="delay of a reaction, spread of its logarithm",
    unit="1",
    said=".62 (log-normal)",
    **around(0.62),
    source=CHARM,
    reading="Standard deviation of the logarithm within one person.",
)
WINDOW = Published(
    name="reactions within .2 to 4 s",
    unit="share",
    said=".98",
    low=0.95,
    source=f"{CHARM}; windows of Deep TAMER and CREW",
    reading="The same delays; a touch at .2 s counts as within.",
)
STRENGTH = Published(
    name="delay of strong by that of weak touches",
    unit="ratio",
    said=".63 (.75 s by 1.2 s)",
    **around(0.63),
    source=CHARM,
    reading="Means, which keep the ratio where both are log-normal with one spread: "
    "people decide once a second, so medians are coarse. Strong: at least .75.",
)
DECLINE = Published(
    name="delay at the end by that at the beginning",
    unit="ratio",
    said=".69 (.87 s by 1.27 s)",
    **around(0.87 / 1.27),
    source=CHARM,
    reading="Means of the last and the first third of a lesson.",
    because="Nobody becomes quicker in a lesson.",
)
TOUCH = Published(
    name="touches within .2 to 4 s of the judgement",
    unit="share",
    said=".98",
    low=0.95,
    source=f"{CHARM}; windows of Deep TAMER and CREW",
    reading="From a judgement to the touch itself. At home people have to walk, which "
    "those who were asked for ratings had not.",
    because="Walks through an apartment take longer than that.",
)


def reaction(diary: Diary, touch: Given) -> float | None:
    """Returns how long it took until a giver was seen to react [s].

    Args:
        diary: In which the touch happened.
        touch: Which.

    Returns:
        From its judgement to the beginning of its walk, or to the touch if it did not
        walk; None if it walked already when it judged, so that nothing was to be seen.
    """
    walks = diary.moved(touch.person)
    judged = int(np.searchsorted(diary.time, touch.judged + 1e-9)) - 1
    if judged > 0 and walks[judged - 1]:
        return None
    began = diary.time[:-1][judged:][walks[judged:]]
    first = float(began[0]) if len(began) else touch.time
    return min(first, touch.time) - touch.judged


def lesson_delays(diary: Diary) -> Measured:
    """What a lesson says about delays."""
    seen = [(reaction(diary, one), one) for one in diary.touches]
    known = [(delay, one) for delay, one in seen if delay is not None]
    delays = np.array([delay for delay, _ in known])
    strong = np.array([one.strength >= STRONG for _, one in known], dtype=bool)
    end = float(diary.time[-1])
    third = np.array([int(3 * one.judged / end) for _, one in known], dtype=int)
    positive = delays[delays > 0.0]
    return {
        MEDIAN.name: _median(delays),
        SPREAD.name: float(np.log(positive).std()) if len(positive) else np.nan,
        WINDOW.name: _within(delays),
        STRENGTH.name: _ratio(_mean(delays[strong]), _mean(delays[~strong])),
        DECLINE.name: _ratio(_mean(delays[third >= 2]), _mean(delays[third == 0])),
    }


def home_delays(diary: Diary) -> Measured:
    """What an episode at home says about delays."""
    reactions = [reaction(diary, one) for one in diary.touches]
    delays = np.array([delay for delay in reactions if delay is not None])
    touches = np.array([one.time - one.judged for one in diary.touches])
    return {MEDIAN.name: _median(delays), TOUCH.name: _within(touches)}


def _within(delays: FloatArray) -> float:
    """Share of delays in the credit windows that are in use."""
    if not len(delays):
        return np.nan
    inside = np.less_equal(0.2 - 1e-9, delays) & np.less_equal(delays, 4.0)
    return float(inside.mean())


def _ratio(part: float, whole: float) -> float:
    return part / whole if whole else np.nan


def _median(values: FloatArray) -> float:
    return float(np.median(values)) if len(values) else np.nan


def _mean(values: FloatArray) -> float:
    return float(values.mean()) if len(values) else np.nan


def _lesson(seed: int) -> Measured:
    return lesson_delays(lesson("praising", MIXED, seed))


SCENES = (
    Scene(
        name="a lesson, praising teacher",
        watch=_lesson,
        published=(MEDIAN, SPREAD, WINDOW, STRENGTH, DECLINE),
        seeds=30,
    ),
)
