"""Columns: whole arrays in the form in which Rerun takes them, without detours.

Rerun's own ways to make columns look at every value; these only hand over memory. In
every array the first axis is the moment, and the second one, where there is one, what
is drawn at it.
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
"""Under which exact columns are stored, beside Rerun's own kinds of data."""


def vectors(
    kind: "Kind", values: NDArray[Any], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Points or arrows.

    Args:
        kind: What they are to Rerun: a descriptor, as are those below.
        values: Shape (n_moments, n, 2).
        sizes: How many there are at each moment, where that differs, (n_moments,); here
            and below ``values`` are then without the first axis.
    """
    return _column(kind, _vectors(values), values.shape[1] if sizes is None else sizes)


def strips(
    kind: "Kind", values: NDArray[Any], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Lines of equally many points, shape (n_moments, n, n_points, 2)."""
    import pyarrow as pa

    inner = _vectors(values)
    whole = pa.list_(pa.field("item", inner.type, nullable=False))
    ends = _offsets(len(inner), values.shape[-2])
    lines = pa.ListArray.from_arrays(ends, inner, type=whole)
    return _column(kind, lines, values.shape[1] if sizes is None else sizes)


def colors(
    kind: "Kind", values: NDArray[np.uint32], sizes: Integers | None = None
) -> "rr.ComponentColumn":
    """Packed colors, shape (n_moments, n)."""
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
        kind: What they are to Rerun.
        among: All that there are.
        which: Indices, shape (n_moments, n).
        sizes: As in `vectors`.
    """
    import pyarrow as pa

    chosen = pa.array(among, pa.string()).take(pa.array(which.reshape(-1)))
    return _column(kind, chosen, which.shape[1] if sizes is None else sizes)


def pictures(kind: "Kind", values: NDArray[np.uint8]) -> "rr.ComponentColumn":
    """One picture at each moment, its bytes in shape (n_moments, ...)."""
    import pyarrow as pa

    flat = pa.array(values.reshape(-1))
    whole = pa.list_(pa.field("item", flat.type, nullable=False))
    offsets = _offsets(len(flat), values[0].size)
    return _column(kind, pa.ListArray.from_arrays(offsets, flat, type=whole), 1)


def exact(name: str, values: NDArray[Any]) -> "rr.ComponentColumn":
    """A column that is stored as it is; Rerun rounds drawn positions to 32 bits.

    Args:
        name: Of the column.
        values: Numbers, one row for each moment.
    """
    import pyarrow as pa

    flat = np.ascontiguousarray(values).reshape(len(values), -1)
    if flat.dtype == np.bool_:
        flat = flat.view(np.uint8)
    elif flat.dtype == np.int64:
        flat = flat.astype(np.int32)  # Half as much to write; none is that large.
    rows = pa.FixedSizeListArray.from_arrays(pa.array(flat.reshape(-1)), flat.shape[1])
    return _column(_state(name), rows, 1)


def words(name: str, values: Sequence[str]) -> "rr.ComponentColumn":
    """A column of texts, one for each moment."""
    import pyarrow as pa

    told = pa.array(list(values), pa.string())
    return _column(_state(name), pa.FixedSizeListArray.from_arrays(told, 1), 1)


def _state(name: str) -> "rr.ComponentDescriptor":
    import rerun as rr

    return rr.ComponentDescriptor(f"State:{name}", archetype=ARCHETYPE)


def _vectors(values: NDArray[Any]) -> "pa.Array":
    import pyarrow as pa

    flat = pa.array(values.astype(np.float32, copy=False).reshape(-1))
    pair = pa.list_(pa.field("item", flat.type, nullable=False), 2)
    return pa.FixedSizeListArray.from_arrays(flat, type=pair)


def _offsets(count: int, size: int) -> NDArray[np.int32]:
    """Where groups of the same size begin and end."""
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
