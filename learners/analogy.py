"""Analogy: experience with one situation serves situations like it."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

from learners.experience import Feedback
from learners.qtable import QTable
from learners.saving import saved


@saved
@dataclass(kw_only=True, eq=False)
class Analogy:
    """How the table is read and written for a state; this one knows no analogs.

    Subclasses change where an update goes (`spread`) and what a state reads
    (`values`), never the table itself.
    """

    def values(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Values of a state as this analogy sees them, length n_behaviors."""
        return table.values(state)

    def visits(self, table: QTable, state: Hashable) -> Sequence[float]:
        """Visits behind those values, length n_behaviors."""
        return table.visits(state)

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """Rows that an update of a state goes to, with its strength in [0, 1] there."""
        return ((state, 1.0),)

    def observe(
        self, state: Hashable, action: int, feedback: Feedback, weight: float
    ) -> None:
        """Take note of a feedback credited to a pair, before the table changes."""
