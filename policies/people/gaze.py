"""Gaze: where people look, and when their eyes are closed."""

import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import numpy as np

from household.activity import Activity
from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import bind, compiled
from household.people.appraisal import heard_strength
from household.people.mind import OWN_ACTIVITY, Condition, Percepts, Surroundings
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


class GazeState(NamedTuple):
    """Where everybody looks, and for how long.

    Attributes:
        look: Index of the entity that each looks at, or `OWN_ACTIVITY`, (n_people,).
        eyes_open: False in sleep, shape (n_people,).
        habit: Where each looks by habit, shape (n_people,).
        left: How long each goes on with that, shape (n_people,) [s].
        awake: How long each cannot fall asleep yet, shape (n_people,) [s].
    """

    look: Annotated[Indices, "n_people"]
    eyes_open: Annotated[Mask, "n_people"]
    habit: Annotated[Indices, "n_people"]
    left: Annotated[Floats, "n_people"]
    awake: Annotated[Floats, "n_people"]


class Aims(NamedTuple):
    """What people look at for a reason.

    Attributes:
        routine: Index of the entity that each one's routine has it look at, or
            `OWN_ACTIVITY`, shape (n_people,).
        target: Index of the robot that each is out to touch, or `NOBODY`, shape
            (n_people,).
    """

    routine: Annotated[Indices, "n_people"]
    target: Annotated[Indices, "n_people"]


class Gaze(Stateful):
    """People look at their own activity, at robots and at people, each for a while.

    Args:
        personas: Of each person; hold the interests and the dwell times.
        rngs: Each person's own stream.

    Attributes:
        look: Index of the entity that each looks at, or `OWN_ACTIVITY`, (n_people,).
        eyes_open: False in sleep, shape (n_people,).
    """

    STATE = ("_draws", "_state")

    def __init__(
        self, personas: Sequence[Persona], rngs: Sequence[np.random.Generator]
    ) -> None:
        n = len(personas)
        self._draws = Draws(rngs, DRAWS)
        self._state = GazeState(
            look=np.full(n, OWN_ACTIVITY, np.intp),
            eyes_open=np.ones(n, np.bool_),
            habit=np.full(n, OWN_ACTIVITY, np.intp),
            left=np.zeros(n),
            awake=np.zeros(n),
        )
        self.look = self._state.look
        self.eyes_open = self._state.eyes_open
        self._traits = traits_of(personas)
        self._percepts: Percepts | None = None
        self._aims: Aims | None = None

    def turn(self, percepts: Percepts, aims: Aims) -> None:
        """Turns everybody's gaze.

        Args:
            percepts: What everybody perceives.
            aims: What people look at for a reason.
        """
        # Mostly the same ones, and bound once.
        if percepts is not self._percepts or aims is not self._aims:
            self._percepts, self._aims = percepts, aims
            known = self._state, self._traits, percepts.condition, percepts.surroundings
            self._turn = bind(_turn, *known, aims)
        self._turn(percepts.period, self._draws.next())


@compiled
def _turn(
    state: GazeState,
    traits: Traits,
    condition: Condition,
    surroundings: Surroundings,
    aims: Aims,
    period: float,
    draws: Annotated[Floats, "n_people", DRAWS],
) -> None:
    """Turns everybody's gaze, with eyes open or closed.

    A robot that is to be touched comes before the routine, and that before habit. Eyes
    are closed in bed, unless a robot's noise just woke the sleeper.

    Args:
        state: Brought up to date in place.
        traits: Of each person, shape (n_people,).
        condition: How everybody is doing.
        surroundings: What goes on around everybody.
        aims: What people look at for a reason.
        period: Time since the last call [s].
        draws: Uniform numbers, shape (n_people, DRAWS).
    """
    habit, left, awake = state.habit, state.left, state.awake
    routine, target, level = aims.routine, aims.target, surroundings.level
    n = len(routine)
    for i in range(n):
        left[i] -= period
        moves, startles, where, dwell = draws[i]
        robot, strength = _most_salient(surroundings, i)
        startled = startles < traits[i]["reflex"] * strength
        if startled or left[i] <= 0.0:
            n_robots = len(surroundings.moving)
            drawn = _drawn(i, n, n_robots, moves, where, traits)
            habit[i] = robot if startled else drawn
            left[i] = -math.log(1.0 - dwell) * traits[i]["gaze_dwell"]
        if target[i] != NOBODY:
            state.look[i], state.eyes_open[i] = n + target[i], True
            continue
        state.look[i] = habit[i] if routine[i] == OWN_ACTIVITY else routine[i]
        awake[i] -= period
        if level[i, n:].max() >= traits[i]["wakes_at"]:
            awake[i] = traits[i]["awake_for"]
        in_bed = condition.arrived[i] and condition.activity[i] == SLEEPING
        state.eyes_open[i] = not (in_bed and awake[i] <= 0.0)


@compiled
def _most_salient(surroundings: Surroundings, i: int) -> tuple[int, float]:
    """The robot that draws a person's eye most, and how strongly, in [0, 1].

    Of two that draw it equally, it is the louder one, then the last.
    """
    level, sees, moving = (
        surroundings.level[i],
        surroundings.sees[i],
        surroundings.moving,
    )
    n_people = len(level) - len(moving)
    salient, most, loudest = n_people, -1.0, -1.0
    for robot in range(n_people, len(level)):
        seen_moving = sees[robot] and moving[robot - n_people]
        heard = float(heard_strength(level[robot]))
        strength = max(heard, MOVING if seen_moving else 0.0)
        louder = strength == most and level[robot] >= loudest
        if strength > most or louder:
            salient, most, loudest = robot, strength, level[robot]
    return salient, most


@compiled
def _drawn(
    myself: int,
    n_people: int,
    n_robots: int,
    moves: float,
    where: float,
    traits: Traits,
) -> int:
    """What a person looks at next, by its interests."""
    robots, people = traits[myself]["robot_interest"], traits[myself]["people_interest"]
    if moves < robots:
        return n_people + int(where * n_robots)
    if moves < robots + people and n_people > 1:
        other = int(where * (n_people - 1))
        return other if other < myself else other + 1
    return OWN_ACTIVITY
