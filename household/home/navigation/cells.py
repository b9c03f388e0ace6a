"""Cells of a grid near walls and furniture, found without a look at all the others."""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from household.compiled.arrays import Floats, Mask
from household.home.floorplan import Furniture
from household.home.geometry import distance_to_box, distance_to_segments

PIECE = 2.0
"""A wall is looked at in pieces [m]: the box round a long oblique one holds cells
that are nowhere near it."""

Window = tuple[slice, slice]


def mark_near_segment(
    marks: Mask,
    origin: Floats,
    cell: float,
    segment: Floats,
    reach: float,
    rim: int = 0,
) -> None:
    """Marks the cells whose middle lies within reach of a segment.

    Args:
        marks: The grid; changed in place.
        origin: Its lower left corner but for the rim [m].
        cell: Edge of a cell [m].
        segment: x1, y1, x2, y2 [m].
        reach: [m].
        rim: Cells before the origin.
    """
    start, end = segment[:2], segment[2:]
    pieces = max(1, math.ceil(float(np.hypot(*(end - start))) / PIECE))
    stops = start + np.arange(pieces + 1)[:, None] / pieces * (end - start)
    for one, other in pairwise(stops):
        low, high = np.minimum(one, other) - reach, np.maximum(one, other) + reach
        for window, middles in _windows(marks, origin, cell, (low, high), rim):
            gaps = distance_to_segments(middles, segment[None])[:, 0]
            marks[window] |= (gaps <= reach).reshape(marks[window].shape)


def mark_near_box(
    marks: Mask, origin: Floats, cell: float, box: Furniture, reach: float
) -> None:
    """Marks the cells whose middle lies within reach of a box, or in it.

    Args:
        marks: The grid; changed in place.
        origin: Its lower left corner [m].
        cell: Edge of a cell [m].
        box: The box.
        reach: [m].
    """
    middle, far = np.array(box.center), math.hypot(*box.size) / 2 + reach
    bounds = middle - far, middle + far
    for window, middles in _windows(marks, origin, cell, bounds, 0):
        gaps = distance_to_box(middles, box.center, box.size, box.angle)
        marks[window] |= (gaps <= reach).reshape(marks[window].shape)


def _windows(
    marks: Mask, origin: Floats, cell: float, bounds: tuple[Floats, Floats], rim: int
) -> Iterator[tuple[Window, Floats]]:
    """The part of a grid within bounds [m], if any, and the middles of its cells."""
    size = np.array(marks.shape)
    low, high = (np.floor((bound - origin) / cell) + rim for bound in bounds)
    first = np.clip(low - 1, 0, size).astype(int)
    last = np.clip(high + 2, 0, size).astype(int)
    if (first < last).all():
        inside = np.indices(tuple(last - first)).reshape(2, -1).T + first
        window = slice(first[0], last[0]), slice(first[1], last[1])
        yield window, origin + (inside - rim + 0.5) * cell
