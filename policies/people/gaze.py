"""Gaze habits: where people look when no script tells them."""

from collections.abc import Sequence

import numpy as np

from household.people.appraisal import AUDIBLE, heard_strength
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
        self._robots = range(n_people, n_people + n_robots)
        self._look = OWN_ACTIVITY
        self._left = 0.0

    def look(self, percept: Percept) -> int:
        """Index of the entity to look at now, or `OWN_ACTIVITY`."""
        self._left -= percept.period
        moves, startles, draw = self._rng.random(3).tolist()
        loudest = self._loudest(percept)
        if loudest is not None and startles < self._chance_to_startle(percept, loudest):
            self._rest_on(loudest)
        elif self._left <= 0.0:
            self._rest_on(self._drawn(moves, draw))
        return self._look

    def _loudest(self, percept: Percept) -> int | None:
        """The loudest robot, None if no robot can be heard."""
        levels = percept.level[self._robots.start :].tolist()
        most = max(levels)
        return self._robots[levels.index(most)] if most > AUDIBLE else None

    def _chance_to_startle(self, percept: Percept, robot: int) -> float:
        strength = heard_strength(percept.level[robot])
        return self._persona.reflex * float(strength)

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

    def _rest_on(self, entity: int) -> None:
        self._look = entity
        self._left = float(self._rng.exponential(self._persona.gaze_dwell))
