"""Q-learning from touches; its rate, credit, analogy, ... can each be replaced."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from learners.analogy.carrying import Analogy
from learners.errors import ParameterError, check_part, check_range, shown
from learners.experience import Experience, Reward
from learners.learner import Credit
from learners.representation.situations import Named
from learners.saving import DERIVED, saved
from learners.tabular.base import CreditedLearner
from learners.tabular.cells import Cell
from learners.tabular.qtable import QTable
from learners.tabular.rates import Factors, Rate, SocialRate, at
from learners.tabular.silence import SilentSteps, Waiting


class Target(NamedTuple):
    """What one update moves a pair towards, for a team to carry to other robots.

    Attributes:
        state: situation of the pair.
        person: whose part of it; None: nobody's own.
        action: its behavior.
        value: what Q(state, action) moves towards.
        weight: eligibility.
        factors: social factors that set the learning rate.
    """

    state: Hashable
    person: Hashable
    action: int
    value: float
    weight: float
    factors: Factors


Aim = tuple[Cell, float]
"""A cell, and the value that it moves towards."""


class Update(NamedTuple):
    """One update of a pair: where each of its cells moves.

    Attributes:
        state: situation of the pair.
        action: its behavior.
        weight: eligibility.
        factors: social factors that set the learning rate.
        aims: its cells, and where each moves.
    """

    state: Hashable
    action: int
    weight: float
    factors: Factors
    aims: Sequence[Aim]


@saved
@dataclass(eq=False)
class QLearner(CreditedLearner):
    """The paper's learner: Q-learning with a social rate, credit and analogy.

    `learn` checks an entry, adds it to the history and counts its transition; the
    credit rule shares each touch (or, in silence, a reward of 0) among the entries;
    each share gives a target r + gamma * max Q(s'); the analogy carries the target to
    the analogs; each moves by rate * eligibility * strength, and its visit is counted
    with it. All targets are worked out before the table changes.

    Where a representation tells people apart, each person's part has a value of its
    own, whose reward is that person's touch; what comes after is that person's part in
    the value of the behavior that is best for all (Q-decomposition: Russell & Zimdars
    2003, ICML).

    Two touches in one entry are two updates, not one of twice the reward, so values
    stay in [-1, 1] / (1 - gamma) (our choice).

    Attributes:
        gamma: weight of what comes after, per entry whatever its duration, in [0, 1).
            0.1: our choice; a touch judges what was done, not what it leads to.
        rate: the learning rate.
        analogy: where else an update goes; the base class knows no analogs.
        initial: value of a pair never updated. 0: neither polite nor impolite.
        silent_steps: what is made of silence; by default what the paper makes of it.
    """

    gamma: float = field(default=0.1, kw_only=True)
    rate: Rate = field(default_factory=SocialRate, kw_only=True)
    analogy: Analogy = field(default_factory=Analogy, kw_only=True)
    initial: float = field(default=0.0, kw_only=True)
    silent_steps: SilentSteps = field(
        default_factory=SilentSteps, kw_only=True, metadata={"later": True}
    )
    _waiting: Waiting = field(init=False, default_factory=Waiting, repr=False)
    _updates: list[Update] = field(
        init=False, default_factory=list, repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("gamma", self.gamma, 0.0, 1.0)
        check_part("rate", self.rate, "__call__")
        check_part("analogy", self.analogy, "spread", "between_named_situations")
        if not isinstance(self.silent_steps, SilentSteps):
            raise ParameterError(
                f"silent_steps is {shown(self.silent_steps)}, no SilentSteps"
            )
        if self.silent_steps.held and self.credit.shares_error:
            raise ParameterError(
                f"{type(self.credit).__name__} shares the newest pair's error, so it "
                "cannot hold silence back"
            )
        if self.gamma == 1.0:
            raise ParameterError("gamma is 1, and values would have no bound")
        by_name = isinstance(self.representation, Named)
        if self.analogy.between_named_situations and not by_name:
            raise ParameterError(
                f"{type(self.analogy).__name__} is between situations by name; with "
                f"{type(self.representation).__name__}, people are pooled in its place"
            )
        self.table = QTable(n_behaviors=self.n_behaviors, initial=self.initial)

    @property
    def targets(self) -> tuple[Target, ...]:
        """What the last `learn` moved pairs towards."""
        return tuple(
            Target(u.state, cell.person, u.action, value, u.weight, u.factors)
            for u in self._updates
            for cell, value in u.aims
        )

    def start_episode(self) -> None:
        """Forget the history, and silence held back, but nothing learned."""
        super().start_episode()
        self._waiting.credits.clear()

    def share(self, other: CreditedLearner) -> None:
        """From now on, learn into what another learner of this kind has learned."""
        super().share(other)
        if isinstance(other, QLearner):
            self.analogy = other.analogy

    def move(self, targets: Sequence[Target], strength: float = 1.0) -> None:
        """Move pairs and their analogs towards their targets.

        Args:
            targets: one per update, in order.
            strength: factor on every step, in [0, 1]; below 1 for experience that is
                another robot's.
        """
        for state, person, action, value, weight, factors in targets:
            cells = self.memory.taught(state, person)
            aims = [(cell, value) for cell in cells]
            self._move(Update(state, action, weight, factors, aims), strength)

    def _values(self, state: Hashable) -> Sequence[float]:
        return self.analogy.values(self.memory, state)

    def _visits(self, state: Hashable) -> Sequence[float]:
        return self.analogy.visits(self.memory, state)

    def _absorb(self, credits: Sequence[Credit]) -> None:
        if self.silent_steps.held:
            credits = self._due(credits)
        self._updates = [
            update for credit in credits for update in self._updates_of(credit)
        ]
        for credit in credits:
            for entry, weight in credit.shares:
                self.analogy.observe(entry, credit.reward, weight)
        for update in self._updates:
            self._move(update, 1.0)

    def _due(self, credits: Sequence[Credit]) -> Sequence[Credit]:
        newest = self.history.entries[-1]
        return self._waiting.due(
            tuple(credits),
            newest.next_time,
            approached=newest.approached,
            wait=self.silent_steps.wait,
        )

    def _updates_of(self, credit: Credit) -> list[Update]:
        reward = credit.reward
        if reward is None:
            silent = credit.designated or self.history.entries[-1]
            factors = Factors(False, silent.attended, 0.0)
        else:
            factors = Factors(True, reward.attending, reward.mood)
        aims = self._traced if self.credit.shares_error else self._aims
        return [
            Update(entry.state, entry.action, weight, factors, aims(entry, credit))
            for entry, weight in credit.shares
        ]

    def _aims(self, entry: Experience, credit: Credit) -> list[Aim]:
        """R + gamma * max Q(s'), in each cell by its own person's part of Q(s')."""
        reward = credit.reward
        value = 0.0 if reward is None else reward.value
        cells = self._taught(entry, reward)
        if self.gamma == 0.0:  # nothing of what comes after needs to be looked at
            return [(cell, value) for cell in cells]
        following = self._values(entry.next_state)
        best = max(following)
        if not self.representation.by_person:
            return [(cell, value + self.gamma * best) for cell in cells]
        parts = self.memory.parts(entry.next_state, following.index(best), cells)
        return [(c, value + self.gamma * p) for c, p in zip(cells, parts, strict=True)]

    def _traced(self, entry: Experience, credit: Credit) -> list[Aim]:
        """Where each cell stands, and the newest pair's error on top of it."""
        newest = self.history.entries[-1]
        errors = {
            cell.person: aim - self._value(newest, cell)
            for cell, aim in self._aims(newest, credit)
        }
        return [
            (cell, self._value(entry, cell) + errors[cell.person])
            for cell in self._taught(entry, credit.reward)
            if cell.person in errors
        ]

    def _taught(self, entry: Experience, reward: Reward | None) -> tuple[Cell, ...]:
        if reward is None:
            return self.memory.seen(entry.state).heard
        return self.memory.taught(entry.state, reward.giver)

    def _value(self, entry: Experience, cell: Cell) -> float:
        if self.representation.by_person:
            return self.memory.value(cell, entry.action)
        return self._values(entry.state)[entry.action]

    def _move(self, update: Update, strength: float) -> None:
        spread = self.analogy.spread(update.state)
        moves = [(cell, aim, spread[0][1]) for cell, aim in update.aims]
        if len(spread) > 1:
            moves += self._carried(update, spread[1:])
        rate = at(self.rate, self.table.updates, update.factors)
        memory, action = self.memory, update.action
        apart = self.silent_steps.apart
        for cell, aim, share in moves:
            values, visits = cell.row
            weight = update.weight * (share * strength)
            visit = weight if weight < 1.0 else 1.0
            before = visits[action]
            if apart:
                before = self._count_apart(cell, update, visit)
            step = rate(before) * weight * self._pace(values[action], aim)
            memory.move(cell, action, aim, step, visit)
        self.table.updates += 1

    def _count_apart(self, cell: Cell, update: Update, visit: float) -> float:
        """Count a visit if it is silent; return earlier ones of the same kind."""
        silences = self.table.silences(cell.name)
        silent = silences[update.action]
        if update.factors.rewarded:
            return max(cell.row.visits[update.action] - silent, 0.0)
        silences[update.action] += visit
        return silent

    def _carried(
        self, update: Update, analogs: Sequence[tuple[Hashable, float]]
    ) -> list[tuple[Cell, float, float]]:
        """The cells of analogs, each once, where they move, and how strongly."""
        own = {cell for cell, _ in update.aims}
        moves: dict[Cell, tuple[float, float]] = {}
        for state, share in analogs:
            for like, aim in update.aims:
                for cell in self.memory.alike(state, like):
                    if cell not in own:
                        moves.setdefault(cell, (aim, share))
        return [(cell, *move) for cell, move in moves.items()]

    def _pace(self, value: float, target: float) -> float:
        """Factor on the step of one update; 1 in plain Q-learning."""
        return 1.0
