"""Proximity: who is near a robot, and who would hear it, as the robot can know it.

A robot knows where people are, which walls and closed doors are between, and how loud
it is; it does not know what they really notice.
"""

from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Mask
from household.compiled.jit import bind, compiled
from household.perception.hearing import AUDIBLE
from household.perception.obstruction import Obstructions
from household.perception.relations import Relations
from household.scenario.scenario import SituationModel
from household.state import Stateful

LEAVES = 1.25
"""Times the distance within which somebody comes near: so far away it is no longer
near, so that whoever stands at the border does not flicker between the two (our
choice)."""

FADES = 3.0
"""How much more than it takes to be out of hearing has to be lost until somebody who
would hear the robot no longer would [dB], for the same reason (our choice)."""

NEVER = -1.0
"""In place of a distance or a loudness: the scenario does not hold that relation."""


class Close(NamedTuple):
    """Who is near each robot, and who would hear it.

    Attributes:
        near: Shape (n_people, n_robots).
        hears: Shape (n_people, n_robots).
    """

    near: Annotated[Mask, "n_people", "n_robots"]
    hears: Annotated[Mask, "n_people", "n_robots"]


class Proximity(Stateful):
    """Keeps up to date who is near the robots and who would hear them.

    Args:
        model: Which of the two relations situations hold, and what they mean.
        n_people: How many people there are.
        n_robots: How many robots.

    Attributes:
        close: The two relations; the same arrays from moment to moment.
        kept: Whether situations hold either of them.
    """

    STATE = ("close",)

    def __init__(self, model: SituationModel, n_people: int, n_robots: int) -> None:
        shape = n_people, n_robots
        self.close = Close(np.zeros(shape, np.bool_), np.zeros(shape, np.bool_))
        self.kept = model.near is not None or model.hears is not None
        distance = NEVER if model.near is None else model.near
        loudness = NEVER if model.hears is None else model.hears
        self._update = bind(_update, self.close, distance, loudness)

    def forget(self) -> None:
        """Begins a new episode."""
        self.close.near[:] = self.close.hears[:] = False

    def update(self, obstructions: Obstructions, relations: Relations) -> bool:
        """Takes in this moment.

        Args:
            obstructions: Where everybody is and how many walls are between.
            relations: What sounds lose on their way.

        Returns:
            Whether anything has changed.
        """
        return self.kept and self._update(obstructions, relations)


@compiled
def _update(
    close: Close,
    distance: float,
    loudness: float,
    obstructions: Obstructions,
    relations: Relations,
) -> bool:
    """Brings both relations up to date; returns whether anything has changed.

    Args:
        close: Changed in place.
        distance: Within which somebody is near, or `NEVER` [m].
        loudness: Of the sound that would be heard, or `NEVER` [dB at 1 m].
        obstructions: Of this moment.
        relations: Of this moment.
    """
    changed = False
    n_people, n_robots = close.near.shape
    for i in range(n_people):
        for robot in range(n_robots):
            j = n_people + robot
            limit = distance * (LEAVES if close.near[i, robot] else 1.0)
            near = (
                distance >= 0.0
                and obstructions.crossed[i, j] == 0
                and _away(obstructions.position, i, j) <= limit
            )
            most = loudness - AUDIBLE + (FADES if close.hears[i, robot] else 0.0)
            hears = loudness >= 0.0 and relations.loss[i, j] <= most
            changed |= near != close.near[i, robot] or hears != close.hears[i, robot]
            close.near[i, robot], close.hears[i, robot] = near, hears
    return changed


@compiled
def _away(position: Floats, i: int, j: int) -> float:
    """Distance between two entities [m]."""
    return np.hypot(position[i, 0] - position[j, 0], position[i, 1] - position[j, 1])
