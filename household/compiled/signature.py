"""Signatures: what a bound function takes, read off its annotations, and its check.

An array is annotated with its shape, as in ``Annotated[Floats, "n", 2]``: as many rows
as all other arrays that have an ``"n"``, and two columns. Arrays that belong together
travel as a record: a `typing.NamedTuple` whose fields are annotated in the same way.
"""

from collections.abc import Callable, Sequence
from functools import lru_cache
from inspect import signature
from numbers import Integral, Real
from typing import Any, get_args, get_origin, get_type_hints

import numba
import numpy as np
from numba import boolean, float64, from_dtype, intp, types
from numba.core.errors import NumbaError
from numba.np.numpy_support import as_dtype

from household.compiled.arrays import scalar_of

typeof: Callable[[object], Any] = numba.typeof
tuple_of: Callable[..., Any] = types.BaseTuple.from_types
"""Numba's own; it is not annotated."""

NUMBERS: dict[Any, Any] = {float: float64, int: intp, bool: boolean}
"""Numba's types of plain numbers, by their annotation."""

ACCEPTED: dict[Any, tuple[type, ...]] = {
    float64: (Real,),
    intp: (Integral,),
    boolean: (bool, np.bool_),
}
"""What may be handed over for them: Numba would cut off the fraction of an index."""

Sizes = dict[str, int]
"""How long each named axis is, as the first array has it that has such an axis."""

Check = Callable[[object, Sizes], None]
"""Raises an error if an argument is not what it should be."""


@lru_cache
def parameters_of(function: Callable[..., Any]) -> dict[str, Any]:
    """What each parameter of a function, compiled or not, is annotated with."""
    plain = getattr(function, "py_func", function)
    hints = get_type_hints(plain, include_extras=True)
    return {name: hints.get(name) for name in signature(plain).parameters}


@lru_cache
def kind_of(annotation: Any) -> Any:  # noqa: ANN401
    """The Numba type of what has an annotation.

    Args:
        annotation: That of a number or of an array with its shape, a record's class, or
            a tuple of such.

    Raises:
        TypeError: If it does not say enough, as that of an array without a shape.
    """
    if annotation in NUMBERS:
        return NUMBERS[annotation]
    if _is_record(annotation):
        kinds = tuple(map(kind_of, _fields(annotation).values()))
        return tuple_of(kinds, annotation)
    if get_origin(annotation) is tuple:
        return tuple_of(tuple(map(kind_of, get_args(annotation))))
    shape = _shape(annotation)
    if not shape:
        raise TypeError(f"no number, record or array with a shape: {annotation}")
    # Any layout: arrays may have gaps.
    return types.Array(from_dtype(_dtype(annotation)), len(shape), "A")


def check_of(name: str, annotation: Any) -> Check:  # noqa: ANN401
    """The check of an argument.

    Args:
        name: What to call it in errors.
        annotation: As for `kind_of`.
    """
    if _is_record(annotation):
        fields = _fields(annotation).items()
        parts = [check_of(f"{name}.{field}", part) for field, part in fields]
        return _check_parts(name, annotation, parts)
    if get_origin(annotation) is tuple:
        items = enumerate(get_args(annotation))
        parts = [check_of(f"{name}[{k}]", part) for k, part in items]
        return _check_parts(name, tuple, parts)
    kind = kind_of(annotation)
    if _shape(annotation):
        return _check_array(name, kind, _shape(annotation))
    return _check_number(name, kind)


def says_enough(annotation: Any) -> bool:  # noqa: ANN401
    """Whether an annotation tells what an argument must be."""
    return _is_record(annotation) or annotation in NUMBERS or bool(_shape(annotation))


def _check_parts(name: str, kind: type, parts: Sequence[Check]) -> Check:
    def check(value: object, sizes: Sizes) -> None:
        if not (isinstance(value, tuple) and isinstance(value, kind)):
            raise _error(name, kind.__name__, type(value).__name__)
        if len(value) != len(parts):
            raise _error(name, f"{len(parts)} items", str(len(value)))
        for check_part, item in zip(parts, value, strict=True):
            check_part(item, sizes)

    return check


def _check_array(name: str, kind: Any, shape: tuple[str | int, ...]) -> Check:  # noqa: ANN401
    dtype = as_dtype(kind.dtype)

    def check(value: object, sizes: Sizes) -> None:
        if not (
            isinstance(value, np.ndarray)
            and value.dtype == dtype
            and value.ndim == kind.ndim
            and value.flags.behaved  # Aligned, and not for reading only.
        ):
            raise _error(name, kind, _kind_in_words(value))
        for axis, size in zip(shape, value.shape, strict=True):
            known = sizes.setdefault(axis, size) if isinstance(axis, str) else axis
            if known != size:
                sought = tuple(sizes.get(str(axis), axis) for axis in shape)
                raise _error(name, f"shape {sought}", f"shape {value.shape}")

    return check


def _check_number(name: str, kind: Any) -> Check:  # noqa: ANN401
    def check(value: object, sizes: Sizes) -> None:
        if not isinstance(value, ACCEPTED[kind]):
            raise _error(name, kind, _kind_in_words(value))

    return check


def _error(name: str, expected: object, got: str) -> TypeError:
    return TypeError(f"{name}: expected {expected}, got {got}")


def _kind_in_words(value: object) -> str:
    aligned = not isinstance(value, np.ndarray) or value.flags.aligned
    try:
        return f"{typeof(value)}{'' if aligned else ', not aligned'}"
    except (NumbaError, ValueError):  # It knows no such thing.
        return str(getattr(value, "dtype", type(value).__name__))


def _is_record(annotation: Any) -> bool:  # noqa: ANN401
    return isinstance(annotation, type) and hasattr(annotation, "_fields")


def _fields(record: Any) -> dict[str, Any]:  # noqa: ANN401
    return get_type_hints(record, include_extras=True)


def _shape(annotation: Any) -> tuple[str | int, ...]:  # noqa: ANN401
    return getattr(annotation, "__metadata__", ())


def _dtype(annotation: Any) -> np.dtype[Any]:  # noqa: ANN401
    """The data type in ``Annotated[NDArray[...], ...]``."""
    return np.dtype(scalar_of(get_args(annotation)[0]))
