"""Minds: what makes a simulated person act, put together from its habits."""

from collections.abc import Callable
from typing import Protocol

import numpy as np

from household.activity import Activity
from household.people.mind import OWN_ACTIVITY, Intention, Mind, Percept
from household.people.persona import Persona
from household.scenario import Scenario
from policies.people.doings import doing_of
from policies.people.gaze import GazeHabits
from policies.people.giving import FeedbackGiving


class Doing(Protocol):
    """What a person does when no robot interrupts it: a script or a schedule."""

    @property
    def place(self) -> int:
        """Index of the activity region to be in."""

    @property
    def look(self) -> int:
        """Index of the entity to look at, or `OWN_ACTIVITY`."""

    def play(self, now: float, period: float, *, there: bool) -> None:
        """Lets time pass, spent in the place or not."""


class EverydayMind(Mind):
    """A person with something to do, who looks around and gives feedback.

    Args:
        persona: What kind of person it is.
        make_doing: Begins what the person does, with a random stream for it.
        myself: Index of the person.
        counts: How many people and how many robots there are.
    """

    def __init__(
        self,
        persona: Persona,
        make_doing: Callable[[np.random.Generator], Doing],
        myself: int,
        counts: tuple[int, int],
    ) -> None:
        self._persona = persona
        self._make_doing = make_doing
        self._myself = myself
        self._n_people, self._n_robots = counts

    def reset(self, rng: np.random.Generator) -> Intention:
        """Begins a new episode."""
        # A stream for each habit: a change in one leaves the others' draws alone.
        doing, looking, giving = rng.spawn(3)
        self._doing = self._make_doing(doing)
        self._gaze = GazeHabits(
            self._persona, self._myself, self._n_people, self._n_robots, looking
        )
        self._giving = FeedbackGiving(self._persona, self._n_robots, giving)
        self._awake = 0.0
        place = self._doing.place
        return Intention(place=place, look=self._doing.look)

    def decide(self, percept: Percept) -> Intention:
        """Goes on with what it does, unless there is a robot to caress or to tap."""
        habit = self._gaze.look(percept)
        self._giving.consider(percept)
        wish = self._giving.wish
        there = percept.arrived and wish is None
        self._doing.play(percept.time, percept.period, there=there)
        place, look = self._doing.place, self._doing.look
        if wish is not None:
            return Intention(place=place, look=self._n_people + wish.robot, wish=wish)
        return Intention(
            place=place,
            look=habit if look == OWN_ACTIVITY else look,
            eyes_open=not self._sleeps(percept, there=there),
        )

    def _sleeps(self, percept: Percept, *, there: bool) -> bool:
        """Whether its eyes are closed: in bed, and not just woken by a noise."""
        self._awake -= percept.period
        if max(percept.level[self._n_people :].tolist()) >= self._persona.wakes_at:
            self._awake = self._persona.awake_for
        return there and percept.activity is Activity.SLEEPING and self._awake <= 0.0


def make_minds(scenario: Scenario) -> list[Mind]:
    """The minds of a scenario's people, in order."""
    counts = len(scenario.people), len(scenario.robots)
    return [
        EverydayMind(persona, doing_of(scenario, index), index, counts)
        for index, persona in enumerate(scenario.personas)
    ]
