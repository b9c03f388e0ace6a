"""Every fault of plain data against the record that it should become, with its path."""

import math
import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal, get_args, get_origin

import msgspec

from household.errors import choose_from


def faults(data: Any, kind: Any, path: str = "") -> Iterator[str]:
    """Compares data with an annotation, down to every leaf.

    Args:
        data: What a TOML file holds.
        kind: A record, or any annotation that a record's field may have.
        path: Where the data stands, as in ``people[0].script``.

    Yields:
        One line for each fault: the path, what is wrong and what is allowed.
    """
    within = tuple(_inner_faults(data, kind, path))
    yield from within or _own_faults(data, kind, path)


def _inner_faults(data: Any, kind: Any, path: str) -> Iterator[str]:
    """Faults of what tables and lists hold."""
    record, table = _record_in(kind), _table_in(kind)
    if isinstance(data, dict) and record is not None:
        yield from _record_faults(data, record, path)
    elif isinstance(data, dict) and table is not None:
        for key, value in data.items():
            yield from faults(key, table[0], path)
            yield from faults(value, table[1], _joined(path, key))
    elif isinstance(data, list | tuple):
        items = _items_in(kind, len(data))
        for index, (value, item) in enumerate(zip(data, items, strict=False)):
            yield from faults(value, item, f"{path}[{index}]")


def _record_faults(data: dict[str, Any], record: Any, path: str) -> Iterator[str]:
    fields = {field.encode_name: field for field in msgspec.structs.fields(record)}
    for name, value in data.items():
        if name in fields:
            yield from faults(value, fields[name].type, _joined(path, name))
        else:
            yield _line(path, choose_from(name, fields, "field"))
    if data.keys() <= fields.keys():  # Else what seems to be missing is misspelt.
        for name, field in fields.items():
            if field.required and name not in data:
                yield _line(path, f"missing required field `{name}`")


def _own_faults(data: Any, kind: Any, path: str) -> Iterator[str]:
    """What is wrong with a leaf, or with a table or list whose parts are right."""
    if isinstance(data, float) and not math.isfinite(data):
        yield _line(path, f"{data}; allowed: finite numbers")
        return
    try:
        msgspec.convert(data, kind)
    except msgspec.ValidationError as error:
        text, _, where = str(error).partition(" - at `$")
        if wrong := re.search(r"Invalid enum value '(.+)'", text):
            text = choose_from(wrong.group(1), _literals_in(kind), "value")
        yield _line(path + where.rstrip("`"), text)


def _line(path: str, text: str) -> str:
    return f"{path}: {text}" if path else text


def _joined(path: str, name: object) -> str:
    return f"{path}.{name}" if path else str(name)


def _parts(kind: Any) -> tuple[Any, ...]:
    """The alternatives of an annotation, without what annotates them."""
    if get_origin(kind) is Annotated:
        return _parts(get_args(kind)[0])
    if isinstance(kind, type) or get_origin(kind) in (dict, tuple, Literal):
        return (kind,)
    return tuple(part for option in get_args(kind) for part in _parts(option))


def _record_in(kind: Any) -> Any:
    """The record among the alternatives, or None."""
    classes = (part for part in _parts(kind) if isinstance(part, type))
    return next((c for c in classes if issubclass(c, msgspec.Struct)), None)


def _table_in(kind: Any) -> tuple[Any, Any] | None:
    """Annotations of keys and values of the table among the alternatives, or None."""
    tables = (get_args(part) for part in _parts(kind) if get_origin(part) is dict)
    return next(tables, None)


def _items_in(kind: Any, length: int) -> tuple[Any, ...]:
    """Annotations of the items of the list among the alternatives; empty if none."""
    lists = (get_args(part) for part in _parts(kind) if get_origin(part) is tuple)
    items = next(lists, ())
    return (items[0],) * length if items and items[-1] is Ellipsis else items


def _literals_in(kind: Any) -> list[str]:
    """Every value that an annotation allows by name."""
    choices = (part for part in _parts(kind) if get_origin(part) is Literal)
    return [value for choice in choices for value in get_args(choice)]
