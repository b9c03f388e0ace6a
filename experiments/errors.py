"""The one error a user of the command line can cause, and the sentence it says."""

from __future__ import annotations

from collections.abc import Iterable


class ExperimentError(ValueError):
    """Something asked for cannot be done; the text is one clear line.

    The command line prints it as it is and ends with exit status 2.
    """


def unknown(kind: str, given: object, allowed: Iterable[object]) -> ExperimentError:
    """Returns the error for a name that is not on a list.

    Args:
        kind: What was named, e.g. "experiment".
        given: The name as it was given.
        allowed: Every name that would have been right.

    Returns:
        An error that names the nearest spelling, if one is near, and all allowed.
    """
    from household.errors import choose_from

    return ExperimentError(choose_from(str(given), map(str, allowed), kind) + ".")
