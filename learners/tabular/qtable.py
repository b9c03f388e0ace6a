"""The table of values, and the only place where visits are counted."""

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from learners.errors import MOST_BEHAVIORS, SavedFileError, check_range, check_whole
from learners.saving import saved

MOST_VALUE = 1e9
"""Values stay within this, whatever rates and weights a user's own parts give."""


MOST_VISITS = 1e15
"""Of one pair in a file; more are not counted in floating point."""


class Row(NamedTuple):
    """Values and visits of one state, a list of n_behaviors floats each."""

    values: list[float]
    visits: list[float]

    def move(self, action: int, target: float, step: float, visits: float) -> None:
        """Move one value towards a target and count the visit.

        (1 - alpha) * Q + alpha * target; source: section 3.1 of the paper, written as
        Q + alpha * (target - Q).

        Args:
            action: behavior index.
            target: what the value moves towards.
            step: how far, as a share of the way: learning rate times eligibility.
            visits: what it counts as a visit; a spread-out update counts in part, so
                that a trace of a touch does not use up a pair's learning rate.
        """
        values = self.values
        moved = values[action] + step * (target - values[action])
        if not -MOST_VALUE <= moved <= MOST_VALUE:
            moved = max(-MOST_VALUE, min(moved, MOST_VALUE))
        values[action] = moved
        self.visits[action] += visits


@saved
@dataclass(kw_only=True, eq=False)
class QTable:
    """Values Q(state, action) and visits t(state, action) of every state met.

    A row is a state, or what a representation makes of it. Rows come into being when
    they are first written (see `learners.tabular.memory`); reading never adds one.

    Attributes:
        n_behaviors: number of behaviors, >= 1.
        initial: value of a pair never updated.
        updates: number of updates so far, however many rows each moved: t of the
            synchronous rate. Whoever moves values counts them.
        silent: of the visits of each row, those without a touch, where a learner counts
            them apart; rows that it never counted are missing.
    """

    n_behaviors: int
    initial: float = 0.0
    updates: int = field(default=0, init=False)
    rows: dict[Hashable, Row] = field(default_factory=dict, init=False, repr=False)
    silent: dict[Hashable, list[float]] = field(
        default_factory=dict, init=False, repr=False
    )

    def __post_init__(self) -> None:
        check_whole("n_behaviors", self.n_behaviors, 1, 3 * MOST_BEHAVIORS)
        check_range("initial", self.initial, -MOST_VALUE, MOST_VALUE)
        self._unseen = Row([self.initial] * self.n_behaviors, [0.0] * self.n_behaviors)

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Hashable]:
        return iter(self.rows)

    def row(self, state: Hashable) -> Row:
        """Values and visits of a state; for reading only."""
        return self.rows.get(state, self._unseen)

    def values(self, state: Hashable) -> Sequence[float]:
        """Values of a state, length n_behaviors; for reading only."""
        return self.row(state).values

    def visits(self, state: Hashable) -> Sequence[float]:
        """Visits of a state's pairs, length n_behaviors; for reading only."""
        return self.row(state).visits

    def add(self, state: Hashable) -> Row:
        """The row of a state that had none, to be written."""
        row = self.rows[state] = Row(
            self._unseen.values.copy(), self._unseen.visits.copy()
        )
        return row

    def silences(self, state: Hashable) -> list[float]:
        """Visits of a state's pairs without a touch, to be written, too."""
        return self.silent.setdefault(state, [0.0] * self.n_behaviors)

    def array(self, state: Hashable) -> NDArray[np.float64]:
        """Values of a state, shape (n_behaviors,); a copy."""
        return np.array(self.row(state).values)

    def to_data(self) -> dict[str, Any]:
        """All it holds, for `learners.saving`."""
        return {
            "n_behaviors": self.n_behaviors,
            "initial": self.initial,
            "updates": self.updates,
            "rows": {state: tuple(row) for state, row in self.rows.items()},
            "silent": self.silent,
        }

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """The table that `to_data` gave the data of."""
        table = cls(n_behaviors=data["n_behaviors"], initial=data["initial"])
        table.updates = data["updates"]
        table.rows = {state: Row(*row) for state, row in data["rows"].items()}
        table.silent = data.get("silent", {})  # files of before have none
        check_whole("updates", table.updates, 0, 2**63)
        for values, visits in table.rows.values():
            _check_visits(visits, table.n_behaviors)
            _check_length(values, table.n_behaviors)
            for value in values:
                check_range("a value", value, -MOST_VALUE, MOST_VALUE)
        for visits in table.silent.values():
            _check_visits(visits, table.n_behaviors)
        return table


def _check_length(row: Sequence[float], n_behaviors: int) -> None:
    if len(row) != n_behaviors:
        raise SavedFileError("a row of a table is not as long as the others")


def _check_visits(visits: Sequence[float], n_behaviors: int) -> None:
    _check_length(visits, n_behaviors)
    for visit in visits:
        check_range("a visit", visit, 0.0, MOST_VISITS)
