"""The buffer: moments that are kept in memory until they are written out."""

from collections.abc import Sequence

import numpy as np

from household.compiled.arrays import Floats
from household.simulation.moment import DECISION, Moments, Record, recorded
from household.simulation.simulation import Simulation

FLUSH_EVERY = 16_000
"""Decisions between writes to the file, about a second of simulation; a killed process
loses no more than these. Each write takes some 20 ms, however little it writes."""

MOST_BYTES = 32 << 20
"""Of memory for a buffer; a large crowd is written out more often."""

REMEMBERED = 512
"""Decisions for which it is known where the robots were; lines go back no further."""

Held = Record
"""Moments as the simulation holds them, one after the other."""


class Buffer:
    """Room for some moments of a simulation.

    The simulation's record of a moment is copied as one piece, since that happens at
    every step; what is in it is looked at only when the moments are taken out.

    Args:
        simulation: Whose moments are kept.
        capacity: How many; fewer, if they would need more than `MOST_BYTES`.

    Attributes:
        decision: The last moment's; -1 before the first.
    """

    def __init__(self, simulation: Simulation, capacity: int) -> None:
        self._simulation, self._now = simulation, simulation.record
        self._capacity = max(1, min(capacity, MOST_BYTES // self._now.itemsize))
        # Two, so that one can be read while the other is filled.
        self._records, self._other = np.zeros((2, self._capacity), self._now.dtype)
        self._decisions: list[int] = []
        n_people = len(simulation.scenario.people)
        self._spots = self._records["position"][:, n_people:]
        self._other_spots = self._other["position"][:, n_people:]
        self._before: tuple[list[int], Floats] = ([], self._spots[:0])
        self.decision = -1

    @property
    def full(self) -> bool:
        """Whether there is no room for another moment."""
        return len(self._decisions) == self._capacity

    def put(self) -> None:
        """Adds the simulation's present moment."""
        self._records[len(self._decisions)] = self._now
        self.decision = self._simulation.decision
        self._decisions.append(self.decision)

    def spots(
        self, robot: Sequence[int], decision: Sequence[int], now: Sequence[int]
    ) -> Floats:
        """Where robots were, shape (n, 2) [m].

        Args:
            robot: Index of each.
            decision: When; none is after the last moment.
            now: When that was asked for; what was forgotten by then is where the robot
                was at that moment.
        """
        earlier, before = self._before
        decisions = np.array([*earlier, *self._decisions], np.int64)
        known = np.array([decision, now], np.int64)
        known = np.where(known[0] > known[1] - REMEMBERED, known[0], known[1])
        spots = np.concatenate([before, self._spots[: len(self._decisions)]])
        found: Floats = spots[np.searchsorted(decisions, known), list(robot)]
        return found

    def take(self) -> Held:
        """Takes all moments out; they stay as they are until the next time."""
        held, decisions = self.held(), self._decisions
        earlier, spots = self._before
        latest = np.concatenate([spots, self._spots[: len(decisions)]])[-REMEMBERED:]
        self._before = [*earlier, *decisions][-REMEMBERED:], latest
        self._decisions = []
        self._records, self._other = self._other, self._records
        self._spots, self._other_spots = self._other_spots, self._spots
        return held

    def held(self) -> Held:
        """All moments."""
        return self._records[: len(self._decisions)]

    def moments(self, held: Held) -> Moments:
        """What is recorded of moments."""
        scenario = self._simulation.scenario
        decision = held[DECISION].copy()
        time: Floats = decision * scenario.decision_period
        return Moments(decision=decision, time=time, **recorded(held, scenario))
