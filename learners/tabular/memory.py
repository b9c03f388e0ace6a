"""The table as a learner reads and writes it, by representation and pooling."""

from collections.abc import Hashable, Iterable, Sequence
from operator import add, mul
from typing import TypeVar, cast

from learners.pooling.adaptive import AdaptivePooling
from learners.pooling.rules import Pooling
from learners.representation.parts import Representation
from learners.sums import added
from learners.tabular.cells import Cell, Population
from learners.tabular.qtable import QTable

MEMO_SIZE = 1 << 16
"""Most states that are kept with what was worked out of them."""

_T = TypeVar("_T")


def remember(memo: dict[Hashable, _T], state: Hashable, known: _T, most: int) -> None:
    """Note what is known of a state; all is forgotten when `most` are noted."""
    # Forgetting all at once is rare enough to be cheaper than keeping an order.
    if len(memo) >= most:
        memo.clear()
    memo[state] = known


class Seen:
    """A state as it is represented.

    Attributes:
        cells: a cell for each part.
        heard: those whose silence says something.
        own: of each cell, what is read of itself.
        pull: of each cell, how far it is drawn to its population.
        mean: of each cell, the mean of its population.
        people: cells by person, one for each level of detail.
    """

    __slots__ = ("cells", "heard", "mean", "own", "people", "pull")

    def __init__(self, cells: tuple[Cell, ...], heard: tuple[Cell, ...]) -> None:
        self.cells = cells
        self.heard = heard
        # These lists are written in place, so they can be handed over once and for all.
        self.own = [cell.own for cell in cells]
        self.pull = [cell.pull for cell in cells]
        self.mean: list[list[float]] = []
        self.people: dict[Hashable, tuple[Cell, ...]] = {}


_NEVER = object()  # a state that is never met


