"""Minds: what makes a simulated person act, put together from its habits."""

import math
from collections.abc import Sequence

import numpy as np

from household.activity import Activity
from household.people.mind import OWN_ACTIVITY, Intention, Mind, Percept
from household.people.persona import Persona
from household.people.places import Places
from household.scenario import PersonSpec, Scenario
from policies.people.gaze import GazeHabits
from policies.people.giving import FeedbackGiving
from policies.people.script import Line, Script

FOREVER = (math.inf, math.inf)


class ScriptedMind(Mind):
    """A person who plays a script, looks around and gives feedback.

    Args:
        persona: What kind of person it is.
        lines: Its script.
        myself: Index of the person.
        counts: How many people and how many robots there are.
    """

    def __init__(
        self,
        persona: Persona,
        lines: Sequence[Line],
        myself: int,
        counts: tuple[int, int],
    ) -> None:
        self._persona = persona
        self._lines = lines
        self._myself = myself
        self._n_people, self._n_robots = counts

    def reset(self, rng: np.random.Generator) -> Intention:
        """Begins the script anew."""
        # A stream for each habit: a change in one leaves the others' draws alone.
        doing, looking, giving = rng.spawn(3)
        self._script = Script(self._lines, doing)
        self._gaze = GazeHabits(
            self._persona, self._myself, self._n_people, self._n_robots, looking
        )
        self._giving = FeedbackGiving(self._persona, self._n_robots, giving)
        return Intention(place=self._script.line.place, look=self._script.look)

    def decide(self, percept: Percept) -> Intention:
        """Goes on with the script, unless there is a robot to caress or to tap."""
        habit = self._gaze.look(percept)
        self._giving.consider(percept)
        wish = self._giving.wish
        there = percept.place == self._script.line.place and not percept.walking
        self._script.play(percept.time, percept.period, there=there and wish is None)
        place, look = self._script.line.place, self._script.look
        if wish is not None:
            return Intention(place=place, look=self._n_people + wish.robot, wish=wish)
        asleep = percept.activity is Activity.SLEEPING and percept.place == place
        return Intention(
            place=place,
            look=habit if look == OWN_ACTIVITY else look,
            eyes_open=not asleep,
        )


def make_minds(scenario: Scenario) -> list[Mind]:
    """The minds of a scenario's people, in order."""
    places = Places(scenario.plan)
    names = (*scenario.person_names, *scenario.robot_names)
    counts = len(scenario.people), len(scenario.robots)
    return [
        ScriptedMind(persona, _lines(spec, places, names), index, counts)
        for index, (spec, persona) in enumerate(
            zip(scenario.people, scenario.personas, strict=True)
        )
    ]


def _lines(spec: PersonSpec, places: Places, names: tuple[str, ...]) -> list[Line]:
    """A script with names turned into indices."""
    return [
        Line(
            place=places.index(step.place),
            duration=step.duration or FOREVER,
            until=step.until or math.inf,
            look=OWN_ACTIVITY if step.look_at is None else names.index(step.look_at),
            look_for=step.look_for or FOREVER,
            look_away=step.look_away,
        )
        for step in spec.script
    ]
