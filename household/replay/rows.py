"""Rows: moments kept in preallocated arrays until they are written out."""

import math
from dataclasses import dataclass, fields
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from household.compiled import compiled
from household.scenario import Scenario
from household.snapshot import layout, present, rewards

if TYPE_CHECKING:
    from household.life import Life

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]
Shares = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Rows:
    """Moments one after another; the first axis of every array is the moment.

    Attributes are those of `Snapshot`, with ``decision`` and ``time`` as arrays.
    """

    decision: Indices
    time: Array
    position: Array
    heading: Array
    gaze: Array
    half_view: Array
    activity: Indices
    attends: Mask
    attention: Shares
    mood: Array
    behavior: Indices
    begun: Indices
    reward: Array

    def __len__(self) -> int:
        return len(self.decision)


FLUSH_EVERY = 16_000
"""Decisions between writes to the file; a killed process loses no more than these,
which is a second or so of simulation. Each write takes some 20 ms, however short."""

MOST_BYTES = 32 << 20
"""Of memory for a buffer; a large crowd is written out more often."""

REMEMBERED = 512
"""Decisions for which it is known where the robots were; lines go back no further."""

NAMES = tuple(field.name for field in fields(Rows))


class Buffer:
    """Room for so many moments.

    All numbers of a kind are one block, in which a moment is a row: a single compiled
    call writes it, which at every step of a recording counts.

    Args:
        scenario: Who lives where.
        life: Whose moments.
        capacity: How many; fewer, if they would need more than `MOST_BYTES`.

    Attributes:
        decision: The last moment's; -1 before the first.
    """

    def __init__(self, scenario: Scenario, life: "Life", capacity: int) -> None:
        self._layout, self._period = layout(scenario), scenario.decision_period
        shapes = self._layout.values()
        bytes_each = sum(8 * math.prod(shape) for shape, _ in shapes)
        self._capacity = max(1, min(capacity, MOST_BYTES // bytes_each))
        self._numbers = np.zeros((self._capacity, self._width(np.float64)))
        indices = self._capacity, 1 + self._width(np.int64)
        self._indices = np.zeros(indices, dtype=np.int64)
        self._marks = np.zeros((self._capacity, self._width(np.bool_)), np.bool_)
        self._shares = np.zeros((self._capacity, self._width(np.float32)), np.float32)
        self._n_people = len(scenario.people)
        self._spots = np.zeros((REMEMBERED, len(scenario.robots), 2))
        self._life, self._filled = life, 0
        self._write = partial(
            _write,
            self._numbers,
            self._indices,
            self._marks,
            self._shares,
            self._spots,
            *present(life),
        )
        self.decision = -1

    def _width(self, kind: type) -> int:
        """How many numbers of a kind a moment has."""
        return sum(math.prod(s) for s, each in self._layout.values() if each is kind)

    @property
    def full(self) -> bool:
        """Whether there is no room for another moment."""
        return self._filled == self._capacity

    def put(self) -> None:
        """Adds this moment; its touches are kept elsewhere."""
        row, life = self._filled, self._life
        self._filled, self.decision = row + 1, life.decision
        self._write(row, self.decision)
        if life.robots.touched:
            self._numbers[row, -self._spots.shape[1] :] = rewards(life.robots)

    def spot(self, robot: int, decision: int) -> tuple[float, float]:
        """Where a robot was; where it is now, if that is forgotten.

        Args:
            robot: Its index.
            decision: Not after the last moment.
        """
        known = decision if decision > self.decision - REMEMBERED else self.decision
        x, y = self._spots[known % REMEMBERED, robot].tolist()
        return x, y

    def take(self) -> Rows:
        """Everything since the last time; valid until the next `put`."""
        count, self._filled = self._filled, 0
        blocks: dict[type, NDArray[Any]] = {
            np.float64: self._numbers[:count],
            np.int64: self._indices[:count, 1:],
            np.bool_: self._marks[:count],
            np.float32: self._shares[:count],
        }
        ends = dict.fromkeys(blocks, 0)
        columns: dict[str, NDArray[Any]] = {}
        for name, (shape, kind) in self._layout.items():
            begin, ends[kind] = ends[kind], ends[kind] + math.prod(shape)
            part = blocks[kind][:, begin : ends[kind]]
            columns[name] = part.reshape(count, *shape)
        decision = self._indices[:count, 0].copy()
        time = np.asarray(decision * self._period, dtype=np.float64)
        return Rows(decision=decision, time=time, **columns)


@compiled
def _write(
    numbers: Array,
    indices: Indices,
    marks: Mask,
    shares: Shares,
    spots: Array,
    position: Array,
    heading: Array,
    gaze: Array,
    half_view: Array,
    activity: Indices,
    attends: Mask,
    attention: Array,
    mood: Array,
    behavior: Indices,
    begun: Indices,
    row: int,
    decision: int,
) -> None:
    """Writes a moment without touches, in the order of `layout`."""
    n, n_people = len(heading), len(mood)
    here, marked, spot = numbers[row], marks[row], spots[decision % len(spots)]
    at = 0
    for i in range(n):
        here[2 * i], here[2 * i + 1] = position[i, 0], position[i, 1]
        here[2 * n + i], here[3 * n + i] = heading[i], gaze[i]
        for j in range(n):
            shares[row, i * n + j] = attention[i, j]
            marked[i * n + j] = attends[i, j]
    at = 4 * n + n_people
    for i in range(n_people):
        here[4 * n + i] = half_view[i]
        here[at + i] = mood[i]
        indices[row, 1 + i] = activity[i]
    indices[row, 0] = decision
    n_robots = n - n_people
    for j in range(n_robots):
        here[at + n_people + j] = 0.0
        indices[row, 1 + n_people + j] = behavior[j]
        indices[row, 1 + n_people + n_robots + j] = begun[j]
        spot[j, 0], spot[j, 1] = position[n_people + j, 0], position[n_people + j, 1]
