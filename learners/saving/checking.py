"""Whether what a file holds is what the fields of a class are annotated with."""

import math
from collections.abc import Callable, Hashable, Mapping
from functools import cache
from numbers import Integral, Real
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from learners.errors import SavedFileError, shown

_Check = Callable[[Any], bool]


def check_fields(cls: type, values: Mapping[str, object]) -> None:
    """Refuse values that are not what a dataclass declares.

    Args:
        cls: the class.
        values: by the name of the field.

    Raises:
        SavedFileError: if one is of another type, or a number is not finite.
    """
    hints = _hints(cls)
    for name, value in values.items():
        if not fits(value, hints.get(name, Any)):
            raise SavedFileError(
                f"{name} of a {cls.__name__} is {shown(value)}, which it cannot be"
            )


def fits(value: Any, hint: Any) -> bool:  # noqa: ANN401 - any value of any type
    """Whether a value is of an annotated type; numbers must be finite."""
    return _check_of(hint)(value)


@cache  # Of annotations there are few, of values millions.
def _check_of(hint: object) -> _Check:
    origin = get_origin(hint)
    if origin in _CONTAINERS:
        return _CONTAINERS[origin](get_args(hint))
    if origin is not None:  # Whatever this cannot judge is left to the class.
        return _anything
    if hint in _PLAIN:
        return _PLAIN[hint]
    if not isinstance(hint, type):
        return _anything
    if getattr(hint, "_is_protocol", False):
        members = {*vars(hint), *getattr(hint, "__annotations__", {})}
        asked = {m for m in members if m == "__call__" or not m.startswith("_")}
        return lambda value: (
            not isinstance(value, type) and all(hasattr(value, m) for m in asked)
        )
    return lambda value: isinstance(value, hint)


def _anything(value: object) -> bool:
    return True


def _tuple_of(args: tuple[Any, ...]) -> _Check:
    if args[-1] is Ellipsis:
        return _all_in(tuple)(args)
    checks = tuple(map(_check_of, args))
    return lambda value: (
        isinstance(value, tuple)
        and len(value) == len(checks)
        and all(check(item) for check, item in zip(checks, value, strict=True))
    )


def _dict_of(args: tuple[Any, ...]) -> _Check:
    of_key, of_item = map(_check_of, args)
    return lambda value: (
        isinstance(value, dict)
        and all(map(of_key, value))
        and all(map(of_item, value.values()))
    )


def _array(args: tuple[Any, ...]) -> _Check:
    return lambda value: (
        isinstance(value, np.ndarray) and bool(np.isfinite(value).all())
    )


def _any_of(args: tuple[Any, ...]) -> _Check:
    checks = tuple(map(_check_of, args))
    return lambda value: any(check(value) for check in checks)


def _all_in(
    kind: type[list[Any]] | type[frozenset[Any]] | type[tuple[Any, ...]],
) -> Callable[[tuple[Any, ...]], _Check]:
    def of(args: tuple[Any, ...]) -> _Check:
        check = _check_of(args[0])
        return lambda value: isinstance(value, kind) and all(map(check, value))

    return of


def _is_hashable(value: object) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True


_PLAIN: dict[Any, _Check] = {
    Any: _anything,
    bool: lambda value: isinstance(value, bool | np.bool_),
    int: lambda value: isinstance(value, Integral),
    float: lambda value: isinstance(value, Real) and _is_finite(value),
    Hashable: _is_hashable,
}

_CONTAINERS: dict[Any, Callable[[tuple[Any, ...]], _Check]] = {
    Literal: lambda args: lambda value: any(value == each for each in args),
    Union: _any_of,
    UnionType: _any_of,
    Callable: lambda args: callable,
    tuple: _tuple_of,
    list: _all_in(list),
    set: _all_in(frozenset),  # as which sets are read
    frozenset: _all_in(frozenset),
    dict: _dict_of,
    np.ndarray: _array,
}
"""Makes the check of a container from what it holds."""


def _is_finite(number: Real) -> bool:
    try:
        return math.isfinite(number)
    except OverflowError:  # A whole number that no float can be.
        return False


@cache
def _hints(cls: type) -> dict[str, Any]:
    """What the fields of a class are annotated with, as far as that can be known."""
    try:
        return get_type_hints(cls)
    except (NameError, TypeError):  # Names that only type checkers see.
        return {}
