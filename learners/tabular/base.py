"""What all learners from touches share: checks, history, network, credit, saving."""

from abc import ABC, abstractmethod
from collections.abc import Hashable, Sequence
from dataclasses import KW_ONLY, dataclass, field
from pathlib import Path
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from learners.credit.history import History
from learners.credit.rules import CreditRule, Immediate, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import (
    MOST_BEHAVIORS,
    ExperienceError,
    ParameterError,
    SavedFileError,
    UnknownBehaviorError,
    check_hashable,
    check_part,
    check_range,
    check_whole,
    shown,
)
from learners.experience import Experience, Reward
from learners.exploration import Estimates, Exploration, SeekCompany, Softmax
from learners.learner import Credit
from learners.pooling.rules import NoPooling, Pooling
from learners.representation.parts import Representation
from learners.representation.situations import Named
from learners.representation.views import is_alone
from learners.saving import DERIVED, load, write
from learners.tabular.memory import Memory
from learners.tabular.qtable import QTable

MOST_WEIGHT = 1e6
"""Beyond any trace that adds up: a weight above it is a rule's mistake."""


@dataclass(eq=False)
class CreditedLearner(ABC):
    """A learner that credits each touch to past entries and learns from those.

    A subclass says what it makes of credited touches (`_absorb`); what it learned is in
    its table, which it reads and writes through `memory`.

    Attributes:
        n_behaviors: number of behaviors, >= 1.
        rng: the only source of randomness.
        credit: which entries a touch is about.
        exploration: how a behavior is chosen. Softmax by default, since the people
            of a home change their minds and greed would not notice.
        representation: which rows of the table a state is kept in.
        pooling: how far one person is read off others; of no effect where a
            representation does not tell people apart.
        horizon: [s] how far back a touch can reach, see `History`.
        table: what was learned, a row for each part of a state.
    """

    columns: ClassVar[int] = 1
    """Of the table, for each behavior."""

    n_behaviors: int
    rng: np.random.Generator
    _: KW_ONLY
    credit: CreditRule = field(default_factory=Immediate)
    exploration: Exploration = field(default_factory=Softmax)
    representation: Representation = field(default_factory=Named)
    pooling: Pooling = field(default_factory=NoPooling)
    horizon: float = 60.0
    history: History = field(init=False, repr=False)
    network: SituationNetwork = field(init=False, repr=False)
    table: QTable = field(init=False, repr=False)
    _credits: tuple[Credit, ...] = field(init=False, default=(), repr=False)
    _memory: Memory | None = field(
        init=False, default=None, repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        check_whole("n_behaviors", self.n_behaviors, 1, MOST_BEHAVIORS)
        if not isinstance(self.rng, np.random.Generator):
            raise ParameterError(f"rng is {shown(self.rng)}, no generator of numpy's")
        check_part("credit", self.credit, "weigh", "weigh_silence", "shares_error")
        check_part("exploration", self.exploration, "choose", "needs_posterior")
        check_part("representation", self.representation, "parts", "by_person")
        check_part("pooling", self.pooling, "terms", "has_posterior")
        if self.exploration.needs_posterior and not self.has_posterior:
            raise ParameterError(
                f"{type(self.exploration).__name__} needs a posterior, which a "
                f"{type(self).__name__} with {type(self.pooling).__name__} has not; "
                "take hierarchical_thompson"
            )
        self.history = History(horizon=self.horizon)
        self.network = SituationNetwork()
        self.table = QTable(n_behaviors=self.n_behaviors)

    def check_loaded(self) -> None:
        """Refuse a table that is not this learner's.

        Raises:
            SavedFileError: if it has another number of columns, or rows of another
                representation.
        """
        if self.table.n_behaviors != self.columns * self.n_behaviors:
            raise SavedFileError("the table is not as wide as the learner needs it")
        by_person = self.representation.by_person
        if by_person and not all(map(_is_of_a_person, self.table.rows)):
            name = type(self.representation).__name__
            raise SavedFileError(
                f"the table was learned in another representation than {name}, which "
                "keeps rows by person"
            )

    @property
    def credits(self) -> tuple[Credit, ...]:
        """What the last `learn` believed each of its touches to be about."""
        return self._credits

    @property
    def has_posterior(self) -> bool:
        """Whether `estimates` tells how sure it is of each value."""
        return False

    @property
    def memory(self) -> Memory:
        """The table as it is read and written."""
        if self._memory is None or self._memory.table is not self.table:
            self._memory = Memory(self.table, self.representation, self.pooling)
        return self._memory

    def share(self, other: "CreditedLearner") -> None:
        """From now on, learn into what another learner of this kind has learned."""
        self.table, self.network = other.table, other.network
        self.pooling, self._memory = other.pooling, other.memory

    def estimates(self, state: Hashable) -> Estimates:
        """What is known of the behaviors in a state; for reading only."""
        return Estimates(
            self._values(state),
            self._visits(state),
            self._deviations(state),
            self._is_alone(state),
        )

    def _values(self, state: Hashable) -> Sequence[float]:
        return self.memory.values(state)

    def _visits(self, state: Hashable) -> Sequence[float]:
        return self.memory.visits(state)

    def _deviations(self, state: Hashable) -> Sequence[float] | None:
        return self.memory.deviations(state) if self.has_posterior else None

    def _is_alone(self, state: Hashable) -> bool:
        return isinstance(self.exploration, SeekCompany) and is_alone(state)

    @abstractmethod
    def _absorb(self, credits: Sequence[Credit]) -> None:
        """Learn from the touches of the newest entry, or from its silence."""

    def act(self, state: Hashable) -> int:
        """Choose a behavior, an index in 0 .. n_behaviors - 1.

        Raises:
            StateError: if the state has no hash.
        """
        check_hashable("the state", state)
        asked = self.exploration
        estimates = Estimates(
            self._values(state),
            self._visits(state) if asked.needs_visits else (),
            self._deviations(state) if asked.needs_posterior else None,
            self._is_alone(state),
        )
        return asked.choose(estimates, self.rng)

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """Value of every behavior in a state, shape (n_behaviors,); a copy.

        Raises:
            StateError: if the state has no hash.
        """
        check_hashable("the state", state)
        return np.array(self._values(state), dtype=np.float64)

    def learn(self, experience: Experience) -> None:
        """Learn from one entry: check it, remember it, credit its touches, absorb them.

        Args:
            experience: the entry; entries come in order of time.

        Raises:
            LearnerError: if the entry cannot be; what was learned is unchanged.
        """
        if not isinstance(experience, Experience):
            raise ExperienceError(f"{shown(experience)} is no experience")
        action = experience.action
        # A float of the right size would fail later, with the history changed.
        known = isinstance(action, int | np.integer) and 0 <= action < self.n_behaviors
        if not known:
            raise UnknownBehaviorError(
                f"behavior {shown(action)} is not one of the {self.n_behaviors} "
                f"behaviors 0 .. {self.n_behaviors - 1}"
            )
        self.history.check(experience)
        self.memory.seen(experience.state)  # refused before anything is learned
        alone = self._is_alone(experience.state)
        found = alone and not self._is_alone(experience.next_state)
        exploratory = (
            self.credit.shares_error  # nobody else asks
            and experience.chosen
            and self._was_exploratory(experience)
        )
        self.history.append(experience, exploratory=exploratory)
        self.network.count(experience.state, experience.action, experience.next_state)
        if alone and isinstance(self.exploration, SeekCompany):
            self.exploration.note(experience.action, found=found)
        self._absorb(self._credited(experience.rewards))

    def start_episode(self) -> None:
        """Forget the history but nothing learned: the clock starts anew."""
        self.history.clear()
        self._credits = ()

    def save(self, path: str | Path) -> None:
        """Write all it needs to go on exactly as it would have, atomically.

        Raises:
            SavedFileError: if a state or a component is not registered with `saved`.
        """
        write(path, self)

    @classmethod
    def load(cls, path: str | Path, **attached: object) -> Self:
        """Read a learner of this class; see `learners.saving.load`.

        Raises:
            SavedFileError: if the file is unreadable or holds another kind of learner.
        """
        learner = load(path, **attached)
        if not isinstance(learner, cls):
            raise SavedFileError(
                f"{path} holds a {type(learner).__name__}, not a {cls.__name__}"
            )
        return learner

    def _was_exploratory(self, experience: Experience) -> bool:
        values = self._values(experience.state)
        return values[experience.action] < max(values)

    def _credited(self, rewards: tuple[Reward, ...]) -> tuple[Credit, ...]:
        if rewards:
            self._credits = tuple(map(self._believed, rewards))
            return self._credits
        self._credits = ()
        weighing = self.credit.weigh_silence(self.history)
        return (self._credit(None, weighing),)

    def _believed(self, reward: Reward) -> Credit:
        weighing = self.credit.weigh(reward, self.history, self.network)
        for weight in weighing.weights.values():
            check_range("the weight that a credit rule gave", weight, 0.0, MOST_WEIGHT)
        return self._credit(reward, weighing)

    def _credit(self, reward: Reward | None, weighing: Weighing) -> Credit:
        entries, (weights, designated) = self.history.entries, weighing
        meant = None if designated not in weights else entries[designated]
        return Credit(
            reward=reward,
            shares=tuple((entries[i], weights[i]) for i in sorted(weights)),
            designated=meant,
        )


def _is_of_a_person(row: Hashable) -> bool:
    """Whether a row may be that of a part and a person."""
    return type(row) is tuple and len(row) == 2
