"""Bouts: single performances of a behavior."""

from typing import NamedTuple


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
