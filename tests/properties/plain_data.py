"""Plain data, as TOML files and callers give them: what is allowed, and what is not.

Allowed values are derived from the annotations of the records; the others are changes
of data that are right: a part dropped, retyped, enlarged, doubled, moved, or exchanged
for something odd.
"""

import datetime
import math
from collections.abc import Callable
from functools import cache
from typing import Any

import msgspec
from hypothesis import strategies as st

from household.config.faults import fields_of, items_in, record_in, table_in

ODD_NUMBERS = (
    *(math.nan, math.inf, -math.inf, 0.0, -0.0, 5e-324, 1e-9, 1e300, 1.8e308, -1e300),
    *(0, 1, -1, 2**31, 2**53 + 1, 2**63 - 1, 2**63, -(2**63), 2**64, 10**400),
)

ODD_TEXTS = (
    *("", " ", "\n", "two\nlines", "\x00", "\x1b[31m", "\ufeff", "\u202e", "\ud800"),
    *("e\u0301", "\U0001f916", "\u0130", "[b]", "[/b]", "{}", "%s", "../..", "robot_0"),
    *("a" * 101, "a" * 5000, "nan", "-1", "None", "con.toml", "/dev/zero.toml"),
)

ODD_TABLES = (
    *([], {}, [[]], [{}], {"": {}}, {"name": []}, [None] * 3, [0.0] * 3, ["a", 1]),
    *([0] * 2000, {str(i): i for i in range(600)}),
)

DATES = (
    datetime.date(1, 1, 1),
    datetime.datetime(9999, 12, 31, 23, 59, 59),
    datetime.time(0, 0),
)
"""TOML has them, and nothing of ours asks for one."""


LARGEST = 20_000
"""Items or characters: this process, too, has to keep what it makes up."""


def nested(depth: int) -> list[Any]:
    """Lists in lists."""
    data: list[Any] = []
    for _ in range(depth):
        data = [data]
    return data


ODD = st.one_of(
    st.sampled_from(ODD_NUMBERS),
    st.sampled_from(ODD_TEXTS),
    st.sampled_from(ODD_TABLES),
    st.sampled_from(DATES),
    st.sampled_from((True, False, None)),
    st.sampled_from((3, 40)).map(nested),
    st.floats(),
    st.integers(),
    st.text(max_size=8),
)
"""What nobody should write there."""


@cache
def allowed(kind: Any) -> st.SearchStrategy[Any]:
    """Plain data that an annotation allows, also at its limits."""
    return _allowed(msgspec.inspect.type_info(kind))


def _allowed(info: Any) -> st.SearchStrategy[Any]:
    return _BY_TYPE[type(info).__name__](info)


def _numbers(info: Any, draw: Callable[..., st.SearchStrategy[Any]]) -> Any:
    least = info.ge if info.ge is not None else info.gt
    most = info.le if info.le is not None else info.lt
    ends = [end for end in (info.ge, info.le) if end is not None]
    within = draw(least, most)
    return st.one_of(st.sampled_from(ends), within) if ends else within


def _integers(info: Any) -> st.SearchStrategy[int]:
    return _numbers(info, st.integers)


def _floats(info: Any) -> st.SearchStrategy[float]:
    def draw(least: float | None, most: float | None) -> st.SearchStrategy[float]:
        return st.floats(
            least,
            most,
            exclude_min=info.gt is not None,
            exclude_max=info.lt is not None,
            allow_nan=False,
            allow_infinity=False,
        )

    return _numbers(info, draw)


def _texts(info: Any) -> st.SearchStrategy[str]:
    texts = (
        st.text(max_size=12)
        if info.pattern is None
        else st.from_regex(info.pattern, fullmatch=True)
    )
    longest = info.max_length
    return texts if longest is None else texts.filter(lambda t: len(t) <= longest)


def _sizes(info: Any) -> dict[str, int]:
    least = info.min_length or 0
    return {"min_size": least, "max_size": max(least, min(info.max_length or 4, 4))}


def _records(info: Any) -> st.SearchStrategy[dict[str, Any]]:
    fields = {field.encode_name: field for field in info.fields}
    strategies = {name: _allowed(field.type) for name, field in fields.items()}
    needed = {name for name, field in fields.items() if field.required}
    return st.fixed_dictionaries(
        {name: each for name, each in strategies.items() if name in needed},
        optional={n: each for n, each in strategies.items() if n not in needed},
    )


_BY_TYPE: dict[str, Callable[[Any], st.SearchStrategy[Any]]] = {
    "Metadata": lambda info: _allowed(info.type),
    "NoneType": lambda info: st.none(),
    "BoolType": lambda info: st.booleans(),
    "IntType": _integers,
    "FloatType": _floats,
    "StrType": _texts,
    "LiteralType": lambda info: st.sampled_from(info.values),
    "UnionType": lambda info: st.one_of(*map(_allowed, info.types)),
    "TupleType": lambda info: st.tuples(*map(_allowed, info.item_types)).map(list),
    "VarTupleType": lambda info: st.lists(_allowed(info.item_type), **_sizes(info)),
    "DictType": lambda info: st.dictionaries(
        _allowed(info.key_type), _allowed(info.value_type), **_sizes(info)
    ),
    "StructType": _records,
}


