"""Expected touches: what each person would give for a behavior, summed over people."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from learners.errors import ParameterError
from learners.learner import Credit
from learners.saving import saved
from learners.tabular.base import CreditedLearner
from learners.tabular.cells import Cell


@saved
@dataclass(eq=False)
class ExpectedTouch(CreditedLearner):
    """The mean of what each person gave for a behavior, in each part of a situation.

    What the mean is of says what silence teaches. Of *touches*: nothing; a person who
    hardly ever touches weighs as much in the sum as one who always does. Of
    *exposures*: that it gave nothing this time. A person is exposed once to each bout
    of a behavior in each part of a situation that it is in while the bout lasts, if it
    could perceive the robot; so the mean is the touch to be expected of a bout, however
    rare touches are.

    Attributes:
        counts: what the mean is of.
    """

    counts: Literal["touches", "exposures"] = field(default="touches", kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.counts not in ("touches", "exposures"):
            raise ParameterError(
                f"counts is {self.counts!r}, neither 'touches' nor 'exposures'"
            )

    @property
    def has_posterior(self) -> bool:
        """Whether the pooling has one and there are people to pool."""
        return self.pooling.has_posterior and self.representation.by_person

    def _absorb(self, credits: Sequence[Credit]) -> None:
        memory = self.memory
        if self.counts == "exposures":
            action = self.history.entries[-1].action
            for cell in self._exposed():
                memory.compare(cell, action, 0.0, 1.0)
                n = cell.row.visits[action] + 1.0
                memory.move(cell, action, 0.0, 1.0 / n, 1.0)
        taught = [
            (cell, entry.action, weight, credit.reward.value)
            for credit in credits
            if credit.reward is not None
            for entry, weight in credit.shares
            for cell in memory.taught(entry.state, credit.reward.giver)
        ]
        touch = self._exposed_touch if self.counts == "exposures" else self._touch
        for cell, action, weight, value in taught:
            touch(cell, action, weight, value)

    def _exposed(self) -> Sequence[Cell]:
        """The cells of all who perceive the newest entry and not yet this bout."""
        newest = self.history.entries[-1]
        cells = self.memory.seen(newest.state).heard
        if newest.chosen or len(self.history) == 1:
            return cells
        before = self.memory.seen(self.history.entries[-2].state).heard
        return [cell for cell in cells if cell not in before]

    def _touch(self, cell: Cell, action: int, weight: float, value: float) -> None:
        """One touch more in the mean of touches."""
        self.memory.compare(cell, action, weight * value, weight)
        n = cell.row.visits[action] + weight
        self.memory.move(cell, action, value, weight / n, weight)

    def _exposed_touch(
        self, cell: Cell, action: int, weight: float, value: float
    ) -> None:
        """A touch in the mean of exposures, of which it is none more."""
        self.memory.compare(cell, action, weight * value, 0.0)
        values, visits = cell.row
        # Who gives a touch was exposed, even if the robot could not know.
        missed = max(1.0 - visits[action], 0.0)
        mean = values[action] + weight * value / (visits[action] + missed)
        self.memory.move(cell, action, mean, 1.0, missed)
