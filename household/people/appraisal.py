"""Appraisal: what a person privately thinks of what a robot does.

A person judges each bout of behavior once, when it first sees or hears it well
enough: its preference times how strongly it perceived the bout.
"""

from collections.abc import Sequence

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import compiled
from household.people.mind import Judgements
from household.people.person import Person
from household.people.traits import Traits, traits_of
from household.scenario.norms import norm_table
from household.scenario.scenario import Scenario
from household.state import Stateful

AUDIBLE = 40.0
"""Level at the ear from which a sound is noticed [dB]: a quiet room."""

FULL = 70.0
"""Level at the ear from which a sound counts fully [dB]: a loud voice close by."""

SEEN_FULLY = 0.5
"""Share of the attention from which a sight counts fully."""


class Appraisals(Stateful):
    """What everybody privately thinks of what the robots do.

    Args:
        scenario: Holds the household's norms and how far people depart from them.
        everyone: The people, with their preferences.

    Attributes:
        judgements: What everybody thinks of the bouts that are new to it.
        pleasing: Whether each robot does what pleases each person, (n, n_robots).
        arrays: What `appraise` is to be given first.
    """

    STATE = ("_judged", "pleasing", "judgements")

    def __init__(self, scenario: Scenario, everyone: Sequence[Person]) -> None:
        n, n_robots = len(everyone), len(scenario.robots)
        # Tastes are drawn round 0, so that on average the norms are left of them.
        norms = norm_table(scenario.household_norms, scenario.behaviors)
        average = (1.0 - scenario.heterogeneity) * norms
        self._average = np.array([average] * n)
        self._preferences = np.array([p.preferences for p in everyone]).reshape(
            n, len(Activity), 2, -1
        )
        self._rows = np.arange(n)[:, None]
        # The decision at which the bout of each robot began that each last judged.
        self._judged = np.full((n, n_robots), -1, np.intp)
        self.pleasing = np.zeros((n, n_robots), np.bool_)
        self.judgements = Judgements(
            new=np.zeros((n, n_robots), np.bool_),
            value=np.zeros((n, n_robots)),
            believed=np.zeros((n, n_robots), np.intp),
            attending=np.zeros((n, n_robots), np.bool_),
        )
        self.arrays = (
            *self.judgements,
            self.pleasing,
            self._judged,
            self._preferences,
            traits_of([person.persona for person in everyone]),
        )

    def forget(self) -> None:
        """Begins a new episode: nobody has judged anything yet."""
        self._judged[:] = -1

    def preferred(
        self, activity: Indices, attends: Mask, *, on_average: bool = False
    ) -> Floats:
        """What everybody prefers of each robot right now.

        Args:
            activity: The role that each plays, shape (n,).
            attends: Whether each person attends to each robot, shape (n, n_robots).
            on_average: As if everybody were the average person of the population.

        Returns:
            Shape (n, n_robots, n_behaviors), in [-1, 1].
        """
        preferences = self._average if on_average else self._preferences
        chosen: Floats = preferences[
            self._rows, activity[:, None], attends.astype(np.intp)
        ]
        return chosen


@compiled
def heard_strength(level: Floats | float) -> Floats:
    """How strongly sounds are heard, in [0, 1].

    Args:
        level: At the ear [dB], any shape.
    """
    return np.minimum(np.maximum((level - AUDIBLE) / (FULL - AUDIBLE), 0.0), 1.0)


@compiled
def seen_strength(attention: Floats | float) -> Floats:
    """How strongly things are seen, in [0, 1].

    Args:
        attention: Share of the attention that they get, any shape.
    """
    return np.minimum(np.maximum(attention / SEEN_FULLY, 0.0), 1.0)


@compiled
def appraise(
    new: Mask,
    value: Floats,
    believed: Indices,
    attending: Mask,
    pleasing: Mask,
    judged: Indices,
    preferences: Floats,
    traits: Traits,
    activity: Indices,
    eyes_open: Mask,
    doing: Indices,
    begun: Indices,
    attends: Mask,
    attention: Floats,
    sees: Mask,
    level: Floats,
) -> None:
    """Everybody appraises what each robot does: preference x how well perceived.

    Bouts that somebody appraised before are not new to it. It blames the robot that
    it saw, else the loudest that it hears.

    Args:
        new: As in `Judgements`, like the three that follow; filled in.
        value: 0 for what is not perceived.
        believed: Shape (n_people, n_robots).
        attending: Shape (n_people, n_robots).
        pleasing: Whether each robot does what pleases each person, (n_people,
            n_robots); filled in.
        judged: Decision at which the bout of each robot began that each person last
            judged, shape (n_people, n_robots); brought up to date in place.
        preferences: Shape (n_people, n_activities, 2, n_behaviors), in [-1, 1].
        traits: Of each person, shape (n_people,).
        activity: What each person does, shape (n_people,).
        eyes_open: Who is awake, shape (n_people,); sleepers hear only what wakes them.
        doing: Index of each robot's behavior, -1 for none, shape (n_robots,).
        begun: Decision at which each robot began it, shape (n_robots,).
        attends: Who attends to whom, people first, shape (n, n).
        attention: How much, shape (n, n).
        sees: Who sees whom, shape (n, n).
        level: How loud each hears each, shape (n, n) [dB].
    """
    n_people, n_robots = value.shape
    for i in range(n_people):
        loudest = level[i, n_people:].argmax()
        hears_from = 0.0 if eyes_open[i] else traits[i]["wakes_at"]
        for r in range(n_robots):
            j = n_people + r
            value[i, r] = 0.0
            if doing[r] >= 0:
                loud = level[i, j] if level[i, j] >= hears_from else 0.0
                seen, heard = seen_strength(attention[i, j]), heard_strength(loud)
                looks = int(attends[i, j])
                liked = preferences[i, activity[i], looks, doing[r]]
                value[i, r] = max(seen, heard) * liked
            new[i, r] = value[i, r] != 0.0 and judged[i, r] != begun[r]
            if new[i, r]:
                judged[i, r] = begun[r]
            believed[i, r] = r if sees[i, j] else loudest
            attending[i, r] = attends[i, j]
            pleasing[i, r] = value[i, r] > 0.0
