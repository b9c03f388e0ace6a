"""What teachers give: how much praise, how much silence, and what becomes of both."""

from __future__ import annotations

from functools import partial

import numpy as np

from experiments.analysis.statistics import FloatArray
from experiments.validation.delays import STRONG
from experiments.validation.diary import Diary
from experiments.validation.figures import Published, around
from experiments.validation.scenes import Measured, Scene
from experiments.validation.teaching import ALWAYS_RIGHT, GOOD, MIXED, lesson

CHARM = "CHARM (arXiv 2506.13079), 46 people"

TEACHERS = (
    *("paper_actor", "praising", "fading"),
    *("mistaken", "skipping", "noisy", "myopic"),
)
"""The populations of teachers that are shipped (docs/people.md)."""

READY = (
    "The chance of a touch is the persona's readiness times the size of the judgement, "
    "so what pleases or annoys half is answered half as often."
)

PRAISE_GOOD = Published(
    name="caresses among touches, good robot",
    unit="share",
    said=".82 (70 % positive, 15 % negative)",
    **around(0.82),
    source=CHARM,
    reading="Of a robot that pleases in 3 of 4 bouts, wholly or half.",
)
PRAISE_POOR = Published(
    name="caresses among touches, poor robot",
    unit="share",
    said=".71 (61 % positive, 25 % negative)",
    **around(0.71),
    source=CHARM,
    reading="Of a robot that pleases in every other bout; how often that of the study "
    "did is not known.",
    because="Teachers other than `praising` tap what annoys as readily as they caress "
    "what pleases, or more so.",
)
RATIO = Published(
    name="caresses for each tap",
    unit="ratio",
    said="1.71 +- 1.23",
    low=0.48,
    high=2.94,
    source="arXiv 2502.05118 (n = 14)",
    reading="Of a robot that pleases in every other bout.",
)
SILENCE = Published(
    name="occasions without a touch",
    unit="share",
    said=".30",
    **around(0.30),
    source="Cederborg et al. 2015 (n = 26)",
    reading="Bouts that the teacher judged beyond its tolerance; half of them wholly, "
    "half of them half pleasing or annoying.",
    because=READY,
)
SKIPS = Published(
    name="occasions skipped",
    unit="share",
    said=".10",
    **around(0.10),
    source="B-Pref (Lee et al. 2021), a simulated teacher",
    reading=SILENCE.reading,
    because=READY,
)
MISTAKES = Published(
    name="touches of the wrong kind",
    unit="share",
    said=".10",
    **around(0.10),
    source="B-Pref (Lee et al. 2021), a simulated teacher",
    reading="Caresses for what annoyed and taps for what pleased.",
)
DOUBTS = Published(
    name="wrong touches for strong feelings",
    unit="share",
    said=".12 = 1 / (1 + exp(2))",
    **around(0.12),
    source="B-Pref (Lee et al. 2021), a simulated teacher of rationality 1",
    reading="Of the touches for what pleased or annoyed nearly fully.",
)
FADES = Published(
    name="praise at the end by that at the beginning",
    unit="ratio",
    said="falls",
    high=0.8,
    source="MacGlashan et al. 2017; Li et al. 2020 (n = 561): much early, then sparse",
    reading="Caresses in the last third of a lesson by those in the first, of a robot "
    "that is always right; no size was published, and a fifth less counts as falling.",
    because="These teachers do not get used to politeness.",
)
STRONG_TAPS = Published(
    name="strong taps at the end, more than at the beginning",
    unit="share",
    said=".16 (from .04 to .20)",
    **around(0.16),
    source=CHARM,
    reading="Share of strong taps among the touches of the last third of a lesson, "
    "less that of the first third.",
    because="Strength is the size of the judgement and does not grow in a lesson.",
)


def praise(diary: Diary) -> float:
    """Share of caresses among touches."""
    return _mean(_caresses(diary))


def praise_to_taps(diary: Diary) -> float:
    """Caresses for each tap."""
    caresses = _caresses(diary)
    taps = len(caresses) - caresses.sum()
    return float(caresses.sum() / taps) if taps else np.nan


