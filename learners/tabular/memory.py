"""The table as a learner reads and writes it, by representation and pooling."""

from collections.abc import Hashable, Iterable, Sequence
from operator import add, mul
from typing import TypeVar, cast

from learners.pooling.adaptive import AdaptivePooling
from learners.pooling.rules import Pooling
from learners.representation.parts import Representation
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
    """

    __slots__ = ("cells", "heard")

    def __init__(self, cells: tuple[Cell, ...], heard: tuple[Cell, ...]) -> None:
        self.cells = cells
        self.heard = heard


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
        self.representation = representation
        self.pooling = pooling
        self._by_person = representation.by_person
        self._adaptive = pooling if isinstance(pooling, AdaptivePooling) else None
        self._seen: dict[Hashable, Seen] = {}
        self._cells: dict[Hashable, Cell] = {}
        self._populations: dict[Hashable, Population] = {}
        self._nothing = [0.0] * table.n_behaviors
        if self._by_person:
            for key, person in cast(Iterable[tuple[Hashable, Hashable]], table.rows):
                self._cell(key, person)

    def seen(self, state: Hashable) -> Seen:
        """A state as it is represented; the same object as long as it is remembered.

        Raises:
            StateError: if the state lacks what the representation asks of it.
        """
        seen = self._seen.get(state)
        if seen is None:
            parts = self.representation.parts(state)
            cells = tuple(self._cell(part.key, part.person) for part in parts)
            pairs = zip(cells, parts, strict=True)
            heard = tuple(cell for cell, part in pairs if part.perceives)
            seen = Seen(cells, heard)
            if len(self._seen) >= MEMO_SIZE:
                self._forget()
            self._seen[state] = seen
        return seen

    def taught(self, state: Hashable, giver: Hashable) -> tuple[Cell, ...]:
        """The cells of a state that a touch of this giver teaches; maybe none."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells
        return tuple(cell for cell in cells if cell.person == giver)

    def alike(self, state: Hashable, cell: Cell) -> tuple[Cell, ...]:
        """The cells of another state that stand where this one stands in its own."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells
        return tuple(each for each in cells if each.key == cell.key)

    def values(self, state: Hashable) -> Sequence[float]:
        """Value of each behavior, the sum over parts; for reading only."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells[0].row.values
        if not cells:
            return self._nothing
        self._adapt(cells)
        own = zip(*[cell.own for cell in cells], strict=True)
        pull = zip(*[cell.pull for cell in cells], strict=True)
        common = zip(*[cell.population.mean for cell in cells], strict=True)
        return [
            sum(map(add, o, map(mul, p, c)))
            for o, p, c in zip(own, pull, common, strict=True)
        ]

    def visits(self, state: Hashable) -> Sequence[float]:
        """Visits behind those values: one's own, others' as far as one is pulled."""
        cells = self.seen(state).cells
        if not self._by_person:
            return cells[0].row.visits
        self._adapt(cells)
        found = self._nothing.copy()
        for cell in cells:
            for a, (n, pull) in enumerate(zip(cell.row.visits, cell.pull, strict=True)):
                others = cell.population.visits(a) - n if pull else 0.0
                found[a] += n + pull * others
        return found

    def deviations(self, state: Hashable) -> Sequence[float]:
        """Standard deviation of the posterior of each value; 0 without a posterior."""
        found = self._nothing.copy()
        for cell in self.seen(state).cells:
            population = cell.population
            for a, (own, pull) in enumerate(zip(cell.variance, cell.pull, strict=True)):
                found[a] += own + pull**2 * population.variance(a)
        return [variance**0.5 for variance in found]

    def parts(self, state: Hashable, action: int) -> dict[Hashable, float]:
        """Each person's part in the value of one behavior."""
        cells = self.seen(state).cells
        return {cell.person: self.value(cell, action) for cell in cells}

    def value(self, cell: Cell, action: int) -> float:
        """What is read of one cell."""
        if not self._by_person:
            return cell.row.values[action]
        self._adapt((cell,))
        return cell.own[action] + cell.pull[action] * cell.population.mean[action]

    def move(
        self, cell: Cell, action: int, target: float, step: float, visits: float
    ) -> None:
        """Move one value of a cell towards a target; see `Row.move`."""
        if not cell.written:
            cell.row = self.table.add(cell.name)
            cell.written = True
            if self._by_person:
                cell.population.join(cell)
        cell.row.move(action, target, step, visits)
        if self._by_person:
            cell.pool(action, self.pooling)
            cell.population.pool(cell, action, self.pooling)

    def compare(self, cell: Cell, action: int, value: float, weight: float) -> None:
        """Let an adaptive pooling compare what a person did with what others do."""
        if self._adaptive is not None and self._by_person:
            expected = cell.population.others(cell, action)
            if expected is not None:
                self._adaptive.compare(cell.person, value, expected, weight)

    def _adapt(self, cells: Sequence[Cell]) -> None:
        if self._adaptive is None:
            return
        for cell in cells:
            if cell.revision != self._adaptive.revision:
                cell.pool_all(self._adaptive)
                cell.revision = self._adaptive.revision

    def _cell(self, key: Hashable, person: Hashable) -> Cell:
        name = (key, person) if self._by_person else key
        cell = self._cells.get(name)
        if cell is None:
            cell = self._cells[name] = self._made(name, key, person)
        return cell

    def _made(self, name: Hashable, key: Hashable, person: Hashable) -> Cell:
        written = name in self.table.rows
        cell = Cell(name, key, person, self.table.row(name), written=written)
        if self._by_person:
            population = self._populations.get(key)
            if population is None:
                population = Population(self.table.n_behaviors, self.pooling.prior)
                self._populations[key] = population
            cell.population = population
            cell.pool_all(self.pooling)
            if written:
                population.join(cell)
                for action in range(self.table.n_behaviors):
                    population.pool(cell, action, self.pooling)
        return cell

    def _forget(self) -> None:
        """Forgets what can be worked out again."""
        self._seen.clear()
        self._cells = {n: cell for n, cell in self._cells.items() if cell.written}
