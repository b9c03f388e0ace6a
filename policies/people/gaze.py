"""Gaze: where people look, and when their eyes are closed."""

import math
from collections.abc import Sequence

import numpy as np

from household.activity import Activity
from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import (
    FLOAT,
    FLOATS_2D,
    INDICES,
    MASK,
    MASK_2D,
    bind,
    compiled,
)
from household.people.appraisal import heard_strength
from household.people.mind import OWN_ACTIVITY, Percepts
from household.people.traits import Traits, traits_of
from household.scenario.persona import Persona
from household.simulation.random_streams import Draws
from household.state import Stateful

DRAWS = 4
"""In each moment: whether the gaze moves on, startles, where to, and for how long."""

SLEEPING = int(Activity.SLEEPING)

MOVING = 0.5
"""How strongly a robot on the move draws the eye that sees it, beside 1 for a loud
noise close by (our choice)."""


class Gaze(Stateful):
    """People look at their own activity, at robots and at people, each for a while.

    Args:
        personas: Of each person; hold the interests and the dwell times.
        rngs: Each person's own stream.

    Attributes:
        look: Index of the entity that each looks at, or `OWN_ACTIVITY`, shape (n,).
        eyes_open: False in sleep, shape (n,).
    """

    STATE = ("_draws", "look", "eyes_open", "_habit", "_left", "_awake")

    def __init__(
        self, personas: Sequence[Persona], rngs: Sequence[np.random.Generator]
    ) -> None:
        n = len(personas)
        self._draws = Draws(rngs, DRAWS)
        self.look = np.full(n, OWN_ACTIVITY, np.intp)
        self.eyes_open = np.ones(n, np.bool_)
        self._habit = np.full(n, OWN_ACTIVITY, np.intp)
        self._left, self._awake = np.zeros(n), np.zeros(n)
        self._turn = bind(
            _turn,
            self.look,
            self.eyes_open,
            self._habit,
            self._left,
            self._awake,
            traits_of(personas),
            then=(
                *(FLOATS_2D, FLOATS_2D, MASK_2D, MASK, MASK, INDICES),
                *(FLOAT, INDICES, INDICES),
            ),
        )

    def turn(self, percepts: Percepts, told: Indices, wanted: Indices) -> None:
        """Turns everybody's gaze.

        Args:
            percepts: What everybody perceives.
            told: Where what each does has it look, or `OWN_ACTIVITY`, shape (n,).
            wanted: The robot that each is out to touch, or `NOBODY`, shape (n,).
        """
        self._turn(
            self._draws.next(),
            percepts.level,
            percepts.sees,
            percepts.moving,
            percepts.arrived,
            percepts.activity,
            percepts.period,
            told,
            wanted,
        )


@compiled
def _turn(
    look: Indices,
    eyes_open: Mask,
    habit: Indices,
    left: Floats,
    awake: Floats,
    traits: Traits,
    draws: Floats,
    level: Floats,
    sees: Mask,
    moving: Mask,
    arrived: Mask,
    activity: Indices,
    period: float,
    told: Indices,
    wanted: Indices,
) -> None:
    """Where everybody looks, and whether with open eyes.

    A robot that is to be touched comes before what the script tells, and that before
    habit. Eyes are closed in bed, unless a robot's noise just woke the sleeper.

    Args:
        look: What it comes to, shape (n,); changed in place, as all up to ``traits``.
        eyes_open: Shape (n,).
        habit: Where each looks by habit, shape (n,).
        left: How long it goes on with that, shape (n,) [s].
        awake: How long each cannot fall asleep yet, shape (n,) [s].
        traits: Of each person, shape (n,).
        draws: Uniform numbers, shape (n, DRAWS).
        level: As in `Percepts`, like all that follow up to ``period``.
        sees: Shape (n, n + n_robots).
        moving: Shape (n_robots,).
        arrived: Shape (n,).
        activity: Shape (n,).
        period: [s].
        told: Where what each does has it look, or `OWN_ACTIVITY`, shape (n,).
        wanted: The robot that each is out to touch, or `NOBODY`, shape (n,).
    """
    n = len(look)
    for i in range(n):
        left[i] -= period
        moves, startles, where, dwell = draws[i]
        robot, strength = _most_striking(level[i], sees[i], moving)
        startled = startles < traits[i]["reflex"] * strength
        if startled or left[i] <= 0.0:
            drawn = _drawn(i, n, len(moving), moves, where, traits)
            habit[i] = robot if startled else drawn
            left[i] = -math.log(1.0 - dwell) * traits[i]["gaze_dwell"]
        if wanted[i] != NOBODY:
            look[i], eyes_open[i] = n + wanted[i], True
            continue
        look[i] = habit[i] if told[i] == OWN_ACTIVITY else told[i]
        awake[i] -= period
        if level[i, n:].max() >= traits[i]["wakes_at"]:
            awake[i] = traits[i]["awake_for"]
        in_bed = arrived[i] and activity[i] == SLEEPING
        eyes_open[i] = not (in_bed and awake[i] <= 0.0)


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
