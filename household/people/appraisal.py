"""Appraisal: what a person privately thinks of what a robot does.

A person judges each bout of behavior once, when it first sees or hears it well
enough: its preference times how strongly it perceived the bout.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled
from household.people.feedback import Cause

Array = NDArray[np.float64]


AUDIBLE = 40.0
"""Level at the ear from which a sound is noticed [dB]: a quiet room."""

FULL = 70.0
"""Level at the ear from which a sound counts fully [dB]: a loud voice close by."""

SEEN_FULLY = 0.5
"""Share of the attention from which a sight counts fully."""


@dataclass(frozen=True, slots=True)
class Judgement:
    """What a person thinks of one bout.

    Attributes:
        robot: Index of the robot that the person believes it was.
        value: The appraisal, in [-1, 1].
        attending: Whether the person attended to that robot.
        cause: The bout itself; travels along unread, for evaluation.
    """

    robot: int
    value: float
    attending: bool
    cause: Cause


@compiled
def heard_strength(level: Array | float) -> Array:
    """How strongly sounds are heard, in [0, 1].

    Args:
        level: At the ear [dB], any shape.
    """
    return np.minimum(np.maximum((level - AUDIBLE) / (FULL - AUDIBLE), 0.0), 1.0)


@compiled
def seen_strength(attention: Array | float) -> Array:
    """How strongly things are seen, in [0, 1].

    Args:
        attention: Share of the attention that they get, any shape.
    """
    return np.minimum(np.maximum(attention / SEEN_FULLY, 0.0), 1.0)


@compiled
def appraisals(
    preferences: Array,
    activity: NDArray[np.int_],
    doing: NDArray[np.intp],
    attends: NDArray[np.bool_],
    attention: Array,
    level: Array,
    hears_from: Array,
) -> Array:
    """What everybody thinks of what each robot does: preference x how well perceived.

    Args:
        preferences: Shape (n_people, n_activities, 2, n_behaviors), in [-1, 1].
        activity: What each person does, shape (n_people,).
        doing: Index of each robot's behavior, -1 for none, shape (n_robots,).
        attends: Who attends to which robot, shape (n_people, n_robots).
        attention: How much, shape (n_people, n_robots).
        level: How loud each person hears each robot, (n_people, n_robots) [dB].
        hears_from: Level from which each person hears at all, (n_people,) [dB].

    Returns:
        Shape (n_people, n_robots), in [-1, 1]; 0 for what is not perceived.
    """
    value = np.zeros(attention.shape)
    for i in range(len(activity)):
        for r in range(len(doing)):
            if doing[r] >= 0:
                loud = level[i, r] if level[i, r] >= hears_from[i] else 0.0
                seen, heard = seen_strength(attention[i, r]), heard_strength(loud)
                looks = int(attends[i, r])
                liked = preferences[i, activity[i], looks, doing[r]]
                value[i, r] = max(seen, heard) * liked
    return value


def moved_mood(mood: float, appraisal: float, change: float) -> float:
    """The mood after an appraisal: a step towards the appraisal's end of the scale.

    Args:
        mood: In [-1, 1].
        appraisal: In [-1, 1]; 0 moves nothing.
        change: Share of the way for an appraisal of 1 or -1.
    """
    end = 1.0 if appraisal > 0 else -1.0
    return mood + change * abs(appraisal) * (end - mood)


def opinion(pleased: float, annoyed: float) -> int:
    """A questionnaire answer from 1, autistic, to 10, sociable (paper, 4.1).

    Args:
        pleased: Sum of the positive appraisals lived through.
        annoyed: Sum of the negative ones, as a positive number.

    Returns:
        The pleased share of all, on a scale of 1 to 10. Two neutral appraisals of
        each kind stand at the beginning, so that hardly any experience answers 5.
    """
    share = (pleased + 1.0) / (pleased + annoyed + 2.0)
    return 1 + min(9, int(share * 9 + 0.5))
