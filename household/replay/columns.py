"""Columns: whole arrays in the form in which Rerun takes them.

Rerun's own functions look at every value; these pass the memory of arrays on as it is.
In every array the first axis is the moment, and the second, if there is one, what is
drawn at that moment. Where the number of drawn things differs from moment to moment,
those of all moments follow one another on a single axis, and `sizes` says how many
belong to each moment, shape (n_moments,).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Integers

if TYPE_CHECKING:
    import pyarrow as pa
    import rerun as rr

    Kind = rr.ComponentDescriptor


ARCHETYPE = "household.State"
"""Rerun's name for a kind of data: here, for columns of exact values."""


def vectors(
    kind: "Kind", values: NDArray[Any], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Points or arrows.

    Args:
        kind: Rerun's descriptor of what they are.
        values: Shape (n_moments, n, 2), or (n, 2) with ``sizes``.
        sizes: How many there are at each moment, if that differs.
    """
    return _column(kind, _vectors(values), values.shape[1] if sizes is None else sizes)


def strips(
    kind: "Kind", values: NDArray[Any], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Lines that all have the same number of points.

    Args:
        kind: Rerun's descriptor of what they are.
        values: Shape (n_moments, n, n_points, 2), or (n, n_points, 2) with ``sizes``.
        sizes: How many there are at each moment, if that differs.
    """
    import pyarrow as pa

    inner = _vectors(values)
    whole = pa.list_(pa.field("item", inner.type, nullable=False))
    ends = _offsets(len(inner), values.shape[-2])
    lines = pa.ListArray.from_arrays(ends, inner, type=whole)
    return _column(kind, lines, values.shape[1] if sizes is None else sizes)


def colors(
    kind: "Kind", values: NDArray[np.uint32], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Packed colors.

    Args:
        kind: Rerun's descriptor of what they color.
        values: Shape (n_moments, n), or (n,) with ``sizes``.
        sizes: How many there are at each moment, if that differs.
    """
    import pyarrow as pa

    each = values.shape[1] if sizes is None else sizes
    return _column(kind, pa.array(values.reshape(-1)), each)


def texts(
    kind: "Kind",
    among: Sequence[str],
    which: Integers,
    sizes: Integers | None = None,
) -> "rr.ComponentColumn":
    """Texts that recur.

    Args:
        kind: Rerun's descriptor of what they are.
        among: All different texts.
        which: Indices into them, shape (n_moments, n), or (n,) with ``sizes``.
        sizes: How many there are at each moment, if that differs.
    """
    import pyarrow as pa

    chosen = pa.array(among, pa.string()).take(pa.array(which.reshape(-1)))
    return _column(kind, chosen, which.shape[1] if sizes is None else sizes)


def pictures(kind: "Kind", values: NDArray[np.uint8]) -> "rr.ComponentColumn":
    """One picture at each moment, as bytes of shape (n_moments, ...)."""
    import pyarrow as pa

    flat = pa.array(values.reshape(-1))
    whole = pa.list_(pa.field("item", flat.type, nullable=False))
    offsets = _offsets(len(flat), values[0].size)
    return _column(kind, pa.ListArray.from_arrays(offsets, flat, type=whole), 1)


def exact(name: str, values: NDArray[Any]) -> "rr.ComponentColumn":
    """A column of exact numbers, for positions that Rerun draws are rounded to 32 bits.

    Args:
        name: The column's name.
        values: Numbers, one row for each moment.
    """
    import pyarrow as pa

    flat = np.ascontiguousarray(values).reshape(len(values), -1)
    if flat.dtype == np.bool_:
        flat = flat.view(np.uint8)
    elif flat.dtype == np.int64:
        flat = flat.astype(np.int32)  # Half as much to write; none is larger.
    rows = pa.FixedSizeListArray.from_arrays(pa.array(flat.reshape(-1)), flat.shape[1])
    return _column(_state(name), rows, 1)


def words(name: str, values: Sequence[str]) -> "rr.ComponentColumn":
    """A column of texts, one for each moment."""
    import pyarrow as pa

    flat = pa.array(list(values), pa.string())
    return _column(_state(name), pa.FixedSizeListArray.from_arrays(flat, 1), 1)


def _state(name: str) -> "rr.ComponentDescriptor":
    import rerun as rr

    return rr.ComponentDescriptor(f"State:{name}", archetype=ARCHETYPE)


def _vectors(values: NDArray[Any]) -> "pa.Array":
    import pyarrow as pa

    flat = pa.array(values.astype(np.float32, copy=False).reshape(-1))
    pair = pa.list_(pa.field("item", flat.type, nullable=False), 2)
    return pa.FixedSizeListArray.from_arrays(flat, type=pair)


def _offsets(count: int, size: int) -> NDArray[np.int32]:
    """Where groups of the same size begin, and where the last one ends."""
    return np.arange(0, count + 1, size, dtype=np.int32)


def _column(
    kind: "Kind", values: "pa.Array", size: int | Integers
) -> "rr.ComponentColumn":
    import rerun as rr

    if isinstance(size, int):
        offsets = _offsets(len(values), size)
    else:
        offsets = np.concatenate([[0], np.cumsum(size)]).astype(np.int32)
    return rr.ComponentColumn(kind, rr.AnyBatchValue(kind, values), offsets=offsets)
