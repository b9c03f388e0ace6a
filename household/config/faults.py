"""Every fault of plain data against the record that it should become, with its path."""

import math
import re
from collections.abc import Iterable, Iterator
from functools import cache
from itertools import islice
from typing import Annotated, Any, Literal, NamedTuple, get_args, get_origin

import msgspec

from household.errors import LONGEST, choose_from, shown


class Fault(NamedTuple):
    """One thing that is wrong.

    Attributes:
        path: Where, as in ``people[0].script``; empty for the whole.
        text: What is wrong and what is allowed.
        doubtful: Paths of what cannot be relied on because of it, if not of ``path``
            itself. Where a field is misspelt, that is every field that is not there.
    """

    path: str
    text: str
    doubtful: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.path}: {self.text}" if self.path else self.text

    def under(self, path: str) -> "Fault":
        """The same fault of data that are themselves a part of others."""
        doubtful = tuple(joined(path, each) for each in self.doubtful)
        return Fault(joined(path, self.path), self.text, doubtful)


class Sound:
    """Which parts of data can be relied on, so that more can be said about them.

    Args:
        faults: What is wrong.
    """

    def __init__(self, faults: Iterable[Fault] = ()) -> None:
        self._doubtful = [
            _steps(path) for fault in faults for path in fault.doubtful or (fault.path,)
        ]

    def __call__(self, *paths: str) -> bool:
        """Whether no part of what is at any of these paths is in doubt."""
        return not any(
            one[: len(other)] == other[: len(one)]
            for one in map(_steps, paths)
            for other in self._doubtful
        )

    def stands(self, *paths: str) -> bool:
        """Whether each of these is what it should be, but for what is in it.

        A list of the right length, say, of which some items are wrong.
        """
        return not any(
            _steps(path)[: len(other)] == other
            for path in paths
            for other in self._doubtful
        )


def faults(data: Any, kind: Any, path: str = "") -> Iterator[Fault]:
    """Compares data with an annotation, down to every leaf.

    Args:
        data: What a TOML file holds.
        kind: A record, or any annotation that a record's field may have.
        path: Where the data stands, as in ``people[0].script``.

    Yields:
        Each fault with its path and with what is allowed.
    """
    within = _inner_faults(data, kind, path)
    first = next(within, None)
    if first is None:
        yield from _own_faults(data, kind, path)
    else:  # One by one: who wants the first of a million need not wait for the last.
        yield first
        yield from within


MOST = 100
"""Faults that are told; who mends so many checks again."""


def first_faults(data: Any, kind: Any) -> tuple[Fault, ...]:
    """The first faults of data, one more than are told if there are more."""
    return tuple(islice(faults(data, kind), MOST + 1))


def _inner_faults(data: Any, kind: Any, path: str) -> Iterator[Fault]:
    """Faults of what tables and lists hold."""
    record, table = record_in(kind), table_in(kind)
    if isinstance(data, dict) and record is not None:
        yield from _record_faults(data, record, path)
    elif isinstance(data, dict) and table is not None:
        if _is_of_its_size(data, kind):
            for key, value in data.items():
                yield from faults(key, table[0], path)
                yield from faults(value, table[1], joined(path, step_of(key)))
    elif isinstance(data, list | tuple):
        items = items_in(kind, len(data))
        if _is_of_its_size(data, kind):
            for index, (value, item) in enumerate(zip(data, items, strict=False)):
                yield from faults(value, item, f"{path}[{index}]")


def _record_faults(data: dict[str, Any], record: Any, path: str) -> Iterator[Fault]:
    fields = fields_of(record)
    absent = tuple(joined(path, name) for name in fields if name not in data)
    unknown = 0
    for name, value in data.items():
        if name in fields:
            yield from faults(value, fields[name].type, joined(path, name))
            continue
        unknown += 1
        if unknown <= MOST_UNKNOWN:
            yield Fault(path, choose_from(name, fields, "field"), absent or (_NOWHERE,))
    if unknown > MOST_UNKNOWN:
        yield Fault(path, f"{unknown - MOST_UNKNOWN} more unknown fields")
    if data.keys() <= fields.keys():  # Else what seems to be missing is misspelt.
        for name, field in fields.items():
            if field.required and name not in data:
                text = f"missing required field `{name}`"
                yield Fault(path, text, (joined(path, name),))


