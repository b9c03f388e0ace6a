"""Digests of plain values: the same in every process, whatever types are called.

Records are taken apart before by those who know them, so that nothing here depends on
where a class is defined or how it prints itself.
"""

import hashlib
import struct
from collections import defaultdict
from collections.abc import Mapping
from numbers import Integral, Real

import numpy as np

LENGTH = 16
"""Hexadecimal digits of a digest: 64 bits, short enough to be compared by eye."""


class Digests:
    """A digest for each subject, so that a difference says what it is in."""

    def __init__(self) -> None:
        self._sums = defaultdict(hashlib.sha256)

    def add(self, subject: str, value: object) -> None:
        """Takes one more value into the digest of a subject."""
        self._sums[subject].update(encoded(value))

    def told(self) -> dict[str, str]:
        """The digest of each subject so far."""
        return {name: each.hexdigest()[:LENGTH] for name, each in self._sums.items()}


def encoded(value: object) -> bytes:
    """A value as bytes; whether numbers are Python's or NumPy's makes no difference.

    Raises:
        TypeError: If it is anything but plain values in lists and mappings.
    """
    for kinds, encode in ENCODINGS.items():
        if isinstance(value, kinds):
            return encode(value)
    raise TypeError(f"no encoding of {type(value).__name__}: {value!r}")


def _text(value: str) -> bytes:
    data = value.encode()
    return b"s%d:%b" % (len(data), data)


def _array(value: np.ndarray) -> bytes:
    shape = b"x".join(b"%d" % n for n in value.shape)
    little = value.astype(value.dtype.newbyteorder("<"))
    return b"a%b(%b)%b" % (little.dtype.str.encode(), shape, little.tobytes())


def _sequence(value: tuple | list) -> bytes:
    return b"l%d:%b" % (len(value), b"".join(map(encoded, value)))


def _mapping(value: Mapping) -> bytes:
    pairs = (encoded(key) + encoded(each) for key, each in value.items())
    return b"m%d:%b" % (len(value), b"".join(pairs))


ENCODINGS = {
    type(None): lambda value: b"n",
    (bool, np.bool_): lambda value: b"t" if value else b"f",
    Integral: lambda value: b"i" + struct.pack("<q", value),
    Real: lambda value: b"r" + struct.pack("<d", value),
    str: _text,
    np.ndarray: _array,
    (tuple, list): _sequence,
    Mapping: _mapping,
}
