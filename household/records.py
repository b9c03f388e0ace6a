"""Reading TOML into frozen records, with the path of every error."""

import math
import re
import tomllib
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from typing import Any, Literal, TypeVar, get_args, get_origin

import msgspec

from household.errors import HouseholdError, choose_from

T = TypeVar("T")
Point = tuple[float, float]


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
    for path, value in leaves(data):
        if isinstance(value, float) and not math.isfinite(value):
            raise HouseholdError(f"{origin}: {path}: {value}; allowed: finite numbers")
    try:
        return msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        raise HouseholdError(f"{origin}: {explain(str(error), kind, data)}") from None


def leaves(data: object, path: str = "") -> Iterator[tuple[str, object]]:
    """Every value inside nested plain data, with its path."""
    if isinstance(data, dict):
        for name, value in data.items():
            yield from leaves(value, f"{path}.{name}" if path else str(name))
    elif isinstance(data, list | tuple):
        for index, value in enumerate(data):
            yield from leaves(value, f"{path}[{index}]")
    else:
        yield path, data


def explain(message: str, kind: type, data: object) -> str:
    """Rewrites msgspec's message as "path: what is wrong; what is allowed"."""
    text, _, where = message.partition(" - at `")
    # Of a wrong key it says "at `key` in `path`".
    path = where.rpartition("`$")[2] if "`$" in where else where.removeprefix("$")
    path = path.rstrip("`").removeprefix(".")
    if unknown := re.search(r"unknown field `(.+)`", text):
        record = record_in(type_at(kind, path))
        names = [field.encode_name for field in msgspec.structs.fields(record)]
        text = choose_from(unknown.group(1), names, "field")
    elif unknown := re.search(r"Invalid enum value '(.+)'", text):
        allowed = literals_in(type_at(kind, path))
        text = choose_from(unknown.group(1), allowed, "value")
    path = with_keys(path, kind, data)
    return f"{path}: {text}" if path else text


def with_keys(path: str, kind: Any, data: Any) -> str:
    """Puts the key where msgspec leaves it open, as in ``norms[...].attending``."""
    before, gap, after = path.partition("[...]")
    if not gap:
        return path
    tables = (p for p in parts_of(type_at(kind, before)) if get_origin(p) is dict)
    inner = get_args(next(tables))[1]
    for step in re.findall(r"[^.\[\]]+", before):
        data = data[int(step) if step.isdecimal() else step]
    for key, value in data.items():
        try:
            msgspec.convert(value, inner)
        except msgspec.ValidationError:
            return f"{before}.{key}{with_keys(after, inner, value)}"
    return path


def type_at(kind: Any, path: str) -> Any:
    """The annotation found by walking a path such as ``people[0].script[1]``."""
    for name in re.sub(r"\[[^\]]*\]", "", path).split("."):
        record = record_in(kind)
        if name and record is not None:
            fields = {f.encode_name: f.type for f in msgspec.structs.fields(record)}
            kind = fields.get(name, kind)
    return kind


def parts_of(annotation: Any) -> Iterator[Any]:
    """An annotation and all its arguments, as in ``tuple[Person, ...] | None``."""
    yield annotation
    for part in get_args(annotation):
        yield from parts_of(part)


def record_in(annotation: Any) -> Any:
    """The first record class inside an annotation, or None."""
    classes = (part for part in parts_of(annotation) if isinstance(part, type))
    return next((c for c in classes if issubclass(c, msgspec.Struct)), None)


def literals_in(annotation: Any) -> list[str]:
    """Every value that the ``Literal`` inside an annotation allows."""
    literals = (p for p in parts_of(annotation) if get_origin(p) is Literal)
    return [value for literal in literals for value in get_args(literal)]


def shipped(folder: str) -> dict[str, Path]:
    """The TOML files that the package ships in a folder, by name.

    Args:
        folder: A path inside the package, as in "home/homes".
    """
    root = resources.files("household").joinpath(folder)
    paths = sorted(Path(str(entry)) for entry in root.iterdir())
    return {path.stem: path for path in paths if path.suffix == ".toml"}


def locate(name: str, folder: str, what: str) -> Path:
    """The file of a shipped name, or the path itself where a TOML path is given.

    Raises:
        HouseholdError: If neither exists; says what would have been accepted.
    """
    files = shipped(folder)
    if name in files:
        return files[name]
    if name.endswith(".toml"):
        path = Path(name)
        if not path.is_file():
            raise HouseholdError(f"{path}: no such {what} file")
        return path
    raise HouseholdError(
        choose_from(name, files, what) + " or a path that ends in .toml"
    )
