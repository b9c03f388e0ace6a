"""Sums of floating-point numbers, the same in every version of Python."""

from collections.abc import Iterable
from functools import reduce
from operator import add


def added(values: Iterable[float]) -> float:
    """The sum, added up one by one.

    From Python 3.12 on `sum` carries rounding along, so that its last digit, and after
    some thousand updates a learner, would depend on the version.
    """
    return reduce(add, values, 0.0)
