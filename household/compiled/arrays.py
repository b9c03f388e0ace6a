"""Kinds of arrays, by what they hold, and arrays that lie side by side."""

import math
from typing import Any, Protocol

import numpy as np
from numpy.typing import DTypeLike, NDArray

Floats = NDArray[np.float64]

Singles = NDArray[np.float32]
"""In single precision, where many are kept or handed over."""

Indices = NDArray[np.intp]

Integers = NDArray[np.int64]
"""The same size on every machine, for what is stored or handed over."""

Mask = NDArray[np.bool_]

ALIGNED = 8
"""Arrays begin at multiples of this [bytes]."""

NOBODY = -1
"""In an array of indices: none of them."""


class Zeros(Protocol):
    """Makes an array of zeros, as `numpy.zeros` does."""

    def __call__(
        self, shape: tuple[int, ...], dtype: DTypeLike = ..., /
    ) -> NDArray[Any]:
        """Makes it; of double precision, unless told otherwise."""


class SideBySide:
    """Memory for arrays that are to be copied all at once.

    Args:
        size: How much there is [bytes].
    """

    def __init__(self, size: int) -> None:
        self._bytes = np.zeros(size, np.uint8)
        self._used = 0

    @property
    def bytes(self) -> NDArray[np.uint8]:
        """What all arrays hold, one after the other."""
        return self._bytes[: self._used]

    def zeros(
        self, shape: tuple[int, ...], dtype: DTypeLike = np.float64, /
    ) -> NDArray[Any]:
        """Makes an array of zeros beside those that are there.

        Raises:
            ValueError: If there is no room for it.
        """
        kind = np.dtype(dtype)
        begin, size = self._used, math.prod(shape) * kind.itemsize
        self._used += -(-size // ALIGNED) * ALIGNED
        if self._used > len(self._bytes):
            raise ValueError("there is no room for another array")
        return self._bytes[begin : begin + size].view(kind).reshape(shape)

    def begin_of(self, array: NDArray[Any]) -> int:
        """Where in `bytes` an array begins."""
        return int(array.ctypes.data - self._bytes.ctypes.data)
