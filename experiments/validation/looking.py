"""Where people look: how often heads turn, how far, how fast; how long eyes meet."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np

from experiments.analysis.statistics import FloatArray
from experiments.validation.diary import Diary
from experiments.validation.figures import Published, around

HEADS = "bioRxiv 2025.04.29.650670 (n = 24, 7 days)"

SLOWEST = 5.0
"""A head that turns more slowly is at rest [degrees/s] (our choice)."""

LEAST = 20.0
"""A turn goes at least that far [degrees] (our choice; the source's is not known)."""

TRUNK = 10.0
"""A trunk that turned farther than this took part [degrees] (our choice)."""

FACING = 15.0
"""A head that points so near to somebody faces them [degrees] (our choice)."""

TURNS = Published(
    name="head turns",
    unit="1/min",
    said="5.2",
    **around(5.2),
    source=HEADS,
    reading="Of people who stand with open eyes; a turn goes at least 20 degrees in "
    "one direction.",
    because="Gaze goes from one thing to the next after 4 s in the mean, to robots as "
    "often as to people; there are no smaller movements of eyes alone.",
)
ANGLE = Published(
    name="angle of a head turn",
    unit="degrees",
    said="58",
    **around(58.0),
    source=HEADS,
    reading="Mean.",
    because="Heads point straight at what is looked at, without the eyes' share.",
)
PEAK = Published(
    name="peak speed of a head turn",
    unit="degrees/s",
    said="104 +- 12",
    low=92.0,
    high=116.0,
    source=HEADS,
    reading="Mean over turns of the highest speed, with decisions every .1 s.",
    because="Heads turn at one speed, 180 degrees/s for most personas.",
)
ALONE = Published(
    name="head turns without the trunk",
    unit="share",
    said=".72",
    **around(0.72),
    source=HEADS,
    reading="The trunk turned less than 10 degrees meanwhile.",
)
MUTUAL = Published(
    name="length of mutual gaze",
    unit="s",
    said="3.3 +- .7",
    low=2.6,
    high=4.0,
    source="a study of 498 people",
    reading="Two people who see each other point their heads within 15 degrees of one "
    "another; mean over stretches.",
    because="Two gazes meet by chance, and nobody holds one because it is returned.",
)


@dataclass(frozen=True, slots=True)
class Turn:
    """A turn of a head in one direction.

    Attributes:
        angle: How far the head turned [degrees].
        trunk: How far the trunk turned meanwhile [degrees].
        peak: The highest speed [degrees/s].
    """

    angle: float
    trunk: float
    peak: float


def turns(diary: Diary, i: int) -> list[Turn]:
    """Returns the head turns of a person while it stands with open eyes."""
    head, trunk = _steps(diary.gaze[:, i]), _steps(diary.heading[:, i])
    turning = still(diary, i) & (np.abs(head) > SLOWEST * diary.period)
    way = np.where(turning, np.sign(head), 0.0)
    ends = np.flatnonzero(np.diff(way, prepend=0.0, append=0.0))
    found = []
    for start, end in pairwise(ends):
        angle = abs(head[start:end].sum())
        if way[start] != 0.0 and angle >= LEAST:
            peak = np.abs(head[start:end]).max() / diary.period
            turned = abs(trunk[start:end].sum())
            found.append(Turn(float(angle), float(turned), float(peak)))
    return found


def still(diary: Diary, i: int) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """Whether a person stands with open eyes from each moment to the next, (t - 1,)."""
    awake = diary.eyes_open[:, i]
    return np.asarray(~diary.moved(i) & awake[:-1] & awake[1:])


def mutual_gazes(diary: Diary) -> list[float]:
    """Returns how long each mutual gaze lasts [s], but those that the end cuts off."""
    found = []
    for i, j in combinations(range(diary.people), 2):
        meet = _faces(diary, i, j) & _faces(diary, j, i)
        edges = np.flatnonzero(np.diff(meet.astype(int), prepend=0))
        begun, ended = edges[::2], edges[1::2]
        lengths = (ended - begun[: len(ended)]) * diary.period
        found += lengths.tolist()
    return found


def _faces(
    diary: Diary, i: int, j: int
) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """Whether a person faces another one and sees it, at each moment."""
    way = diary.position[:, j] - diary.position[:, i]
    off = _wrapped(np.degrees(np.arctan2(way[:, 1], way[:, 0]) - diary.gaze[:, i]))
    sees = diary.eyes_open[:, i] & (diary.attention[:, i, j] > 0.0)
    return np.asarray(sees & (np.abs(off) <= FACING))


def _steps(angle: FloatArray) -> FloatArray:
    """Turns from moment to moment [degrees]."""
    return _wrapped(np.degrees(np.diff(angle)))


def _wrapped(degrees: FloatArray) -> FloatArray:
    return (degrees + 180.0) % 360.0 - 180.0


def looks(diary: Diary) -> dict[str, float]:
    """What an episode says about where people look."""
    everyone = range(diary.people)
    seen = [turn for i in everyone for turn in turns(diary, i)]
    minutes = sum(still(diary, i).sum() for i in everyone) * diary.period / 60.0
    alone = [turn.trunk < TRUNK for turn in seen]
    return {
        TURNS.name: len(seen) / minutes if minutes else np.nan,
        ANGLE.name: _mean([turn.angle for turn in seen]),
        PEAK.name: _mean([turn.peak for turn in seen]),
        ALONE.name: _mean(alone),
        MUTUAL.name: _mean(mutual_gazes(diary)),
    }


def _mean(values: list[float] | list[bool]) -> float:
    return float(np.mean(values)) if values else np.nan
