"""The one error that users of the package meet: a single line that says what to do."""

import difflib
from collections.abc import Iterable


class HouseholdError(ValueError):
    """A user's input cannot be used; the text is one line fit for a terminal."""


def choose_from(name: str, allowed: Iterable[str], what: str) -> str:
    """Explains an unknown name: the nearest spelling and all that is allowed.

    Args:
        name: The name as given.
        allowed: Every name that would have been accepted.
        what: The kind of thing that is named, as in "scenario".

    Returns:
        One line for an error message.
    """
    names = sorted(allowed)
    near = difflib.get_close_matches(name, names, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    return f"unknown {what} {name!r}{hint} (allowed: {', '.join(names)})"
