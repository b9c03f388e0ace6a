"""Writing a home as TOML, so that it can be kept, read, edited and loaded again."""

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
    """A home as TOML.

    Args:
        plan: The home.

    Returns:
        Text that reads back as an equal plan.
    """
    return msgspec.toml.encode(plan).decode()
