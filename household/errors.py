"""The one error that users of the package meet: a single line that says what to do."""

import difflib
from collections.abc import Iterable

LONGEST = 60
"""So much of a value a message shows [characters]; who typed it knows the rest."""

LONGEST_PATH = 240
"""The same of a path, whose end tells most [characters]."""

MOST_NAMES = 40
"""So many of the allowed names a message lists."""


class HouseholdError(ValueError):
    """A user's input cannot be used; the text is one line fit for a terminal."""


def choose_from(name: object, allowed: Iterable[str], what: str) -> str:
    """Explains an unknown name: the nearest spelling and all that is allowed.

    Args:
        name: The name as given.
        allowed: Every name that would have been accepted.
        what: The kind of thing that is named, as in "scenario".

    Returns:
        One line for an error message.
    """
    names = sorted(allowed)
    near = difflib.get_close_matches(str(name)[:LONGEST], names, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    listed = ", ".join(map(shown_path, names[:MOST_NAMES]))
    more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
    return f"unknown {what} {shown(name)}{hint} (allowed: {listed}{more})"


def shown(value: object, most: int = LONGEST) -> str:
    """A value as Python writes it, on one line and cut where it is long.

    Args:
        value: Whatever a user gave.
        most: Length from which it is cut [characters].
    """
    try:
        # Not all of it: a list of a million numbers takes seconds to write.
        text = repr(value[: most + 1] if isinstance(value, str | bytes) else value)
    except (ValueError, RecursionError):  # A number of 5,000 digits; endless nesting.
        text = f"a {type(value).__name__}"
    text = printable(text)
    return text if len(text) <= most else f"{text[:most]}..."


def printable(text: str) -> str:
    """A text with line breaks and other control characters as Python writes them."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def shown_path(path: object) -> str:
    """A path, on one line and cut in the middle where it is long."""
    text = printable(str(path))
    half = LONGEST_PATH // 2
    return text if len(text) <= LONGEST_PATH else f"{text[:half]}...{text[-half:]}"
