"""Bouts: single performances of a behavior."""

from typing import Annotated, NamedTuple

from household.compiled.arrays import Floats, Indices


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


class Bouts(NamedTuple):
    """The bout of each robot, as arrays.

    Attributes:
        behavior: Index of its behavior, -1 before the first bout, shape (n_robots,).
        decision: The environment step at which it was begun, -1 before the first bout,
            shape (n_robots,).
        began: When it was begun, shape (n_robots,) [s].
        ends: When it is over, unless it is interrupted, shape (n_robots,) [s].
    """

    behavior: Annotated[Indices, "n_robots"]
    decision: Annotated[Indices, "n_robots"]
    began: Annotated[Floats, "n_robots"]
    ends: Annotated[Floats, "n_robots"]
