"""Minds: what makes simulated people act, put together from their habits."""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from household.activity import Activity
from household.arrays import NOBODY, Floats, Indices, Mask
from household.compiled import compiled
from household.people.mind import (
    OWN_ACTIVITY,
    Intentions,
    Minds,
    Percepts,
)
from household.people.persona import Persona
from household.people.traits import Traits, traits_of
from household.scenario import Scenario
from policies.people.doings import Doing, Doings
from policies.people.from_scenario import doing_of
from policies.people.gaze import GazeHabits
from policies.people.giving import FeedbackGiving

SLEEPING = int(Activity.SLEEPING)


class EverydayMinds(Minds):
    """People with something to do, who look around and give feedback.

    Args:
        personas: What kind of person each is.
        make_doings: Begins what each does, with a random stream for it.
        n_robots: How many robots there are.
    """

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
        self._gaze = GazeHabits(self._personas, looking)
        self._giving = FeedbackGiving(self._personas, self._n_robots, giving)
        n = len(self._personas)
        self._look = self._doings.look.copy()
        self._eyes_open = np.ones(n, np.bool_)
        self._look_and_sleep = partial(
            _look_and_sleep,
            self._look,
            self._eyes_open,
            np.zeros(n),
            traits_of(self._personas),
        )
        self._intentions = self._intended()
        return self._intentions

    def decide(self, percepts: Percepts) -> Intentions:
        """Goes on with what they do, unless there is a robot to caress or to tap."""
        habit = self._gaze.look(percepts)
        self._giving.consider(percepts)
        wanted = self._giving.wanted
        self._doings.play(percepts.time, percepts.period, percepts.arrived, wanted)
        self._look_and_sleep(
            habit,
            self._doings.look,
            wanted,
            percepts.arrived,
            percepts.activity,
            percepts.level,
            percepts.period,
        )
        if self._giving.wishes is not self._intentions.wishes:
            self._intentions = self._intended()
        return self._intentions

    def _intended(self) -> Intentions:
        """The same arrays as before, with the wishes of now."""
        return Intentions(
            self._doings.place, self._look, self._eyes_open, self._giving.wishes
        )


@compiled
def _look_and_sleep(
    look: Indices,
    eyes_open: Mask,
    awake: Floats,
    traits: Traits,
    habit: Indices,
    told: Indices,
    wanted: Indices,
    arrived: Mask,
    activity: Indices,
    level: Floats,
    period: float,
) -> None:
    """Where everybody looks, and whether with open eyes.

    A robot that is to be touched comes before what the script tells, and that before
    habit. Eyes are closed in bed, unless a robot's noise just woke the sleeper.

    Args:
        look: What it comes to, shape (n,); changed in place, like the next two.
        eyes_open: Shape (n,).
        awake: How long each cannot fall asleep yet, shape (n,) [s].
        traits: Of each person, shape (n,).
        habit: Where each would look by habit, shape (n,).
        told: Where what it does has it look, or `OWN_ACTIVITY`, shape (n,).
        wanted: The robot that each is out to touch, or `NOBODY`, shape (n,).
        arrived: Who is in its place, shape (n,).
        activity: The role of each, shape (n,).
        level: How loud everybody hears each, people first, (n, n + n_robots) [dB].
        period: [s].
    """
    n = len(look)
    for i in range(n):
        if wanted[i] != NOBODY:
            look[i], eyes_open[i] = n + wanted[i], True
            continue
        look[i] = habit[i] if told[i] == OWN_ACTIVITY else told[i]
        awake[i] -= period
        if level[i, n:].max() >= traits[i]["wakes_at"]:
            awake[i] = traits[i]["awake_for"]
        in_bed = arrived[i] and activity[i] == SLEEPING
        eyes_open[i] = not (in_bed and awake[i] <= 0.0)


def make_minds(scenario: Scenario) -> EverydayMinds:
    """The minds of a scenario's people."""
    doings = [doing_of(scenario, index) for index in range(len(scenario.people))]
    return EverydayMinds(scenario.personas, doings, len(scenario.robots))
