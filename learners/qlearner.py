"""Q-learning from touches: rate, credit, analogy and exploration, each replaceable."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from learners.analogy.operators import Analogy
from learners.errors import ParameterError, check_range
from learners.experience import Experience
from learners.exploration import Estimates
from learners.learner import Credit
from learners.saving import DERIVED, saved
from learners.tabular.base import CreditedLearner
from learners.tabular.qtable import QTable
from learners.tabular.rates import Factors, Rate, SocialRate
from learners.tabular.updates import q_target, td_error


class Target(NamedTuple):
    """What one update moves a pair towards.

    Attributes:
        state: situation of the pair.
        action: its behavior.
        value: what Q(state, action) moves towards.
        weight: eligibility.
        factors: social factors that set the learning rate.
    """

    state: Hashable
    action: int
    value: float
    weight: float
    factors: Factors


@saved
@dataclass(eq=False)
class QLearner(CreditedLearner):
    """The paper's learner: Q-learning with a social rate, credit and analogy.

    `learn` checks an entry, adds it to the history and counts its transition; the
    credit rule shares each touch (or, in silence, a reward of 0) among the entries;
    each share gives a target r + gamma * max Q(s'); the analogy carries the target to
    the analogs; each moves by rate * eligibility * strength, and its visit is counted
    in `QTable.move`. All targets are worked out before the table changes.

    Two touches in one entry are two updates, not one of twice the reward, so values
    stay in [-1, 1] / (1 - gamma) (our choice).

    Attributes:
        gamma: weight of what comes after, per entry whatever its duration, in [0, 1).
            0.1: our choice; a touch judges what was done, not what it leads to.
        rate: the learning rate.
        analogy: where else an update goes; the base class knows no analogs.
        initial: value of a pair never updated. 0: neither polite nor impolite.
        table: values and visits; a team sets it where several robots share one.
        targets: what the last `learn` moved; for a team to carry to other robots.
    """

    gamma: float = field(default=0.1, kw_only=True)
    rate: Rate = field(default_factory=SocialRate, kw_only=True)
    analogy: Analogy = field(default_factory=Analogy, kw_only=True)
    initial: float = field(default=0.0, kw_only=True)
    table: QTable = field(init=False, repr=False)
    targets: tuple[Target, ...] = field(
        init=False, default=(), repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("gamma", self.gamma, 0.0, 1.0)
        if self.gamma == 1.0:
            raise ParameterError("gamma is 1, and values would have no bound")
        if self.exploration.needs_posterior:
            raise ParameterError(
                f"{type(self.exploration).__name__} needs a posterior, which a "
                "QLearner has not; take hierarchical_thompson"
            )
        self.table = QTable(n_behaviors=self.n_behaviors, initial=self.initial)

    def estimates(self, state: Hashable) -> Estimates:
        """Values and visits of a state, as the analogy sees them."""
        return Estimates(
            self.analogy.values(self.table, state),
            self.analogy.visits(self.table, state),
        )

    def move(self, targets: Sequence[Target], strength: float = 1.0) -> None:
        """Move pairs and their analogs towards their targets.

        Args:
            targets: one per update, in order.
            strength: factor on every step, in [0, 1]; below 1 for experience that is
                another robot's.
        """
        spread = [self.analogy.spread(target.state) for target in targets]
        self._move(targets, spread, strength)

    def _move(
        self,
        targets: Sequence[Target],
        spread: Sequence[Sequence[tuple[Hashable, float]]],
        strength: float,
    ) -> None:
        for target, rows in zip(targets, spread, strict=True):
            for row, share in rows:
                self._move_row(row, target, target.weight * (share * strength))
            self.table.updates += 1

    def _move_row(self, row: Hashable, target: Target, weight: float) -> None:
        action = target.action
        values, visits = self.table.row(row)
        rate = self.rate(self.table.updates, visits[action], target.factors)
        step = rate * weight * self._pace(values[action], target.value)
        self.table.move(row, action, target.value, step, min(weight, 1.0))

    def _pace(self, value: float, target: float) -> float:
        """Factor on the step of one update; 1 in plain Q-learning."""
        return 1.0

    def _absorb(self, credits: Sequence[Credit]) -> None:
        self.targets = tuple(
            target for credit in credits for target in self._targets(credit)
        )
        spread = [self.analogy.spread(target.state) for target in self.targets]
        for credit in credits:
            for entry, weight in credit.shares:
                self.analogy.observe(entry, credit.reward, weight)
        self._move(self.targets, spread, 1.0)

    def _targets(self, credit: Credit) -> list[Target]:
        reward = credit.reward
        if reward is None:
            attended = self.history.entries[-1].attended
            value, factors = 0.0, Factors(False, attended, 0.0)
        else:
            value = reward.value
            factors = Factors(True, reward.attending, reward.mood)
        error = self._newest_error(value) if self.credit.shares_error else None
        return [
            Target(e.state, e.action, self._aim(e, value, error), w, factors)
            for e, w in credit.shares
        ]

    def _newest_error(self, reward: float) -> float:
        newest = self.history.entries[-1]
        return td_error(self._value(newest), self._aim(newest, reward, None))

    def _aim(self, entry: Experience, reward: float, error: float | None) -> float:
        """What a pair moves towards: by the newest pair's error, else by its own."""
        if error is not None:
            return self._value(entry) + error
        following = self.analogy.values(self.table, entry.next_state)
        return q_target(reward, self.gamma, following)

    def _value(self, entry: Experience) -> float:
        return self.analogy.values(self.table, entry.state)[entry.action]
