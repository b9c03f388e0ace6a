"""Minds: what makes simulated people act, put together from their habits."""

from collections.abc import Callable, Sequence

import numpy as np

from household.people.mind import Intentions, Minds, Percepts
from household.scenario.persona import Persona
from household.scenario.scenario import Scenario
from household.state import Stateful
from policies.people.feedback_giving import FeedbackGiving
from policies.people.from_scenario import routine_of
from policies.people.gaze import Aims, Gaze
from policies.people.routines import Routine, Routines


class EverydayMinds(Minds, Stateful):
    """People with something to do, who look around and give feedback.

    Args:
        personas: What kind of person each is.
        make_routines: Begins what each does, given a random stream.
        n_robots: How many robots there are.
    """

    STATE = ("_routines", "_gaze", "_giving")

    def __init__(
        self,
        personas: Sequence[Persona],
        make_routines: Sequence[Callable[[np.random.Generator], Routine]],
        n_robots: int,
    ) -> None:
        self._personas = personas
        self._make_routines = make_routines
        self._n_robots = n_robots

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode."""
        # A stream for each habit: a change in one leaves the others' draws alone.
        routine, looking, giving = zip(*(rng.spawn(3) for rng in rngs), strict=True)
        makers = zip(self._make_routines, routine, strict=True)
        self._routines = Routines([make(rng) for make, rng in makers])
        self._gaze = Gaze(self._personas, looking)
        self._gaze.look[:] = self._routines.look
        self._giving = FeedbackGiving(self._personas, self._n_robots, giving)
        self._aims = Aims(self._routines.look, self._giving.target)
        return self._intended()

    def decide(self, percepts: Percepts) -> Intentions:
        """Goes on with what they do, unless there is a robot to caress or to tap."""
        self._giving.consider(percepts)
        arrived, target = percepts.condition.arrived, self._giving.target
        self._routines.advance(percepts.time, percepts.period, arrived, target)
        self._gaze.turn(percepts, self._aims)
        return self._intended()

    def _intended(self) -> Intentions:
        """The same arrays as before, with new values in them."""
        gaze, giving = self._gaze, self._giving
        return Intentions(
            self._routines.place,
            gaze.look,
            gaze.eyes_open,
            giving.wishes,
            giving.changed,
        )


def make_minds(scenario: Scenario) -> EverydayMinds:
    """The minds of a scenario's people."""
    routines = [routine_of(scenario, index) for index in range(len(scenario.people))]
    return EverydayMinds(scenario.personas, routines, len(scenario.robots))