def _inside(kind: Any, key: Any, length: int) -> Any:
    """The annotation of a part, None if there is none."""
    if kind is None:
        return None
    if isinstance(key, int):
        items = items_in(kind, length)
        return items[key] if key < len(items) else None
    record, table = record_in(kind), table_in(kind)
    if record is not None:
        field = fields_of(record).get(key)
        return field and field.type
    return table and table[1]


INSIDE = ("inside",) * 12


@st.composite
def changed(draw: Any, data: Any, kind: Any, most: int = 4) -> Any:
    """Data with a few changes: in half of the cases, only such as might be right.

    Args:
        data: What is right.
        kind: The record that it should become; None: whatever it is.
        most: How many changes at most.
    """
    gentle = draw(st.booleans())
    for _ in range(draw(st.integers(1, most))):
        data = draw(_changed_once(data, kind, gentle))
    return data


@st.composite
def _changed_once(draw: Any, data: Any, kind: Any, gentle: bool) -> Any:
    keys = (
        list(data)
        if isinstance(data, dict)
        else list(range(_length(data) if isinstance(data, list) else 0))
    )
    record = kind and record_in(kind)
    if record is not None and isinstance(data, dict):
        keys += [name for name in fields_of(record) if name not in data]
    if not keys or draw(st.sampled_from((False,) * 30 + (not gentle,))):
        return draw(_exchanged(data, kind, gentle))
    parts = [key for key in keys if _has(data, key) and _length(data[key])]
    key = draw(st.sampled_from(keys + parts * 3))  # Most of it lies deeper.
    inner = _inside(kind, key, len(data))
    if isinstance(data, dict):
        return draw(_changed_table(data, key, inner, gentle))
    return draw(_changed_list(data, key, inner, gentle))


@st.composite
def _changed_list(draw: Any, data: list[Any], at: int, kind: Any, gentle: bool) -> Any:
    how = draw(
        st.sampled_from(INSIDE + (("drop", "double", "move", "many") * (not gentle)))
    )
    before, part, after = data[:at], data[at], data[at + 1 :]
    if how == "inside":
        return [*before, draw(_changed_once(part, kind, gentle)), *after]
    if how == "many":
        times = draw(st.sampled_from((3, 70, 600) if _length(part) < 5 else (3,)))
        return [*before, *[part] * times, *after]
    if how == "move":
        return [*after, part, *before]
    return [*before, *[part] * (2 if how == "double" else 0), *after]


@st.composite
def _changed_table(
    draw: Any, data: dict[str, Any], key: str, kind: Any, gentle: bool
) -> Any:
    if key not in data:
        return data | {key: draw(allowed(kind) if gentle else ODD)}
    ways = ("drop", "double", "rename", "swap") * (not gentle)
    how = draw(st.sampled_from(INSIDE + ways))
    rest = {name: value for name, value in data.items() if name != key}
    if how == "inside":
        return data | {key: draw(_changed_once(data[key], kind, gentle))}
    if how == "double":
        return data | {f"{key}_2": data[key]}
    if how == "rename":
        return rest | {draw(st.sampled_from(ODD_TEXTS)): data[key]}
    if how == "swap":
        other = draw(st.sampled_from(list(data)))
        return data | {key: data[other], other: data[key]}
    return rest


def _length(data: Any) -> int:
    return len(data) if isinstance(data, dict | list) else 0


def _has(data: Any, key: Any) -> bool:
    return not isinstance(data, dict) or key in data


@st.composite
def _exchanged(draw: Any, data: Any, kind: Any, gentle: bool) -> Any:
    """Something in the place of a value: another allowed one, a neighbor, or not."""
    ways = [] if gentle and kind is not None else ["odd", "retyped", "enlarged"]
    ways += ["allowed"] if kind is not None else []
    ways += ["near"] if isinstance(data, int | float) else []
    way = draw(st.sampled_from(ways))
    if way == "allowed":
        return draw(allowed(kind))
    if way == "near":
        return data + draw(st.sampled_from((-1, 1, 0.5, -0.25, 1e-9)))
    if way == "retyped":
        return draw(st.sampled_from((str(data), [data], {"value": data}, bool(data))))
    if way == "enlarged":
        return _enlarged(data, draw(st.sampled_from((2, 30, 1000))))
    return draw(ODD)


def _enlarged(data: Any, factor: int) -> Any:
    if isinstance(data, dict | list | str) and len(data) * factor > LARGEST:
        return data
    inner = data.values() if isinstance(data, dict) else data
    if _length(data) and any(map(_length, inner)):
        factor = 2
    if isinstance(data, dict):
        return {f"{key}_{i}": v for key, v in data.items() for i in range(factor)}
    if data is None or isinstance(data, bool | datetime.date | datetime.time):
        return [data] * factor
    return data * factor
