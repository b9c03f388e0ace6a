"""What can go wrong in a learner, by name; each message says it in one sentence."""

import math


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
