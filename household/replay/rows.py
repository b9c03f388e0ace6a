"""Rows: which moments of a time series have to be written."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import compiled


def changes(*columns: NDArray[np.generic]) -> Indices:
    """Indices of the rows that differ from the row before, and of the first one."""
    changed = np.zeros(len(columns[0]), dtype=np.bool_)
    changed[:1] = True
    for column in columns:
        _mark_changes(column.reshape(len(column), -1), changed)
    return np.flatnonzero(changed)


@compiled
def _mark_changes(values: NDArray[Any], changed: Mask) -> None:
    for row in range(1, len(values)):
        for k in range(values.shape[1]):
            if values[row, k] != values[row - 1, k]:
                changed[row] = True
                break


def bends(values: Floats, tolerance: float) -> Indices:
    """Indices of the rows that suffice to draw time series as straight lines.

    Args:
        values: One row for each moment, shape (n_moments, n).
        tolerance: By how much the lines may miss a value.
    """
    kept = np.zeros(len(values), dtype=np.bool_)
    kept[:1] = kept[-1:] = True
    _mark_bends(values, tolerance, kept)
    return np.flatnonzero(kept)


@compiled
def _mark_bends(values: Floats, tolerance: float, kept: Mask) -> None:
    last = 0
    for row in range(1, len(values)):
        if _differ(values[row], values[last], tolerance):
            # Up to a jump the line stays where it was.
            kept[row - 1] |= _differ(values[row], values[row - 1], tolerance)
            kept[row], last = True, row


@compiled
def _differ(one: Floats, other: Floats, tolerance: float) -> bool:
    """Whether any number differs by more than a tolerance."""
    differ = False
    for k in range(len(one)):
        differ |= abs(one[k] - other[k]) > tolerance
    return differ
