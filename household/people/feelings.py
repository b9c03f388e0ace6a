"""Feelings: what appraisals leave behind in people, their moods and their opinions."""

import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Zeros, new_zeros
from household.compiled.jit import compiled
from household.people.mind import Appraisals
from household.people.traits import Traits
from household.scenario.persona import Persona


class Feelings(NamedTuple):
    """What everybody keeps to itself.

    Attributes:
        mood: In [-1, 1], shape (n_people,); robots perceive it with noise.
        pleased: Sum of the positive appraisals of each robot by each person, shape
            (n_people, n_robots).
        annoyed: Sum of the negative ones, as positive numbers, (n_people, n_robots).
        fading: What is left of each mood after a decision period, shape (n_people,).
    """

    mood: Annotated[Floats, "n_people"]
    pleased: Annotated[Floats, "n_people", "n_robots"]
    annoyed: Annotated[Floats, "n_people", "n_robots"]
    fading: Annotated[Floats, "n_people"]

    def forget(self) -> None:
        """Begins a new episode."""
        for felt in (self.mood, self.pleased, self.annoyed):
            felt[:] = 0.0

    def opinion(self, person: int, robot: int) -> int:
        """A questionnaire answer on a robot, from 1 to 10 (paper, section 4.1)."""
        return opinion(self.pleased[person, robot], self.annoyed[person, robot])


def feelings_of(
    personas: Sequence[Persona],
    n_robots: int,
    period: float,
    zeros: Zeros = new_zeros,
) -> Feelings:
    """The feelings of people who have lived through nothing yet.

    Args:
        personas: What kind of person each is.
        n_robots: How many robots there are.
        period: Between two decisions [s].
        zeros: Makes ``mood``, which is recorded.
    """
    return Feelings(
        mood=zeros("mood", (len(personas),)),
        pleased=np.zeros((len(personas), n_robots)),
        annoyed=np.zeros((len(personas), n_robots)),
        fading=np.array([math.exp(-period / each.mood_recovery) for each in personas]),
    )


@compiled
def live_through(feelings: Feelings, appraisals: Appraisals, traits: Traits) -> None:
    """New appraisals move moods and are remembered; then moods fade a little.

    Args:
        feelings: Brought up to date in place.
        appraisals: What everybody thinks of what the robots do.
        traits: Of each person, shape (n_people,).
    """
    mood, value, believed = feelings.mood, appraisals.value, appraisals.believed
    for i in range(len(mood)):
        for r in range(value.shape[1]):
            if appraisals.new[i, r]:
                mood[i] = moved_mood(mood[i], value[i, r], traits[i]["mood_change"])
                if value[i, r] > 0.0:
                    feelings.pleased[i, believed[i, r]] += value[i, r]
                else:
                    feelings.annoyed[i, believed[i, r]] -= value[i, r]
        mood[i] *= feelings.fading[i]


@compiled
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


@compiled
def misread(
    mood: Annotated[Floats, "n_people"],
    size: float,
    read: Annotated[Floats, "n_robots", "n_people"],
    noise: Annotated[Floats, "n_robots", "most_people"],
) -> None:
    """Moods as robots read them off faces.

    Args:
        mood: Shape (n_people,).
        size: Standard deviation of the error.
        read: Shape (n_robots, n_people), in [-1, 1]; filled in.
        noise: Standard normal, for as many people as could be there, shape (n_robots,
            most_people).
    """
    for robot in range(len(noise)):
        for i in range(len(mood)):
            felt = mood[i] + size * noise[robot, i]
            read[robot, i] = min(max(felt, -1.0), 1.0)
