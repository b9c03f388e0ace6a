"""Writing a home as TOML, so that it can be kept, read, edited and loaded again."""

import json
from collections.abc import Iterator
from pathlib import Path

import msgspec

from household.errors import HouseholdError
from household.home.floorplan import FloorPlan


def save_floorplan(plan: FloorPlan, path: Path | str) -> None:
    """Writes a home to a file that ``load_floorplan`` reads.

    Args:
        plan: The home.
        path: File to write; ends in ".toml", or it could not be loaded by path.

    Raises:
        HouseholdError: If the file cannot be written or its name has another ending.
    """
    if Path(path).suffix != ".toml":
        raise HouseholdError(f"{path}: not a home file; allowed: a name in .toml")
    try:
        Path(path).write_text(to_toml(plan), encoding="utf-8")
    except OSError as error:
        raise HouseholdError(f"{path}: {error.strerror}") from None


def to_toml(plan: FloorPlan) -> str:
    """A home as TOML, one wall, door, room, ... per line.

    Args:
        plan: The home.

    Returns:
        Text that reads back as an equal plan.
    """
    fields: dict[str, object] = msgspec.to_builtins(plan)
    return "".join(f"{line}\n" for line in _lines(fields))


def _lines(fields: dict[str, object]) -> Iterator[str]:
    for name, value in fields.items():
        if isinstance(value, list | tuple):
            yield f"{name} = ["
            yield from (f"  {_text(item)}," for item in value)
            yield "]"
        else:
            yield f"{name} = {_text(value)}"


def _text(value: object) -> str:
    """A value in TOML's inline form."""
    if isinstance(value, dict):
        pairs = (f"{name} = {_text(item)}" for name, item in value.items())
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_text, value)) + "]"
    if isinstance(value, str):
        # JSON's strings are TOML's, but for the delete character.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value)
