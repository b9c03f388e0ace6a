"""Appraisal: what a person privately thinks of what a robot does.

A person judges each bout of behavior once, at the first moment at which it can: when it
perceives the bout well enough to mind, and, if it is one who cares only for what it
watches, when it attends to the robot. What it thinks of the bout is its preference at
that moment times how strongly it perceives it.
"""

from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Indices
from household.compiled.jit import compiled
from household.people.appearance import Appearance
from household.people.mind import Appraisals
from household.people.traits import Traits
from household.perception.hearing import AUDIBLE
from household.perception.relations import Relations
from household.robots.bout import Bouts
from household.robots.robots import MOMENT

FULL = 70.0
"""Level at the ear from which a sound counts fully [dB]: a loud voice close by."""

SEEN_FULLY = 0.5
"""Share of the attention from which a sight counts fully."""


class Appraisers(NamedTuple):
    """Those who appraise.

    Attributes:
        preferences: Shape (n_people, n_activities, 2, n_behaviors), in [-1, 1].
        last: The decision at which the bout of each robot began that each person last
            judged, -1 before the first, shape (n_people, n_robots).
    """

    preferences: Annotated[Floats, "n_people", "n_activities", 2, "n_behaviors"]
    last: Annotated[Indices, "n_people", "n_robots"]


def no_appraisals(n: int, n_robots: int) -> Appraisals:
    """Room for what so many people think of so many robots."""
    return Appraisals(
        new=np.zeros((n, n_robots), np.bool_),
        value=np.zeros((n, n_robots)),
        believed=np.zeros((n, n_robots), np.intp),
        attending=np.zeros((n, n_robots), np.bool_),
        pleasing=np.zeros((n, n_robots), np.bool_),
    )


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
    appraisers: Appraisers,
    traits: Traits,
    appraisals: Appraisals,
    appearance: Appearance,
    bouts: Bouts,
    relations: Relations,
    since: float,
) -> None:
    """Everybody appraises what each robot does: preference x how well perceived.

    A bout that a person judged before is not new to it. It blames the robot that it
    sees, else the loudest that it hears. Sleepers hear only what wakes them.

    Args:
        appraisers: Everybody; their ``last`` is brought up to date in place.
        traits: Of each person, shape (n_people,).
        appraisals: Filled in; values are 0 for what is not perceived.
        appearance: What people do, and whose eyes are open.
        bouts: What the robots do.
        relations: How well everybody perceives each, people first.
        since: Beginning of the period in which it is perceived [s]; bouts that were
            over by then are gone.
    """
    last, value = appraisers.last, appraisals.value
    n_people, n_robots = value.shape
    for i in range(n_people):
        heard_levels = relations.level[i, n_people:]
        loudest = heard_levels.argmax()
        hears_from = 0.0 if appearance.eyes_open[i] else traits[i]["wakes_at"]
        for r in range(n_robots):
            j = n_people + r
            attending = relations.attends[i, j]
            value[i, r] = 0.0
            if bouts.ends[r] > since + MOMENT:
                level = relations.level[i, j]
                heard = heard_strength(level if level >= hears_from else 0.0)
                seen = seen_strength(relations.attention[i, j])
                liked = appraisers.preferences[
                    i, appearance.activity[i], int(attending), bouts.behavior[r]
                ]
                value[i, r] = max(seen, heard) * liked
            known = last[i, r] == bouts.decision[r]
            new = not known and can_judge(value[i, r], attending, traits[i])
            if new:
                last[i, r] = bouts.decision[r]
            appraisals.new[i, r] = new
            appraisals.believed[i, r] = r if relations.sees[i, j] else loudest
            appraisals.attending[i, r] = attending
            appraisals.pleasing[i, r] = value[i, r] > 0.0


@compiled
def can_judge(value: float, attending: bool, persona: np.void) -> bool:
    """Whether a person makes up its mind about a bout that it perceives like this.

    Args:
        value: What it thinks of the bout, in [-1, 1]; 0: nothing.
        attending: Whether it attends to what does it.
        persona: Its row of the traits.
    """
    if persona["only_when_attending"] and not attending:
        return False
    return value != 0.0 and abs(value) >= persona["tolerance"]
