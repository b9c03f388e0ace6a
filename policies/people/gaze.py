"""Gaze habits: where people look when no script tells them."""

import math
from collections.abc import Sequence

import numpy as np

from household.people.appraisal import heard_strength
from household.people.mind import OWN_ACTIVITY, Percept
from household.people.persona import Persona
from household.streams import Draws

DRAWS = 4
"""In each moment: whether the gaze moves on, startles, where to, and for how long."""

MOVING = 0.5
"""How strongly a robot on the move draws the eye that sees it, beside 1 for a loud
noise close by (our choice)."""


class GazeHabits:
    """Looks at the own activity, at robots and at people, each for a while.

    Args:
        persona: Holds the interests and the dwell time.
        myself: Index of the person.
        n_people: How many people there are.
        n_robots: How many robots there are.
        rng: The person's own stream.
    """

    def __init__(
        self,
        persona: Persona,
        myself: int,
        n_people: int,
        n_robots: int,
        rng: np.random.Generator,
    ) -> None:
        self._persona = persona
        self._draws = Draws([rng], DRAWS)
        self._people = [i for i in range(n_people) if i != myself]
        self._robots = range(n_people, n_people + n_robots)
        self._look = OWN_ACTIVITY
        self._left = 0.0

    def look(self, percept: Percept) -> int:
        """Index of the entity to look at now, or `OWN_ACTIVITY`."""
        self._left -= percept.period
        moves, startles, draw, dwell = self._draws.next()[0].tolist()
        robot, strength = self._most_striking(percept)
        if startles < self._persona.reflex * strength:
            self._rest_on(robot, dwell)
        elif self._left <= 0.0:
            self._rest_on(self._drawn(moves, draw), dwell)
        return self._look

    def _most_striking(self, percept: Percept) -> tuple[int, float]:
        """The robot that draws the eye most, and how strongly, in [0, 1]."""
        first = self._robots.start
        levels = percept.level[first:].tolist()
        seen_moving = percept.sees[first:] & percept.moving
        strength, _, robot = max(
            (max(float(heard_strength(level)), MOVING * moves), level, robot)
            for robot, level, moves in zip(
                self._robots, levels, seen_moving.tolist(), strict=True
            )
        )
        return robot, strength

    def _drawn(self, moves: float, draw: float) -> int:
        robots, people = self._persona.robot_interest, self._persona.people_interest
        choices: Sequence[int]
        if moves < robots:
            choices = self._robots
        elif moves < robots + people and self._people:
            choices = self._people
        else:
            return OWN_ACTIVITY
        return choices[int(draw * len(choices))]

    def _rest_on(self, entity: int, dwell: float) -> None:
        self._look = entity
        self._left = -math.log(1.0 - dwell) * self._persona.gaze_dwell
