"""What all learners from touches share: checks, history, network, credit, saving."""

from abc import ABC, abstractmethod
from collections.abc import Hashable, Sequence
from dataclasses import KW_ONLY, dataclass, field
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from learners.credit.history import History
from learners.credit.rules import CreditRule, Immediate, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import SavedFileError, UnknownBehaviorError, check_range
from learners.experience import Experience, Reward
from learners.exploration import Estimates, Exploration, Softmax
from learners.learner import Credit
from learners.saving import load, write

MOST_WEIGHT = 1e6
"""Beyond any trace that adds up: a weight above it is a rule's mistake."""


@dataclass(eq=False)
class CreditedLearner(ABC):
    """A learner that credits each touch to past entries and learns from those.

    A subclass says what it makes of credited touches (`_absorb`) and what it then
    holds of each behavior (`estimates`).

    Attributes:
        n_behaviors: number of behaviors, >= 1.
        rng: the only source of randomness.
        credit: which entries a touch is about.
        exploration: how a behavior is chosen. Softmax by default, since the people
            of a home change their minds and greed would not notice.
        horizon: [s] how far back a touch can reach, see `History`.
    """

    n_behaviors: int
    rng: np.random.Generator
    _: KW_ONLY
    credit: CreditRule = field(default_factory=Immediate)
    exploration: Exploration = field(default_factory=Softmax)
    horizon: float = 60.0
    history: History = field(init=False, repr=False)
    network: SituationNetwork = field(init=False, repr=False)
    _credits: tuple[Credit, ...] = field(init=False, default=(), repr=False)

    def __post_init__(self) -> None:
        check_range("n_behaviors", self.n_behaviors, 1)
        self.history = History(horizon=self.horizon)
        self.network = SituationNetwork()

    @property
    def credits(self) -> tuple[Credit, ...]:
        """What the last `learn` believed each of its touches to be about."""
        return self._credits

    @abstractmethod
    def estimates(self, state: Hashable) -> Estimates:
        """What is known of the behaviors in a state; for reading only."""

    @abstractmethod
    def _absorb(self, credits: Sequence[Credit]) -> None:
        """Learn from the touches of the newest entry, or from its silence."""

    def act(self, state: Hashable) -> int:
        """Choose a behavior, an index in 0 .. n_behaviors - 1."""
        return self.exploration.choose(self.estimates(state), self.rng)

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """Value of every behavior in a state, shape (n_behaviors,); a copy."""
        return np.array(self.estimates(state).values, dtype=np.float64)

    def learn(self, experience: Experience) -> None:
        """Learn from one entry: check it, remember it, credit its touches, absorb them.

        Args:
            experience: the entry; entries come in order of time.

        Raises:
            LearnerError: if the entry cannot be; what was learned is unchanged.
        """
        action = experience.action
        # A float of the right size would fail later, with the history changed.
        known = isinstance(action, int | np.integer) and 0 <= action < self.n_behaviors
        if not known:
            raise UnknownBehaviorError(
                f"behavior {action} is not one of the {self.n_behaviors} "
                f"behaviors 0 .. {self.n_behaviors - 1}"
            )
        self.history.check(experience)
        exploratory = (
            self.credit.shares_error  # nobody else asks
            and experience.chosen
            and self._was_exploratory(experience)
        )
        self.history.append(experience, exploratory=exploratory)
        self.network.count(experience.state, experience.action, experience.next_state)
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
        values = self.estimates(experience.state).values
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
