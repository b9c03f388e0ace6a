"""Appearance: in which role people appear, what is before them, and their eyes."""

import math
from typing import Annotated, NamedTuple

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats, Indices, Mask, Zeros
from household.compiled.jit import compiled
from household.home.places import NOWHERE, Places, place_of
from household.people.traits import Traits


class Appearance(NamedTuple):
    """How people appear to whoever looks at them.

    Attributes:
        place: Index of the region that each is in, or `NOWHERE`, shape (n_people,).
        activity: The role that each plays, as `Activity` values, shape (n_people,).
        focus: What each looks at where it is, NaN for nothing, (n_people, 2) [m].
        eyes_open: Whose eyes are open, shape (n_people,).
    """

    place: Annotated[Indices, "n_people"]
    activity: Annotated[Indices, "n_people"]
    focus: Annotated[Floats, "n_people", 2]
    eyes_open: Annotated[Mask, "n_people"]


class Regions(NamedTuple):
    """The activity regions of a home; `Places` says what is in them.

    Attributes:
        circles: Shape (n_regions, 3), rows of x, y, radius [m].
        roles: The role in each, and at the end that of being nowhere, (n_regions + 1,).
        facing: What people look at in each, and NaN at the end, (n_regions + 1, 2) [m].
    """

    circles: Annotated[Floats, "n_regions", 3]
    roles: Annotated[Indices, "n_regions + 1"]
    facing: Annotated[Floats, "n_regions + 1", 2]


def appearance_of(n: int, zeros: Zeros) -> Appearance:
    """How people appear before anybody has seen them.

    Args:
        n: How many there are.
        zeros: Makes ``activity``, which is recorded.
    """
    activity = zeros("activity", (n,), np.intp)
    activity[:] = Activity.UNKNOWN
    return Appearance(
        place=np.full(n, NOWHERE, np.intp),
        activity=activity,
        focus=np.full((n, 2), np.nan),
        eyes_open=np.ones(n, np.bool_),
    )


def regions_of(places: Places) -> Regions:
    """The regions as a record for compiled loops."""
    return Regions(places.circles, places.roles.astype(np.intp), places.facing)


@compiled
def appear(
    appearance: Appearance,
    regions: Regions,
    traits: Traits,
    position: Annotated[Floats, "n", 2],
    half_view: Annotated[Floats, "n"],
) -> bool:
    """Finds out in which role people appear, and how far they can see.

    Args:
        appearance: Its ``eyes_open`` are read; the rest is brought up to date in place.
        regions: Of the home.
        traits: Of each person, shape (n_people,).
        position: Of people and robots, shape (n, 2) [m].
        half_view: Half of each one's field of view, shape (n,) [rad]; filled in for
            people, negative with the eyes closed.

    Returns:
        Whether anybody plays another role than before.
    """
    place, activity = appearance.place, appearance.activity
    changed = False
    for i in range(len(place)):
        place[i] = place_of(position[i], regions.circles)
        # The last ones are for nowhere, which -1 is the index of.
        changed |= activity[i] != regions.roles[place[i]]
        activity[i] = regions.roles[place[i]]
        appearance.focus[i] = regions.facing[place[i]]
        half = math.radians(traits[i]["field_of_view"] / 2)
        half_view[i] = half if appearance.eyes_open[i] else -1.0
    return changed
