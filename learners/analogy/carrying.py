"""Analogy: experience with one situation serves situations like it.

Source: section 3.2 of the paper, "Using Analogy to Accelerate Learning".
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import ClassVar

from learners.analogy.operators import Operator, SwapRoles
from learners.errors import ParameterError, check_range, check_whole, shown
from learners.experience import Experience, Reward
from learners.representation.states import is_state
from learners.saving import DERIVED, saved
from learners.sums import added
from learners.tabular.memory import MEMO_SIZE, Memory, remember


@saved
@dataclass(kw_only=True, eq=False)
class Analogy:
    """How a learner reads and writes for a state; this one knows no analogs.

    Subclasses change where an update goes (`spread`) and what a state reads
    (`values`), never the table itself.
    """

    between_named_situations: ClassVar[bool] = False
    """Whether it asks for the representation by whole situations with names."""

    def values(self, memory: Memory, state: Hashable) -> Sequence[float]:
        """Values of a state as this analogy sees them, length n_behaviors."""
        return memory.values(state)

    def visits(self, memory: Memory, state: Hashable) -> Sequence[float]:
        """Visits behind those values, length n_behaviors."""
        return memory.visits(state)

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """States that an update of a state goes to, each with its strength in [0, 1].

        The first one is the state itself.
        """
        return ((state, 1.0),)

    def observe(self, entry: Experience, reward: Reward | None, weight: float) -> None:
        """Take note of what was credited to an entry, before the table changes.

        Args:
            entry: the credited entry.
            reward: the touch; None if the entry passed in silence.
            weight: its eligibility.
        """


@saved
@dataclass(kw_only=True, eq=False)
class Propagation(Analogy):
    """Carries every update to the analogs that operators list (as in the paper).

    Operators are applied to their own results up to `depth` times, nearest analogs
    first. An analog reached in d steps takes the update at strength ** d.

    What was carried to simpler situations is read back: where a behavior was never
    tried, a situation borrows from the simpler ones that it contains, those with the
    fewest entities less first (back-off, as in Katz 1987, IEEE Transactions on
    Acoustics, Speech and Signal Processing 35).

    Attributes:
        operators: the operators.
        strength: how much of a step an analog takes per application, in [0, 1]. 1:
            "what is true for e1 will be true for e2". Source: our choice; the paper
            has none.
        depth: how often operators are applied, >= 1. 1 suffices for two actors; n - 1
            closes SwapRoles over n actors.
        limit: most analogs an update is carried to, >= 0. 5040 = 7!: the closure for
            seven actors; beyond, take the canonical representation. Source: our choice.
    """

    operators: tuple[Operator, ...] = (SwapRoles(),)
    strength: float = 1.0
    depth: int = 1
    limit: int = 5040
    _memo: dict[Hashable, tuple[tuple[Hashable, float], ...]] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )
    _simpler: dict[Hashable, tuple[tuple[Hashable, ...], ...]] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )

    def __post_init__(self) -> None:
        check_range("strength", self.strength, 0.0, 1.0)
        check_whole("depth", self.depth, 1, 1000)
        check_whole("limit", self.limit, 0, 10**6)
        if not all(map(callable, self.operators)):
            raise ParameterError(f"operators are {shown(self.operators)}, no functions")

    def spread(self, state: Hashable) -> Sequence[tuple[Hashable, float]]:
        """The state itself, then its analogs, nearest first."""
        known = self._memo.get(state)
        if known is None:
            known = tuple(self._closure(state).items())
            remember(self._memo, state, known, MEMO_SIZE // len(known))
        return known

    def values(self, memory: Memory, state: Hashable) -> Sequence[float]:
        """The state's own values; of behaviors never tried, simpler situations'."""
        values = memory.values(state)
        simpler = self.simpler(state)
        if not simpler:
            return values
        visits = memory.visits(state)
        if all(visits):
            return values
        borrowed = (_borrowed(memory, simpler, b) for b in range(len(values)))
        triples = zip(values, visits, borrowed, strict=True)
        return [own if tried else other for own, tried, other in triples]

    def simpler(self, state: Hashable) -> tuple[tuple[Hashable, ...], ...]:
        """The analogs with fewer entities, by how many are left, most first."""
        known = self._simpler.get(state)
        if known is None:
            analogs = [s for s, _ in self.spread(state)]
            sizes: dict[Hashable, int] = {
                s: len(s.entities) for s in analogs if is_state(s)
            }
            fewer = [s for s in sizes if sizes[s] < sizes.get(state, 0)]
            fewer.sort(key=lambda s: -sizes[s])
            groups = groupby(fewer, key=sizes.__getitem__)
            known = tuple(tuple(group) for _, group in groups)
            remember(self._simpler, state, known, MEMO_SIZE // (1 + len(fewer)))
        return known

    def _closure(self, state: Hashable) -> dict[Hashable, float]:
        reached: dict[Hashable, float] = {state: 1.0}
        frontier: list[Hashable] = [state]
        for distance in range(1, self.depth + 1):
            found = self._new_analogs(frontier, reached)
            frontier = found[: self.limit + 1 - len(reached)]
            reached |= dict.fromkeys(frontier, self.strength**distance)
        return reached

    def _new_analogs(
        self, states: list[Hashable], reached: dict[Hashable, float]
    ) -> list[Hashable]:
        found = (a for s in states for op in self.operators for a in op(s))
        return [a for a in dict.fromkeys(found) if a not in reached]


def _borrowed(
    memory: Memory, simpler: Sequence[Sequence[Hashable]], behavior: int
) -> float:
    """Mean value, by visits, in the nearest group in which a behavior was tried."""
    for states in simpler:
        visits = [memory.visits(state)[behavior] for state in states]
        total = added(visits)
        if total > 0.0:
            values = [memory.values(state)[behavior] for state in states]
            return added(n * v for n, v in zip(visits, values, strict=True)) / total
    return 0.0