def silence(diary: Diary) -> float:
    """Share of judgements that call for a touch and are answered by none."""
    answered = {(one.person, one.robot, one.bout) for one in diary.touches}
    silent = [
        (one.person, one.robot, one.bout) not in answered for one in diary.judgements
    ]
    return _mean(np.array(silent, dtype=float))


def mistakes(diary: Diary, at_least: float = 0.0) -> float:
    """Share of touches whose kind is not that of the judgement they answer.

    Args:
        diary: What was given.
        at_least: Only touches of this strength or more are counted.
    """
    thought = {(one.person, one.robot, one.bout): one.value for one in diary.judgements}
    wrong = [
        (one.kind == "caress") != (thought[one.person, one.robot, one.bout] > 0.0)
        for one in diary.touches
        if one.strength >= at_least
    ]
    return _mean(np.array(wrong, dtype=float))


def praise_left(diary: Diary) -> float:
    """Caresses in the last third of an episode by those in the first."""
    third = _third(diary)[_caresses(diary) > 0.0]
    first, last = (third == 0).sum(), (third == 2).sum()
    return float(last / first) if first else np.nan


def strong_taps_gained(diary: Diary) -> float:
    """Strong taps among the last third of touches, less those among the first."""
    strong = np.array(
        [one.kind == "tap" and one.strength >= STRONG for one in diary.touches],
        dtype=float,
    )
    third = _third(diary)
    return _mean(strong[third == 2]) - _mean(strong[third == 0])


def _caresses(diary: Diary) -> FloatArray:
    return np.array([one.kind == "caress" for one in diary.touches], dtype=float)


def _third(diary: Diary) -> FloatArray:
    """In which third of the episode each touch was, from 0."""
    when = np.array([one.time for one in diary.touches])
    return np.minimum(np.floor(3.0 * when / diary.time[-1]), 2.0)


def _mean(values: FloatArray) -> float:
    return float(values.mean()) if len(values) else np.nan


def watch(teacher: str, seed: int) -> Measured:
    """Watches one teacher in three lessons: a good, a poor and a perfect robot."""
    good = lesson(teacher, GOOD, seed)
    poor = lesson(teacher, MIXED, seed)
    perfect = lesson(teacher, ALWAYS_RIGHT, seed)
    return {
        PRAISE_GOOD.name: praise(good),
        PRAISE_POOR.name: praise(poor),
        RATIO.name: praise_to_taps(poor),
        SILENCE.name: silence(poor),
        SKIPS.name: silence(poor),
        MISTAKES.name: mistakes(poor),
        DOUBTS.name: mistakes(poor, STRONG),
        FADES.name: praise_left(perfect),
        STRONG_TAPS.name: strong_taps_gained(poor),
    }


USUAL = (PRAISE_GOOD, PRAISE_POOR, RATIO, SILENCE, FADES, STRONG_TAPS)
"""What every teacher is held against."""

OWN = {"mistaken": (MISTAKES,), "skipping": (SKIPS,), "noisy": (DOUBTS,)}
"""What a simulated teacher of the field is held against beside that."""

SCENES = tuple(
    Scene(
        name=f"lessons, {teacher}",
        watch=partial(watch, teacher),
        published=(*USUAL, *OWN.get(teacher, ())),
        seeds=20,
    )
    for teacher in TEACHERS
)

NOT_MODELED = (
    Published(
        name="touches of a user in 5 months",
        unit="1",
        said="12.5 (3,171 of 254 users)",
        source="Isbell et al. 2001",
        reading="Months are not simulated: a touch follows from what a person has just "
        "seen, and the wish to touch does not fade over weeks.",
    ),
    Published(
        name="caresses for each tap, cute robot",
        unit="ratio",
        said="2.65 +- 2.26",
        source="arXiv 2502.05118 (n = 14)",
        reading="Robots have no looks.",
    ),
    Published(
        name="neutral ratings",
        unit="share",
        said=".15",
        source=CHARM,
        reading="A touch is a caress or a tap; there is no neutral one beside silence.",
    ),
)
