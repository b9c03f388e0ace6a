"""What can go wrong in a learner, by name; each message says it in one sentence."""

from collections.abc import Hashable
from numbers import Integral, Real
from typing import cast

MOST, LEAST = 1e9, 1e-9
"""Largest number of any kind, and smallest of those that must be above 0: beyond, sums
and powers overflow."""

MOST_BEHAVIORS = 1000
"""To choose from; tables keep numbers for each in each situation."""

LATEST = 1e12
"""Of a time [s]: 30,000 years."""

LONGEST = 60
"""So much of a value a message shows [characters]."""


class LearnerError(ValueError):
    """Any refusal of a learner; what it had learned is unchanged."""


class ExperienceError(LearnerError):
    """An experience or a reward that cannot have happened, or not in this order."""


class UnknownBehaviorError(LearnerError):
    """A behavior index outside 0 .. n_behaviors - 1."""


class UnknownRobotError(LearnerError):
    """A robot that is not a member of the team."""


class UnknownNameError(LearnerError):
    """A learner or a setting that the catalog does not list."""


class ParameterError(LearnerError):
    """A parameter outside its range."""


class StateError(LearnerError):
    """A state that lacks what an analogy asks of it (see `learners.analogy`)."""


class SavedFileError(LearnerError):
    """A saved learner that is damaged, cut short, of another version or not one."""


def shown(value: object) -> str:
    """A value as Python writes it, on one line and cut where it is long."""
    try:
        text = repr(value[: LONGEST + 1] if isinstance(value, str) else value)
    except (ValueError, RecursionError):  # A number of 5,000 digits; endless nesting.
        text = f"a {type(value).__name__}"
    text = "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."


def is_within(value: object, low: float, high: float) -> bool:
    """Whether a value is a number in [low, high]; NaN is in no range."""
    # Floats first: the abstract class takes ten times as long to ask.
    return isinstance(value, (float, Real)) and bool(low <= cast(float, value) <= high)


def check_range(name: str, value: float, low: float, high: float = MOST) -> None:
    """Refuse a value outside [low, high].

    Raises:
        ParameterError: if the value is outside, or not a number.
    """
    if not is_within(value, low, high):
        raise ParameterError(
            f"{name} is {shown(value)}, which is not in [{low}, {high}]"
        )


def check_whole(name: str, value: int, low: int, high: int) -> None:
    """Refuse what is no whole number in [low, high].

    Raises:
        ParameterError: if it is none.
    """
    if not (isinstance(value, Integral) and low <= value <= high):
        raise ParameterError(
            f"{name} is {shown(value)}, which is no whole number in [{low}, {high}]"
        )


def check_positive(name: str, value: float) -> None:
    """Refuse a value that is not above zero, or too near to it, or too large.

    Raises:
        ParameterError: if it is none of those, or not a number.
    """
    if is_within(value, -MOST, 0.0):
        raise ParameterError(f"{name} is {shown(value)}, which is not above 0")
    check_range(name, value, LEAST)


def check_part(name: str, part: object, *needed: str) -> None:
    """Refuse what cannot be a part of a learner, since it lacks what such a part has.

    Args:
        name: what the part is called in the learner.
        part: what was given.
        needed: names of attributes.

    Raises:
        ParameterError: if it has not all of them, or is the class and no object of it.
    """
    if isinstance(part, type) or not all(hasattr(part, each) for each in needed):
        raise ParameterError(
            f"{name} is {shown(part)}, which has no {' and no '.join(needed)}; "
            "components by name are made by learners.components"
        )


def check_hashable(what: str, value: Hashable) -> None:
    """Refuse what cannot be a key.

    Raises:
        StateError: if it has no hash.
    """
    try:
        hash(value)
    except TypeError:
        raise StateError(f"{what} is {shown(value)}, which has no hash") from None
