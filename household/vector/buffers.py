"""Buffers: all that the homes of a vector environment read and write, allocated once.

One record in one block of memory, which several processes can share. Slots stand home
by home, robot by robot.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers, Mask, Singles
from household.observation.notices import Notices

GO_ON = -1
"""In place of a seed: a home goes on with the history that its last seed began."""


class Told(NamedTuple):
    """What the robots of all homes are told of a moment.

    Attributes:
        observations: Shape (n_slots, length).
        notices: A row for each slot.
    """

    observations: Singles
    notices: Notices

    def of(self, slots: slice) -> "Told":
        """The part of some slots; views."""
        notices = Notices._make(array[slots] for array in self.notices)
        return Told(self.observations[slots], notices)


class Buffers(NamedTuple):
    """All of it; views of one record.

    Attributes:
        actions: What each robot is to do, shape (n_slots,).
        seeds: Of each home's next history, or `GO_ON`, shape (n_homes,).
        rewards: Of the last step, shape (n_slots,).
        truncations: Whether that step ended the episode, shape (n_slots,).
        now: What robots are told now.
        final: The same at the end of a home's last episode.
    """

    actions: Integers
    seeds: Integers
    rewards: Floats
    truncations: Mask
    now: Told
    final: Told


class Size(NamedTuple):
    """How large buffers are.

    Attributes:
        homes: How many homes.
        slots: How many robots in all of them.
        length: Numbers in an observation.
        actions: How many actions there are.
        lines: How many workers there are.
    """

    homes: int
    slots: int
    length: int
    actions: int
    lines: int


def record_type(size: Size) -> np.dtype[np.void]:
    """The type of the record of all buffers, and of lines between processes."""
    n = (size.slots,)
    told = np.dtype(
        [
            ("observations", np.float32, (*n, size.length)),
            ("caresses", np.int64, n),
            ("taps", np.int64, n),
            ("behavior_over", np.bool_, n),
            ("attended", np.bool_, n),
            ("action_mask", np.int8, (*n, size.actions)),
        ],
        align=True,
    )
    return np.dtype(
        [
            ("actions", np.int64, n),
            ("seeds", np.int64, (size.homes,)),
            ("rewards", np.float64, n),
            ("truncations", np.bool_, n),
            ("now", told),
            ("final", told),
            ("lines", np.int64, (size.lines, 2, 2)),
        ],
        align=True,
    )


def buffers_in(record: NDArray[np.void]) -> Buffers:
    """The buffers in a record of type `record_type`, shape ()."""
    plain = {name: record[name] for name in ("actions", "seeds")}
    plain |= {name: record[name] for name in ("rewards", "truncations")}
    return Buffers(**plain, now=_told(record["now"]), final=_told(record["final"]))


def _told(record: NDArray[np.void]) -> Told:
    notices = Notices(**{name: record[name] for name in Notices._fields})
    return Told(record["observations"], notices)
