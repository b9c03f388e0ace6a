"""`study.json`, which says what was run: read, checked and compared."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import msgspec

from experiments.errors import ExperimentError
from experiments.running.trial_files import FORMAT

LARGEST = 2**26
"""Of a study file [bytes]; the largest of ours have some hundred thousand."""

MOST_SEEDS = 10**6


class Session(msgspec.Struct, frozen=True, kw_only=True):
    """With what some of the trials were run."""

    versions: dict[str, str]
    """Of Python and of packages."""

    commit: str | None
    """Of this code; None if it was in no repository."""


class StudyFile(msgspec.Struct, frozen=True, kw_only=True):
    """What a study file holds."""

    study: str
    """Name of the study."""

    seeds: Annotated[
        tuple[Annotated[int, msgspec.Meta(ge=0)], ...],
        msgspec.Meta(min_length=1, max_length=MOST_SEEDS),
    ]
    """Which every condition is run with."""

    sessions: Annotated[tuple[Session, ...], msgspec.Meta(min_length=1)]
    """Those that ran its trials."""

    configuration: dict[str, Any]
    """What fixes every result but the seeds."""


def read_study_file(path: Path) -> dict[str, Any]:
    """Returns the content of a study file as plain data.

    Raises:
        ExperimentError: If it is missing, damaged or of another format.
    """
    document = _decoded(path)
    if document.get("format") != FORMAT:
        from household.errors import shown

        raise ExperimentError(
            f"{path}: holds results in format {shown(document.get('format'))}, this "
            f"version reads format {FORMAT}. Choose another --out, or delete "
            f"{path.parent}, and run it again."
        )
    try:
        known = msgspec.convert(document, StudyFile)
    except msgspec.ValidationError as error:
        raise ExperimentError(f"{path}: damaged ({error}).") from error
    if len(set(known.seeds)) < len(known.seeds):
        raise ExperimentError(f"{path}: damaged (a seed comes twice).")
    return document


def _decoded(path: Path) -> dict[str, Any]:
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
        if len(content) > LARGEST:
            raise ExperimentError(f"{path}: larger than {LARGEST} bytes.")
        return msgspec.json.decode(content, type=dict)
    except OSError as error:
        raise ExperimentError(f"{path}: {error.strerror}.") from error
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ExperimentError(f"{path}: damaged ({error}).") from error
    except RecursionError as error:
        raise ExperimentError(f"{path}: damaged (nested too deeply).") from error


def first_difference(stored: object, asked: object, path: str = "") -> str | None:
    """Returns where two pieces of plain data first differ, in words, or None."""
    from household.config.faults import joined, step_of

    if isinstance(stored, dict) and isinstance(asked, dict):
        for key in [*stored, *(key for key in asked if key not in stored)]:
            inner = joined(path, step_of(key))
            found = first_difference(stored.get(key), asked.get(key), inner)
            if found:
                return found
        return None
    if (
        isinstance(stored, list)
        and isinstance(asked, list)
        and len(stored) == len(asked)
    ):
        for index, (one, other) in enumerate(zip(stored, asked, strict=True)):
            found = first_difference(one, other, f"{path}[{index}]")
            if found:
                return found
        return None
    if stored == asked:
        return None
    return f"{path}: stored {_short(stored)}, asked for {_short(asked)}"


def _short(value: object, length: int = 60) -> str:
    from household.errors import printable

    text = printable(msgspec.json.encode(value).decode())
    return text if len(text) <= length else text[: length - 3] + "..."
