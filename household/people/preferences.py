"""Preferences: what people find polite now; it may change while robots live there."""

import math
from typing import NamedTuple

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats, Indices
from household.people.person import Person, preferences_of
from household.scenario.change import Change, Wants, in_order
from household.scenario.scenario import Scenario


class Turn(NamedTuple):
    """A change of some people's preferences.

    Attributes:
        change: When it happens.
        who: Indices of these people, shape (m,).
        wanted: What they prefer when it is over, shape (m, n_activities, 2,
            n_behaviors), in [-1, 1].
    """

    change: Change
    who: Indices
    wanted: Floats

    def share(self, time: float) -> float:
        """How much of it has happened by a time [s], in [0, 1]."""
        begun = time - self.change.at
        if begun >= self.change.over:
            return 1.0
        return begun / self.change.over if begun > 0.0 else 0.0


class Preferences:
    """What people find polite, in the order of the scenario.

    Args:
        scenario: Holds the household's norms and how far people depart from them.
        everyone: The people, with their preferences as an episode begins.

    Attributes:
        values: Shape (n, n_activities, 2, n_behaviors), in [-1, 1]; the third axis
            says whether the person attends to the robot. Always the same array.
        on_average: The same for everybody: what to expect of somebody who lives here,
            without knowing who it is. Always the same array, too.
        until: When they are others than now, infinite if they stay [s].
    """

    def __init__(self, scenario: Scenario, everyone: list[Person]) -> None:
        n = len(everyone)
        self._first = np.array([p.preferences for p in everyone]).reshape(
            n, len(Activity), 2, -1
        )
        self._turns = _turns(scenario, everyone)
        self.values = self._first.copy()
        self.on_average = np.repeat(self.values.mean(axis=0, keepdims=True), n, axis=0)
        self.until = math.inf
        self.hold_at(0.0)

    def hold_at(self, time: float) -> None:
        """Makes them those of a time; it does not matter which they were before.

        Args:
            time: Since the episode began [s].
        """
        if not self._turns:
            return
        self.values[:], self.until = self._first, math.inf
        for turn in self._turns:
            share = turn.share(time)
            if share < 1.0:
                # While a change goes on, they are others at every later time.
                self.until = min(self.until, max(turn.change.at, time))
            now = self.values[turn.who]
            self.values[turn.who] = (1.0 - share) * now + share * turn.wanted
        self.on_average[:] = self.values.mean(axis=0)


def _turns(scenario: Scenario, everyone: list[Person]) -> list[Turn]:
    """The changes in order, each with what comes of all until then."""
    norms, population = scenario.household_norms, scenario.population
    wants = [
        Wants(norms=norms, persona=person.persona, population=population)
        for person in everyone
    ]
    turns = []
    for change in in_order(scenario.changes):
        who = [i for i, p in enumerate(everyone) if change.concerns(p.name)]
        for i in who:
            wants[i] = wants[i].after(change)
        wanted = [preferences_of(scenario, i, wants[i]) for i in who]
        turns.append(Turn(change, np.array(who, np.intp), np.array(wanted)))
    return turns
