"""Feelings: what appraisals leave behind in people, their moods and their opinions."""

import math
from collections.abc import Sequence

import numpy as np

from household.compiled.arrays import Floats, Indices, Mask, Zeros, new_zeros
from household.compiled.jit import compiled
from household.people.traits import Traits
from household.scenario.persona import Persona
from household.state import Stateful


class Feelings(Stateful):
    """What everybody keeps to itself.

    Args:
        personas: What kind of person each is.
        n_robots: How many robots there are.
        period: Between two decisions [s].
        zeros: Makes `mood`.

    Attributes:
        mood: In [-1, 1], shape (n,); robots perceive it with noise.
        pleased: Sum of each person's positive appraisals of each robot, (n, n_robots).
        annoyed: Sum of its negative ones, as positive numbers, (n, n_robots).
        arrays: What `live_through` is to be given first.
    """

    STATE = ("mood", "pleased", "annoyed")

    def __init__(
        self,
        personas: Sequence[Persona],
        n_robots: int,
        period: float,
        zeros: Zeros = new_zeros,
    ) -> None:
        self.mood: Floats = zeros("mood", (len(personas),))
        self.pleased = np.zeros((len(personas), n_robots))
        self.annoyed = np.zeros((len(personas), n_robots))
        fading = [math.exp(-period / persona.mood_recovery) for persona in personas]
        self.arrays = self.mood, self.pleased, self.annoyed, np.array(fading)

    def forget(self) -> None:
        """Begins a new episode."""
        for felt in (self.mood, self.pleased, self.annoyed):
            felt[:] = 0.0

    def opinion(self, person: int, robot: int) -> int:
        """A questionnaire answer on a robot, from 1 to 10 (paper, section 4.1)."""
        return opinion(self.pleased[person, robot], self.annoyed[person, robot])


@compiled
def live_through(
    mood: Floats,
    pleased: Floats,
    annoyed: Floats,
    fading: Floats,
    new: Mask,
    value: Floats,
    believed: Indices,
    traits: Traits,
) -> None:
    """New judgements move moods and are remembered; then moods fade a little.

    Args:
        mood: As in `Feelings`, like the two that follow; brought up to date in place.
        pleased: Shape (n, n_robots).
        annoyed: Shape (n, n_robots).
        fading: What is left of each mood after a decision period, shape (n,).
        new: As in `Judgements`, like the two that follow.
        value: Shape (n, n_robots).
        believed: Shape (n, n_robots).
        traits: Of each person, shape (n,).
    """
    for i in range(len(mood)):
        for r in range(new.shape[1]):
            if new[i, r]:
                mood[i] = moved_mood(mood[i], value[i, r], traits[i]["mood_change"])
                if value[i, r] > 0.0:
                    pleased[i, believed[i, r]] += value[i, r]
                else:
                    annoyed[i, believed[i, r]] -= value[i, r]
        mood[i] *= fading[i]


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
def misread(mood: Floats, size: float, read: Floats, noise: Floats) -> None:
    """Moods as robots read them off faces.

    Args:
        mood: Shape (n,).
        size: Standard deviation of the error.
        read: Shape (n_robots, n), in [-1, 1]; filled in.
        noise: Standard normal, for as many people as could be there, shape
            (n_robots, at least n).
    """
    for robot in range(len(noise)):
        for i in range(len(mood)):
            felt = mood[i] + size * noise[robot, i]
            read[robot, i] = min(max(felt, -1.0), 1.0)
