"""Rows: snapshots kept in preallocated arrays until they are written out."""

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.scenario import Scenario
from household.snapshot import Snapshot, layout

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Rows:
    """Snapshots one after another; the first axis of every array is the moment.

    Attributes are those of `Snapshot`, with ``decision`` and ``time`` as arrays.
    """

    decision: NDArray[np.int64]
    time: Array
    position: Array
    heading: Array
    gaze: Array
    half_view: Array
    activity: NDArray[np.int64]
    attends: NDArray[np.bool_]
    attention: Array
    mood: Array
    behavior: NDArray[np.int64]
    begun: NDArray[np.int64]
    reward: Array

    def __len__(self) -> int:
        return len(self.decision)


MOST_BYTES = 32 << 20
"""Of memory for a buffer; a large crowd is written out more often."""

NAMES = tuple(field.name for field in fields(Rows))


class Buffer:
    """Room for so many snapshots.

    Args:
        scenario: Whose snapshots.
        capacity: How many; fewer, if they would need more than `MOST_BYTES`.
    """

    def __init__(self, scenario: Scenario, capacity: int) -> None:
        shapes = layout(scenario).values()
        bytes_each = sum(8 * math.prod(shape) for shape, _ in shapes)
        capacity = max(1, min(capacity, MOST_BYTES // bytes_each))
        self._arrays: dict[str, NDArray[Any]] = {
            "decision": np.zeros(capacity, dtype=np.int64),
            "time": np.zeros(capacity),
        } | {
            name: np.zeros((capacity, *shape), dtype=kind)
            for name, (shape, kind) in layout(scenario).items()
        }
        self._columns = [self._arrays[name] for name in NAMES]
        self._capacity = capacity
        self._filled = 0

    @property
    def full(self) -> bool:
        """Whether there is no room for another snapshot."""
        return self._filled == self._capacity

    def put(self, snapshot: Snapshot) -> None:
        """Adds a snapshot; its touches are kept elsewhere."""
        row = self._filled
        values: tuple[Any, ...] = snapshot
        # The touches, which have no column, are a snapshot's last field.
        for column, value in zip(self._columns, values, strict=False):
            column[row] = value
        self._filled = row + 1

    def take(self) -> Rows:
        """Everything since the last time; valid until the next `put`."""
        rows = Rows(**{n: a[: self._filled] for n, a in self._arrays.items()})
        self._filled = 0
        return rows
