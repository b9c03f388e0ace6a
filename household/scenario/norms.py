"""Norms: what a household finds polite, and how a person's own taste departs from it.

A norm gives a value in [-1, 1] to a behavior, for each activity of the person and for
whether that person attends to the robot or not.
"""

from collections.abc import Mapping
from functools import lru_cache
from typing import Annotated, Literal

import msgspec
import numpy as np

from household.activity import Activity, activity_of
from household.compiled.arrays import Floats
from household.config.toml import Record, load, packaged

Value = Annotated[float, msgspec.Meta(ge=-1, le=1)]
ActivityName = Literal[
    "working", "reading", "sleeping", "playing", "entering", "calling", "unknown"
]


FEW = msgspec.Meta(max_length=500)
"""Of behaviors that a norm is about."""


class Norm(Record, frozen=True, kw_only=True):
    """What is thought of each behavior during one activity.

    Attributes:
        attending: Value of each behavior to a person who attends to the robot.
        absorbed: The same to a person whose attention is elsewhere.
    """

    attending: Annotated[dict[str, Value], FEW] = msgspec.field(default_factory=dict)
    absorbed: Annotated[dict[str, Value], FEW] = msgspec.field(default_factory=dict)


Norms = Annotated[dict[ActivityName, Norm], FEW]


@lru_cache(maxsize=1)
def household_norms() -> Norms:
    """The norms that ship with the package."""
    return load(packaged("scenario/norms.toml"), Norms)


def norm_table(
    norms: Mapping[ActivityName, Norm],
    behaviors: tuple[str, ...],
    otherwise: float = 0.0,
) -> Floats:
    """Norms as an array.

    Args:
        norms: By activity.
        behaviors: Names in the order of the robots' actions.
        otherwise: Value of what is not named; 0 is neither polite nor impolite.

    Returns:
        Shape (n_activities, 2, n_behaviors): the middle index is 1 for a person who
        attends to the robot.
    """
    table = np.full((len(Activity), 2, len(behaviors)), otherwise)
    for activity, norm in norms.items():
        for attending, values in enumerate((norm.absorbed, norm.attending)):
            for index, behavior in enumerate(behaviors):
                value = values.get(behavior, otherwise)
                table[activity_of(activity), attending, index] = value
    return table


def merged(norms: Norms, others: Norms) -> Norms:
    """Norms in which others have the last word on whatever they name."""
    both = dict(norms)
    for activity, other in others.items():
        norm = both.get(activity, Norm())
        both[activity] = Norm(
            attending=norm.attending | other.attending,
            absorbed=norm.absorbed | other.absorbed,
        )
    return both
