"""Behaviors: what a robot can choose, as data."""

from functools import lru_cache
from importlib import resources
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import msgspec

from household.records import Record, convert, read_toml

Motion = Literal["still", "spin", "wander", "follow", "retreat", "fetch"]


class Behavior(Record, frozen=True, kw_only=True):
    """One thing that a robot can do.

    Attributes:
        duration: How long one bout lasts [s].
        loudness: Sound level at 1 m [dB]; 0 is silent.
        salience: How strongly it draws the eye; 1 is a person standing still.
        motion: What the body does meanwhile.
    """

    description: str
    duration: Annotated[float, msgspec.Meta(gt=0)]
    loudness: Annotated[float, msgspec.Meta(ge=0, le=120)] = 0.0
    salience: Annotated[float, msgspec.Meta(gt=0, le=10)] = 1.0
    motion: Motion = "still"


class Bout(NamedTuple):
    """One performance of a behavior.

    Attributes:
        behavior: Index into the scenario's behaviors.
        decision: The environment step at which it was begun, from 0.
        began: When it was begun [s].
        ends: When it is over, unless it is interrupted [s].
    """

    behavior: int
    decision: int
    began: float
    ends: float


@lru_cache(maxsize=1)
def catalogue() -> dict[str, Behavior]:
    """The behaviors that ship with the package, by name."""
    path = Path(str(resources.files("household").joinpath("robots/catalogue.toml")))
    return convert(read_toml(path), dict[str, Behavior], str(path))
