"""Reading TOML into frozen records, with the path of every error."""

import tomllib
from collections.abc import Mapping
from functools import cache, lru_cache
from importlib import resources
from pathlib import Path
from typing import Any, Literal, TypeVar

import msgspec

from household.config.faults import faults
from household.errors import HouseholdError, choose_from, shown_path

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

LARGEST = 2**18
"""Of a file [bytes]: ten times the largest that is shipped."""

MOST_WORK = 10**7
"""That the keys of a file may make: for its reader it grows with the square of their
parts, which one line can have thousands of. It is a second."""

DEEPEST = 32
"""How deeply tables and lists of a file may be nested; ours are by six levels."""


class Record(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A frozen record; unknown fields are errors, not surprises.

    Subclasses say ``frozen=True, kw_only=True`` themselves: msgspec does not inherit
    the second, and type checkers do not see the first.
    """


def read_toml(path: Path) -> dict[str, Any]:
    """Reads a TOML file.

    Raises:
        HouseholdError: If the file cannot be read, is too large or is not TOML.
    """
    return _parsed(_text(path), shown_path(path))


def load(path: Path, kind: type[T]) -> T:
    """Reads a TOML file into a record, as it is now.

    What was read is remembered by what the file holds, never by its name: somebody may
    edit it in between.

    Raises:
        HouseholdError: If the file cannot be read, or names the path inside it.
    """
    record: Any = kind  # Type checkers take a class for something unhashable.
    return _made(_text(path), record, shown_path(path))


@lru_cache(maxsize=256)
def _made(text: str, kind: Any, origin: str) -> Any:  # noqa: ANN401 - see `load`
    return convert(_parsed(text, origin), kind, origin)


def read_file(path: Path) -> bytes:
    """What a file holds, if it can be a file of ours.

    Raises:
        HouseholdError: If the file cannot be read or is too large.
    """
    origin = shown_path(path)
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
    except OSError as error:
        raise HouseholdError(f"{origin}: {error.strerror}") from None
    except ValueError as error:  # A name that no file can have.
        raise HouseholdError(f"{origin}: {error}") from None
    if len(content) > LARGEST:
        raise HouseholdError(f"{origin}: larger than {LARGEST} bytes")
    return content


def _text(path: Path) -> str:
    try:
        return read_file(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise _not_toml(shown_path(path), str(error)) from None


def _parsed(text: str, origin: str) -> dict[str, Any]:
    if _work_of_keys(text) > MOST_WORK:
        raise HouseholdError(f"{origin}: too many dots in a line; allowed: a few")
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _not_toml(origin, str(error)) from None
    except ValueError:  # Python's own limit, which it explains to programmers.
        raise _not_toml(origin, "a number of thousands of digits") from None
    except RecursionError:
        raise _too_deep(origin) from None
    if _is_too_deep(data):
        raise _too_deep(origin)
    return data


def _work_of_keys(text: str) -> int:
    """About how much work the keys of a file make; a key has no more parts than dots.

    Those under a header have its parts, too.
    """
    work = header = 0
    for line in text.split("\n"):
        dots = line.count(".")
        header = dots if line.lstrip().startswith("[") else header
        work += dots**2 + header
    return work


def _not_toml(origin: str, why: str) -> HouseholdError:
    return HouseholdError(f"{origin}: not valid TOML: {why}")


def _too_deep(origin: str) -> HouseholdError:
    return HouseholdError(
        f"{origin}: nested too deeply; allowed: up to {DEEPEST} levels"
    )


def _is_too_deep(data: object) -> bool:
    """Whether data is nested beyond the limit; itself without recursion."""
    level = [data]
    for _ in range(DEEPEST):
        level = [
            inner
            for outer in level
            if isinstance(outer, dict | list)
            for inner in (outer.values() if isinstance(outer, dict) else outer)
        ]
    return bool(level)


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


@cache
def shipped(kind: Kind) -> Mapping[str, Path]:
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
        if not is_file(path):
            raise HouseholdError(f"{shown_path(path)}: no such {kind} file")
        return path
    raise HouseholdError(
        choose_from(name, files, kind) + " or a path that ends in .toml"
    )


def is_file(path: Path) -> bool:
    """Whether there is a file of a name, which may be one that no file can have."""
    try:
        return path.is_file()
    except (OSError, ValueError):  # Too long a name for this system, or no name at all.
        return False
