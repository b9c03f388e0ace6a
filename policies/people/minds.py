"""Minds: what makes simulated people act, put together from their habits."""

from collections.abc import Callable, Sequence

import numpy as np

from household.people.mind import (
    Intentions,
    Minds,
    Percepts,
)
from household.scenario.persona import Persona
from household.scenario.scenario import Scenario
from household.state import Stateful
from policies.people.doings import Doing, Doings
from policies.people.from_scenario import doing_of
from policies.people.gaze import Gaze
from policies.people.giving import FeedbackGiving


class EverydayMinds(Minds, Stateful):
    """People with something to do, who look around and give feedback.

    Args:
        personas: What kind of person each is.
        make_doings: Begins what each does, with a random stream for it.
        n_robots: How many robots there are.
    """

    STATE = ("_doings", "_gaze", "_giving")

    def __init__(
        self,
        personas: Sequence[Persona],
        make_doings: Sequence[Callable[[np.random.Generator], Doing]],
        n_robots: int,
    ) -> None:
        self._personas = personas
        self._make_doings = make_doings
        self._n_robots = n_robots

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode."""
        # A stream for each habit: a change in one leaves the others' draws alone.
        doing, looking, giving = zip(*(rng.spawn(3) for rng in rngs), strict=True)
        makers = zip(self._make_doings, doing, strict=True)
        self._doings = Doings([make(rng) for make, rng in makers])
        self._gaze = Gaze(self._personas, looking)
        self._gaze.look[:] = self._doings.look
        self._giving = FeedbackGiving(self._personas, self._n_robots, giving)
        return self._intended()

    def decide(self, percepts: Percepts) -> Intentions:
        """Goes on with what they do, unless there is a robot to caress or to tap."""
        self._giving.consider(percepts)
        wanted = self._giving.wanted
        self._doings.play(percepts.time, percepts.period, percepts.arrived, wanted)
        self._gaze.turn(percepts, self._doings.look, wanted)
        return self._intended()

    def _intended(self) -> Intentions:
        """The same arrays as before, with the wishes of now."""
        gaze = self._gaze
        return Intentions(
            self._doings.place, gaze.look, gaze.eyes_open, self._giving.wishes
        )


def make_minds(scenario: Scenario) -> EverydayMinds:
    """The minds of a scenario's people."""
    doings = [doing_of(scenario, index) for index in range(len(scenario.people))]
    return EverydayMinds(scenario.personas, doings, len(scenario.robots))