MOST_UNKNOWN = 100
"""Fields of one table to look for the nearest names of, which takes time."""

_NOWHERE = "/"
"""A path that nothing has: all fields are there, and one too many."""


def _own_faults(data: Any, kind: Any, path: str) -> Iterator[Fault]:
    """What is wrong with a leaf, or with a table or list whose parts are right."""
    if isinstance(data, float) and not math.isfinite(data):
        yield Fault(path, f"{data}; allowed: finite numbers")
        return
    texts = data if isinstance(data, dict) else (data,)
    for text in texts:
        if isinstance(text, str) and not _is_unicode(text):
            yield Fault(path, f"{shown(text)}; allowed: characters of Unicode")
            return
    try:
        msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        text, _, where = str(error).partition(" - at `$")
        if "Invalid enum value" in text:
            text = choose_from(data, _literals_in(kind), "value")
        elif "matching regex" in text and (allowed := _description_in(kind)):
            text = f"{shown(data)}; allowed: {allowed}"
        yield Fault(path + where.rstrip("`"), text)


def _is_unicode(text: str) -> bool:
    """Whether a text can be written: Python's may hold half a pair of surrogates."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def joined(path: str, name: object) -> str:
    """The path of what has a name, or a path of its own, inside what is at a path."""
    return f"{path}.{name}" if path and name else path or str(name)


def step_of(key: object) -> str:
    """The key of a table as a step of a path: on one line and not too long."""
    text = str(key)
    return text if len(text) <= LONGEST and text.isprintable() else shown(text)


def _steps(path: str) -> list[str]:
    """A path, step by step."""
    return re.findall(r"\[\d+\]|[^.\[]+", path)


def _is_of_its_size(data: Any, kind: Any) -> bool:
    """Whether a list or a table may be so long: of a million, nobody looks at each."""
    sizes = [m.max_length for m in _metas(kind) if m.max_length is not None]
    return all(len(data) <= most for most in sizes)


@cache
def _metas(kind: Any) -> list[msgspec.Meta]:
    """What annotates an annotation or one of its alternatives."""
    if get_origin(kind) is Annotated:
        return [*kind.__metadata__, *_metas(get_args(kind)[0])]
    if isinstance(kind, type) or get_origin(kind) in (dict, tuple, Literal):
        return []
    return [meta for option in get_args(kind) for meta in _metas(option)]


def _description_in(kind: Any) -> str | None:
    """What an annotation says of itself, or None."""
    return next((m.description for m in _metas(kind) if m.description), None)


def _parts(kind: Any) -> tuple[Any, ...]:
    """The alternatives of an annotation, without what annotates them."""
    if get_origin(kind) is Annotated:
        return _parts(get_args(kind)[0])
    if isinstance(kind, type) or get_origin(kind) in (dict, tuple, Literal):
        return (kind,)
    return tuple(part for option in get_args(kind) for part in _parts(option))


@cache
def fields_of(record: Any) -> dict[str, Any]:
    """The fields of a record, by the names that they have in files."""
    return {field.encode_name: field for field in msgspec.structs.fields(record)}


@cache
def record_in(kind: Any) -> Any:
    """The record among the alternatives, or None."""
    classes = (part for part in _parts(kind) if isinstance(part, type))
    return next((c for c in classes if issubclass(c, msgspec.Struct)), None)


@cache
def table_in(kind: Any) -> tuple[Any, Any] | None:
    """Annotations of keys and values of the table among the alternatives, or None."""
    tables = (get_args(part) for part in _parts(kind) if get_origin(part) is dict)
    return next(tables, None)


@cache
def _list_in(kind: Any) -> tuple[Any, ...]:
    lists = (get_args(part) for part in _parts(kind) if get_origin(part) is tuple)
    return next(lists, ())


def items_in(kind: Any, length: int) -> tuple[Any, ...]:
    """Annotations of the items of the list among the alternatives; empty if none."""
    items = _list_in(kind)
    return (items[0],) * length if items and items[-1] is Ellipsis else items


def _literals_in(kind: Any) -> list[str]:
    """Every value that an annotation allows by name."""
    choices = (part for part in _parts(kind) if get_origin(part) is Literal)
    return [value for choice in choices for value in get_args(choice)]
