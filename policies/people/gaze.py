"""Gaze habits: where people look when no script tells them."""

import numpy as np
from numpy.typing import NDArray

from household.people.appraisal import heard_strength
from household.people.mind import OWN_ACTIVITY, Percept
from household.people.persona import Persona


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
        self._rng = rng
        self._people = [i for i in range(n_people) if i != myself]
        self._robots = list(range(n_people, n_people + n_robots))
        self._look = OWN_ACTIVITY
        self._left = 0.0

    def look(self, percept: Percept) -> int:
        """Index of the entity to look at now, or `OWN_ACTIVITY`."""
        self._left -= percept.period
        moves, startles, draw = self._rng.random(3)
        loudest = self._loudest(percept.level)
        strength = float(heard_strength(percept.level[loudest]))
        if startles < self._persona.reflex * strength:
            self._rest_on(loudest)
        elif self._left <= 0.0:
            self._rest_on(self._drawn(moves, draw))
        return self._look

    def _loudest(self, level: NDArray[np.float64]) -> int:
        return max(self._robots, key=lambda robot: float(level[robot]))

    def _drawn(self, moves: float, draw: float) -> int:
        robots, people = self._persona.robot_interest, self._persona.people_interest
        if moves < robots:
            choices = self._robots
        elif moves < robots + people and self._people:
            choices = self._people
        else:
            return OWN_ACTIVITY
        return choices[int(draw * len(choices))]

    def _rest_on(self, entity: int) -> None:
        self._look = entity
        self._left = float(self._rng.exponential(self._persona.gaze_dwell))
