"""Reading TOML into frozen records, with the path of every error."""

import tomllib
from importlib import resources
from pathlib import Path
from typing import Any, Literal, TypeVar

import msgspec

from household.config.faults import faults
from household.errors import HouseholdError, choose_from

T = TypeVar("T")
Point = tuple[float, float]

Kind = Literal["scenario", "persona", "home", "family"]

FOLDERS: dict[Kind, str] = {
    "scenario": "scenario/scenarios",
    "persona": "scenario/personas",
    "home": "home/homes",
    "family": "scenario/families",
}
"""Where the package keeps what it ships."""


class Record(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A frozen record; unknown fields are errors, not surprises.

    Subclasses say ``frozen=True, kw_only=True`` themselves: msgspec does not inherit
    the second, and type checkers do not see the first.
    """


def read_toml(path: Path) -> dict[str, Any]:
    """Reads a TOML file.

    Raises:
        HouseholdError: If the file cannot be read or is not TOML.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise HouseholdError(f"{path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise HouseholdError(f"{path}: not valid TOML: {error}") from None


def convert(data: object, kind: type[T], origin: str) -> T:
    """Turns plain data into a record and checks every field.

    Args:
        data: What a TOML file holds.
        kind: The record to make.
        origin: The file's name, for error messages.

    Raises:
        HouseholdError: Names the file, the path inside it and what is allowed.
    """
    for fault in faults(data, kind):
        raise HouseholdError(f"{origin}: {fault}")
    return msgspec.convert(data, kind)


def shipped(kind: Kind) -> dict[str, Path]:
    """The TOML files of a kind that the package ships, by name."""
    root = packaged(FOLDERS[kind])
    paths = sorted(root / entry.name for entry in root.iterdir())
    return {path.stem: path for path in paths if path.suffix == ".toml"}


def packaged(path: str) -> Path:
    """A file or folder inside the package, such as "scenario/norms.toml"."""
    return Path(str(resources.files("household").joinpath(path)))


def locate(name: str, kind: Kind) -> Path:
    """The file of a shipped name, or the path itself where a TOML path is given.

    Raises:
        HouseholdError: If neither exists; says what would have been accepted.
    """
    files = shipped(kind)
    if name in files:
        return files[name]
    if name.endswith(".toml"):
        path = Path(name)
        if not path.is_file():
            raise HouseholdError(f"{path}: no such {kind} file")
        return path
    raise HouseholdError(
        choose_from(name, files, kind) + " or a path that ends in .toml"
    )
