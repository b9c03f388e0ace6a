"""Behaviors: what a robot can choose, as data."""

from functools import lru_cache
from typing import Annotated, Literal

import msgspec

from household.config.quantities import Seconds, Text
from household.config.toml import Record, load, packaged

Motion = Literal["still", "spin", "wander", "follow", "retreat", "fetch"]


class Behavior(Record, frozen=True, kw_only=True):
    """One thing that a robot can do.

    Attributes:
        duration: How long one bout lasts [s].
        loudness: Sound level at 1 m [dB]; 0 is silent.
        salience: How strongly it draws the eye; 1 is a person standing still.
        motion: What the body does meanwhile.
    """

    description: Text
    duration: Seconds
    loudness: Annotated[float, msgspec.Meta(ge=0, le=120)] = 0.0
    salience: Annotated[float, msgspec.Meta(gt=0, le=10)] = 1.0
    motion: Motion = "still"


@lru_cache(maxsize=1)
def catalogue() -> dict[str, Behavior]:
    """The behaviors that ship with the package, by name."""
    return load(packaged("scenario/behaviors.toml"), dict[str, Behavior])
