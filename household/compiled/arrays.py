"""Kinds of arrays, by what they hold, and how those that are recorded are made."""

from typing import Any, Protocol, get_args

import numpy as np
from numpy.typing import DTypeLike, NDArray

Floats = NDArray[np.float64]

Singles = NDArray[np.float32]
"""In single precision, for arrays that are large or handed to others."""

Indices = NDArray[np.intp]

Integers = NDArray[np.int64]
"""Of the same size on every machine, for what is stored or handed to others."""

Mask = NDArray[np.bool_]


def scalar_of(array: Any) -> type[np.generic]:  # noqa: ANN401 - a type's own type
    """The type of the elements of an array type, as `np.float64` of `Floats`."""
    (*_, last) = get_args(array)
    # Before NumPy 2.5 an array's shape stands first, and `np.dtype[...]` around it.
    kind: type[np.generic] = next(iter(get_args(last)), last)
    return kind


NOBODY = -1
"""In an array of indices: none of them."""


class Zeros(Protocol):
    """Makes an array of zeros that has a name, so that it can be part of a record."""

    def __call__(
        self, name: str, shape: tuple[int, ...], dtype: DTypeLike = ..., /
    ) -> NDArray[Any]:
        """Makes it; in double precision, unless another type is asked for."""


def new_zeros(
    _name: str, shape: tuple[int, ...], dtype: DTypeLike = np.float64, /
) -> NDArray[Any]:
    """Makes an array of zeros in memory of its own, as `Zeros`."""
    return np.zeros(shape, dtype)
