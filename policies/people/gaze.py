"""Gaze habits: where people look when no script tells them."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from household.arrays import Floats, Indices, Mask
from household.compiled import compiled
from household.people.appraisal import heard_strength
from household.people.mind import OWN_ACTIVITY, Percepts
from household.people.persona import Persona
from household.people.traits import Traits, traits_of
from household.streams import draws

DRAWS = 4
"""In each moment: whether the gaze moves on, startles, where to, and for how long."""

MOVING = 0.5
"""How strongly a robot on the move draws the eye that sees it, beside 1 for a loud
noise close by (our choice)."""


class GazeHabits:
    """People look at their own activity, at robots and at people, each for a while.

    Args:
        personas: Of each person; hold the interests and the dwell times.
        rngs: Each person's own stream.
    """

    def __init__(
        self, personas: Sequence[Persona], rngs: Sequence[np.random.Generator]
    ) -> None:
        self._draws = draws(rngs, DRAWS)
        self._look = np.full(len(personas), OWN_ACTIVITY, np.intp)
        left = np.zeros(len(personas))
        self._look_around = partial(_look_around, self._look, left, traits_of(personas))

    def look(self, percepts: Percepts) -> NDArray[np.intp]:
        """Index of the entity that each looks at now, or `OWN_ACTIVITY`."""
        self._look_around(
            next(self._draws),
            percepts.level,
            percepts.sees,
            percepts.moving,
            percepts.period,
        )
        return self._look


@compiled
def _look_around(
    look: Indices,
    left: Floats,
    traits: Traits,
    draws: Floats,
    level: Floats,
    sees: Mask,
    moving: Mask,
    period: float,
) -> None:
    """Moves everybody's gaze on: ``look``, and how long it has ``left`` there [s]."""
    for i in range(len(look)):
        left[i] -= period
        moves, startles, where, dwell = draws[i]
        robot, strength = _most_striking(level[i], sees[i], moving)
        if startles < traits[i]["reflex"] * strength:
            look[i] = robot
        elif left[i] <= 0.0:
            look[i] = _drawn(i, len(look), len(moving), moves, where, traits)
        else:
            continue
        left[i] = -math.log(1.0 - dwell) * traits[i]["gaze_dwell"]


@compiled
def _most_striking(level: Floats, sees: Mask, moving: Mask) -> tuple[int, float]:
    """The robot that draws somebody's eye most, and how strongly, in [0, 1].

    Of two that draw it alike it is the louder, then the last.
    """
    n_people = len(level) - len(moving)
    striking, most, loudest = n_people, -1.0, -1.0
    for robot in range(n_people, len(level)):
        seen_moving = sees[robot] and moving[robot - n_people]
        heard = float(heard_strength(level[robot]))
        strength = max(heard, MOVING if seen_moving else 0.0)
        louder = strength == most and level[robot] >= loudest
        if strength > most or louder:
            striking, most, loudest = robot, strength, level[robot]
    return striking, most


@compiled
def _drawn(
    myself: int,
    n_people: int,
    n_robots: int,
    moves: float,
    where: float,
    traits: Traits,
) -> int:
    """What somebody looks at next, by its interests."""
    robots, people = traits[myself]["robot_interest"], traits[myself]["people_interest"]
    if moves < robots:
        return n_people + int(where * n_robots)
    if moves < robots + people and n_people > 1:
        other = int(where * (n_people - 1))
        return other if other < myself else other + 1
    return OWN_ACTIVITY
