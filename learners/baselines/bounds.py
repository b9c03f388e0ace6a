"""Bounds to measure learners against: chance from below, oracles from above.

What an oracle knows of people it is told by a callable; only a simulator can have one.
"""

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from learners.credit.history import History
from learners.credit.rules import CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import SavedFileError
from learners.experience import Reward
from learners.exploration import Exploration, Greedy
from learners.learner import Credit
from learners.saving import ATTACHED, saved
from learners.tabular.base import CreditedLearner

Appropriateness = Callable[[Hashable], NDArray[np.float64]]
"""How appropriate each behavior is in a state, shape (n_behaviors,), in [-1, 1]."""


@saved
@dataclass(eq=False)
class RandomChoice(CreditedLearner):
    """Any behavior at any time; learns nothing."""

    def _values(self, state: Hashable) -> Sequence[float]:
        """All the same."""
        return [0.0] * self.n_behaviors

    def _absorb(self, credits: Sequence[Credit]) -> None:
        """Takes no notice."""


@saved
@dataclass(eq=False)
class Oracle(RandomChoice):
    """The best behavior by what people really think.

    With a callable that knows each person it is the persona oracle; with one that knows
    only the average person, the population oracle.

    Attributes:
        appropriateness: what people really think.
        exploration: greedy.
    """

    appropriateness: Appropriateness = field(metadata=ATTACHED, kw_only=True)
    exploration: Exploration = field(default_factory=Greedy, kw_only=True)

    def _values(self, state: Hashable) -> Sequence[float]:
        """The true appropriateness."""
        values: list[float] = self.appropriateness(state).tolist()
        return values


@saved
@dataclass(eq=False)
class BestConstant(Oracle):
    """One and the same behavior everywhere: the best on average over the states met.

    It is told the true appropriateness of every state it was asked to act in, so it
    settles on the best constant as soon as the average does.

    Attributes:
        total: sum of appropriateness over the decisions so far, (n_behaviors,).
    """

    total: NDArray[np.float64] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        self.total = np.zeros(self.n_behaviors)

    def check_loaded(self) -> None:
        """Refuse a sum of other behaviors.

        Raises:
            SavedFileError: if it has another length.
        """
        super().check_loaded()
        if self.total.shape != (self.n_behaviors,):
            raise SavedFileError("total is not as long as there are behaviors")

    def act(self, state: Hashable) -> int:
        """Take the state into the average, then choose the best of it."""
        self.total = self.total + self.appropriateness(state)
        return super().act(state)

    def _values(self, state: Hashable) -> Sequence[float]:
        """The sum so far, the same in every state."""
        values: list[float] = self.total.tolist()
        return values


@saved
@dataclass(frozen=True, kw_only=True)
class OracleCredit(CreditRule):
    """All credit to the entry that truly caused the touch.

    Attributes:
        cause: [s] when the behavior that a touch is about was perceived; None if a
            touch has no cause (it then goes to no entry).
    """

    cause: Callable[[Reward], float | None] = field(metadata=ATTACHED)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """1 to the entry in force at the cause."""
        cause = self.cause(reward)
        if cause is None:
            return Weighing({}, None)
        index = history.in_force(cause)
        return Weighing({index: 1.0}, index)
