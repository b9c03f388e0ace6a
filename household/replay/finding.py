"""Finding: events of a replay by their words."""

import warnings
from collections.abc import Iterator
from operator import attrgetter
from pathlib import Path
from typing import NamedTuple

from household.config.toml import is_file
from household.errors import HouseholdError, shown_path
from household.replay.probing import check_readable

TOUCHES = frozenset({"TAP", "CARESS"})
"""Kinds of events that are touches."""


class Event(NamedTuple):
    """A line of the table of events.

    Attributes:
        decision: When.
        kind: Such as "TAP", "MISTAKE" or "FIRST".
        text: What happened, in words.
    """

    decision: int
    kind: str
    text: str


def find(path: Path | str, words: str, *, tried: bool = False) -> list[Event]:
    """Events whose kind or text contains some words, in the order of time.

    Only events are read of the file, not its moments.

    Args:
        path: The replay.
        words: As in "tap by father" or "mistake"; case does not matter.
        tried: As for `read_replay`.

    Raises:
        HouseholdError: If there is none, or the file cannot be read.
    """
    if not tried:
        check_readable(path)
    asked = " ".join(words.split()).casefold()
    found = [
        event
        for event in _events(Path(path))
        if asked in f"{event.kind} {event.text}".casefold()
    ]
    if not found:
        raise HouseholdError(
            f'{shown_path(path)}: no event says "{words}"; ask for "tap by NAME", '
            '"caress by NAME", "wrong blame", "wrong credit", "first visit" or "change '
            'of mind"'
        )
    return sorted(found, key=attrgetter("decision"))


def first_touch(path: Path | str) -> int:
    """The decision of the first touch of a replay that can be read; 0: there is none.

    Raises:
        HouseholdError: If the file cannot be read.
    """
    touched = (one.decision for one in _events(Path(path)) if one.kind in TOUCHES)
    return min(touched, default=0)


def _events(path: Path) -> Iterator[Event]:
    from rerun.chunk import RrdReader

    if not is_file(path):
        raise HouseholdError(f"{shown_path(path)}: no such file")
    with warnings.catch_warnings():
        # A file that was cut off has no index at its end, and Rerun says so.
        warnings.simplefilter("ignore")
        try:
            for chunk in RrdReader(str(path)).stream():
                if chunk.entity_path.startswith("/events/"):
                    batch = chunk.to_record_batch()
                    columns = (
                        batch.column(name).to_pylist()
                        for name in ("decision", "TextLog:level", "TextLog:text")
                    )
                    for at, kinds, texts in zip(*columns, strict=True):
                        yield Event(int(at), str(kinds[0]), str(texts[0]))
        except (RuntimeError, ValueError, KeyError, TypeError) as error:
            reason = (str(error).splitlines() or [""])[0]
            raise HouseholdError(
                f"{shown_path(path)}: damaged ({shown_path(reason)})"
            ) from None