class Memory:
    """Reads and writes a table through a representation and a pooling.

    Nothing here is saved: all of it follows from the table.

    Args:
        table: values and visits, a row for each part that was ever written.
        representation: which rows a state is kept in.
        pooling: how far people are read off each other.
    """

    def __init__(
        self, table: QTable, representation: Representation, pooling: Pooling
    ) -> None:
        self.table = table
        self._representation = representation
        self._pooling = pooling
        self._by_person = representation.by_person
        self.n_levels = representation.n_levels
        self._adaptive = pooling if isinstance(pooling, AdaptivePooling) else None
        self._seen: dict[Hashable, Seen] = {}
        self._cells: dict[Hashable, Cell] = {}
        self._populations: dict[Hashable, Population] = {}
        self._latest = self._before = (_NEVER, Seen((), ()))
        if self._by_person:
            for key, person in cast(Iterable[tuple[Hashable, Hashable]], table.rows):
                self._cell(key, person)

    def seen(self, state: Hashable) -> Seen:
        """A state as it is represented; the same object as long as it is remembered.

        Raises:
            StateError: if the state lacks what the representation asks of it.
        """
        # Asked several times about the same two: before and after an entry.
        if state is self._latest[0]:
            return self._latest[1]
        if state is not self._before[0]:
            self._before, self._latest = self._latest, (state, self._known(state))
            return self._latest[1]
        return self._before[1]

    def taught(self, state: Hashable, giver: Hashable) -> tuple[Cell, ...]:
        """The cells of a state that a touch of this giver teaches; maybe none."""
        seen = self.seen(state)
        if not self._by_person:
            return seen.cells
        return seen.people.get(giver, ())

    def alike(self, state: Hashable, cell: Cell) -> tuple[Cell, ...]:
        """The cells of another state that stand where this one stands in its own."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells
        return tuple(each for each in cells if each.key == cell.key)

    def values(self, state: Hashable) -> Sequence[float]:
        """Value of each behavior, summed over parts of a level; for reading only."""
        seen = self.seen(state)
        if not self._by_person:
            return seen.cells[0].row.values
        if not seen.cells:
            return self._zeros()
        if self._adaptive is not None:
            self._adapt(seen.cells)
        own, pull, mean = zip(*seen.own), zip(*seen.pull), zip(*seen.mean)  # noqa: B905
        found = [
            added(map(add, o, map(mul, p, m)))
            for o, p, m in zip(own, pull, mean)  # noqa: B905 - strictness takes time
        ]
        return self._mean(found)

    def visits(self, state: Hashable) -> Sequence[float]:
        """Visits behind those values: one's own, others' as far as one is pulled."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells[0].row.visits
        self._adapt(cells)
        found = self._zeros()
        for cell in cells:
            for a, (n, pull) in enumerate(zip(cell.row.visits, cell.pull, strict=True)):
                others = cell.population.visits(a) - n if pull else 0.0
                found[a] += n + pull * others
        return self._mean(found)

    def deviations(self, state: Hashable) -> Sequence[float]:
        """Standard deviation of the posterior of each value."""
        cells = self.seen(state).cells
        pulls = zip(*[cell.pull for cell in cells])  # noqa: B905 - see `values`
        common = zip(*[cell.population.variance for cell in cells])  # noqa: B905
        between = self._pooling.between
        found = [
            between * added(pull) + added(map(mul, map(mul, pull, pull), variance))
            for pull, variance in zip(pulls, common, strict=True)
        ]
        deviations = [variance**0.5 for variance in found] or self._zeros()
        return self._mean(deviations)

    def parts(self, state: Hashable, action: int, cells: Sequence[Cell]) -> list[float]:
        """What the people of some cells have for a part in the value of a behavior."""
        people = self.seen(state).people
        found = [people.get(cell.person, ()) for cell in cells]
        return [self.expected(own, action) for own in found]

    def expected(self, own: Sequence[Cell], action: int) -> float:
        """What is expected of a person, the mean over its cells; 0 without any."""
        return added(self.value(cell, action) for cell in own) / self.n_levels

    def value(self, cell: Cell, action: int) -> float:
        """What is read of one cell."""
        if not self._by_person:
            return cell.row.values[action]
        if self._adaptive is not None:
            self._adapt((cell,))
        return cell.own[action] + cell.pull[action] * cell.population.mean[action]

    def move(
        self, cell: Cell, action: int, target: float, step: float, visits: float
    ) -> None:
        """Move one value of a cell towards a target; see `Row.move`."""
        if not cell.written:
            self._write(cell)
        cell.row.move(action, target, step, visits)
        if self._by_person:
            cell.pool(action, self._pooling)

    def compare(self, cell: Cell, action: int, value: float, weight: float) -> None:
        """Let an adaptive pooling compare what a person did with what others do."""
        if self._adaptive is not None and self._by_person:
            expected = cell.population.others(cell, action)
            if expected is not None:
                self._adaptive.compare(cell.person, value, expected, weight)

    def _mean(self, sums: list[float]) -> list[float]:
        """Of sums over all cells, the mean over levels."""
        levels = self.n_levels
        return sums if levels == 1 else [each / levels for each in sums]

    def _zeros(self) -> list[float]:
        return [0.0] * self.table.n_behaviors

    def _adapt(self, cells: Sequence[Cell]) -> None:
        if self._adaptive is None:
            return
        for cell in cells:
            if cell.revision != self._adaptive.revision:
                cell.pool_all(self._adaptive)
                cell.revision = self._adaptive.revision

    def _known(self, state: Hashable) -> Seen:
        seen = self._seen.get(state)
        if seen is None:
            if len(self._seen) >= MEMO_SIZE:
                self._forget()
            seen = self._seen[state] = self._look(state)
        return seen

    def _look(self, state: Hashable) -> Seen:
        parts = self._representation.parts(state)
        cells = tuple([self._cell(key, person) for key, person, _ in parts])
        heard = tuple([c for c, p in zip(cells, parts, strict=True) if p.perceives])
        seen = Seen(cells, cells if len(heard) == len(cells) else heard)
        if self._by_person:
            seen.mean = [cell.population.mean for cell in cells]
            for cell in cells:
                known = seen.people.get(cell.person, ())
                seen.people[cell.person] = (*known, cell)
        return seen

    def _cell(self, key: Hashable, person: Hashable) -> Cell:
        name = (key, person) if self._by_person else key
        cell = self._cells.get(name)
        if cell is None:
            row, written = self.table.row(name), name in self.table.rows
            cell = Cell(name, key, person, row, written=written)
            self._cells[name] = cell
            if self._by_person:
                self._settle(cell)
        return cell

    def _settle(self, cell: Cell) -> None:
        """Gives a cell its population."""
        population = self._populations.get(cell.key)
        if population is None:
            population = Population(self.table.n_behaviors, self._pooling.prior)
            self._populations[cell.key] = population
        cell.population = population
        if cell.written:
            population.join(cell)
        cell.pool_all(self._pooling)

    def _write(self, cell: Cell) -> None:
        cell.row = self.table.add(cell.name)
        cell.written = True
        if self._by_person:
            cell.population.join(cell)

    def _forget(self) -> None:
        """Forgets what can be worked out again."""
        self._seen.clear()
        self._latest = self._before = (_NEVER, Seen((), ()))
        self._cells = {name: c for name, c in self._cells.items() if c.written}
