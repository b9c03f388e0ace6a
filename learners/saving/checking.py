"""Whether what a file holds is what the fields of a class are annotated with."""

import math
from collections.abc import Callable, Hashable, Mapping
from functools import cache
from numbers import Integral, Real
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from learners.errors import SavedFileError, shown

_Check = Callable[[Any, tuple[Any, ...]], bool]


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
    origin = get_origin(hint)
    if origin is not None:
        check: _Check = _CONTAINERS.get(origin, _anything)
        return check(value, get_args(hint))
    if hint in _PLAIN:
        return _PLAIN[hint](value)
    if not isinstance(hint, type):
        return True
    if getattr(hint, "_is_protocol", False):
        members = {*vars(hint), *getattr(hint, "__annotations__", {})}
        asked = {m for m in members if m == "__call__" or not m.startswith("_")}
        return not isinstance(value, type) and all(hasattr(value, m) for m in asked)
    return isinstance(value, hint)


def _anything(value: object, args: tuple[Any, ...]) -> bool:
    """Whatever this cannot judge is left to the class."""
    return True


def _in_tuple(value: object, args: tuple[Any, ...]) -> bool:
    if not isinstance(value, tuple):
        return False
    if args[-1] is Ellipsis:
        return all(fits(item, args[0]) for item in value)
    return len(value) == len(args) and all(map(fits, value, args))


def _in_dict(value: object, args: tuple[Any, ...]) -> bool:
    key, item = args
    return isinstance(value, dict) and all(
        fits(k, key) and fits(v, item) for k, v in value.items()
    )


def _is_array(value: object, args: tuple[Any, ...]) -> bool:
    return isinstance(value, np.ndarray) and bool(np.isfinite(value).all())


def _is_hashable(value: object) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True


def _is_one_of(value: object, hints: tuple[Any, ...]) -> bool:
    return any(fits(value, hint) for hint in hints)


def _all_in(
    kind: type[list[Any]] | type[frozenset[Any]],
) -> _Check:
    return lambda value, args: (
        isinstance(value, kind) and all(fits(item, args[0]) for item in value)
    )


_PLAIN: dict[Any, Callable[[Any], bool]] = {
    Any: lambda value: True,
    bool: lambda value: isinstance(value, bool | np.bool_),
    int: lambda value: isinstance(value, Integral),
    float: lambda value: isinstance(value, Real) and _is_finite(value),
    Hashable: _is_hashable,
}

_CONTAINERS: dict[Any, _Check] = {
    Literal: lambda value, args: any(value == each for each in args),
    Union: _is_one_of,
    UnionType: _is_one_of,
    Callable: lambda value, args: callable(value),
    tuple: _in_tuple,
    list: _all_in(list),
    set: _all_in(frozenset),  # as which sets are read
    frozenset: _all_in(frozenset),
    dict: _in_dict,
    np.ndarray: _is_array,
}


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
