"""Rows: moments kept in preallocated arrays until they are written out."""

from bisect import bisect_left
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers, Mask, Singles
from household.scenario.scenario import Scenario
from household.simulation.snapshot import layout, present, rewards

if TYPE_CHECKING:
    from household.simulation.simulation import Simulation


@dataclass(frozen=True, slots=True)
class Rows:
    """Moments one after another; the first axis of every array is the moment.

    Attributes are those of `Snapshot`, with ``decision`` and ``time`` as arrays.
    """

    decision: Integers
    time: Floats
    position: Floats
    heading: Floats
    gaze: Floats
    half_view: Floats
    activity: Integers
    attends: Mask
    attention: Singles
    mood: Floats
    behavior: Integers
    begun: Integers
    reward: Floats

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

    All of a moment lies side by side in memory and is copied at once, which at every
    step of a recording counts.

    Args:
        scenario: Who lives where.
        simulation: Whose moments.
        capacity: How many; fewer, if they would need more than `MOST_BYTES`.

    Attributes:
        decision: The last moment's; -1 before the first.
    """

    def __init__(
        self, scenario: Scenario, simulation: "Simulation", capacity: int
    ) -> None:
        self._layout, self._period = layout(scenario), scenario.decision_period
        self._life, self._now = simulation, simulation.memory.bytes
        self._capacity = max(1, min(capacity, MOST_BYTES // len(self._now)))
        self._moments = np.zeros((self._capacity, len(self._now)), np.uint8)
        self._decisions: list[int] = []
        self._rewards = np.zeros((self._capacity, len(scenario.robots)))
        everybody = self._column(simulation.crowd.position, self._capacity)
        self._spots = everybody[:, len(scenario.people) :]
        self._before: tuple[list[int], Floats] = ([], self._spots[:0])
        self.decision = -1

    @property
    def full(self) -> bool:
        """Whether there is no room for another moment."""
        return len(self._decisions) == self._capacity

    def put(self) -> None:
        """Adds this moment; its touches are kept elsewhere."""
        row, simulation = len(self._decisions), self._life
        self._moments[row] = self._now
        self.decision = simulation.decision
        self._decisions.append(simulation.decision)
        if simulation.robots.touched:
            self._rewards[row] = rewards(simulation.robots)

    def spot(self, robot: int, decision: int) -> tuple[float, float]:
        """Where a robot was; where it is now, if that is forgotten.

        Args:
            robot: Its index.
            decision: Not after the last moment.
        """
        known = decision if decision > self.decision - REMEMBERED else self.decision
        decisions, spots = self._decisions, self._spots
        if not decisions or known < decisions[0]:
            decisions, spots = self._before
        x, y = spots[bisect_left(decisions, known), robot].tolist()
        return x, y

    def take(self) -> Rows:
        """Everything since the last time."""
        decisions, count = self._decisions, len(self._decisions)
        reward = self._rewards[:count].copy()
        self._rewards[:count] = 0.0
        columns = [self._column(array, count) for array in present(self._life)]
        told: dict[str, NDArray[Any]] = {
            name: column[:, : shape[0]].astype(kind)
            for (name, (shape, kind)), column in zip(
                self._layout.items(), (*columns, reward), strict=True
            )
        }
        earlier, spots = self._before
        latest = np.concatenate([spots, self._spots[:count]])[-REMEMBERED:]
        self._before = [*earlier, *decisions][-REMEMBERED:], latest
        self._decisions = []
        decision = np.array(decisions, np.int64)
        time = np.asarray(decision * self._period, dtype=np.float64)
        return Rows(decision=decision, time=time, **told)

    def _column(self, array: NDArray[Any], count: int) -> NDArray[Any]:
        """What an array was at each moment, shape (count, *its shape)."""
        begin = self._life.memory.begin_of(array)
        part = self._moments[:count, begin : begin + array.nbytes]
        return part.view(array.dtype).reshape(count, *array.shape)
