"""One way to refuse a parameter that is out of range."""

import math

from learners.errors import ParameterError


def check_range(name: str, value: float, low: float, high: float = math.inf) -> None:
    """Refuse a value outside [low, high].

    Raises:
        ParameterError: if the value is outside, or not a number.
    """
    if not low <= value <= high:  # NaN compares false
        raise ParameterError(f"{name} is {value}, which is not in [{low}, {high}]")


def check_positive(name: str, value: float) -> None:
    """Refuse a value that is not above zero.

    Raises:
        ParameterError: if the value is zero, negative, or not a number.
    """
    if not value > 0.0:
        raise ParameterError(f"{name} is {value}, which is not above 0")
