"""Cells of a memory: rows of its table, with what pooling adds to them."""

from collections.abc import Hashable

from learners.pooling.rules import Pooling
from learners.sums import added
from learners.tabular.qtable import Row


class Population:
    """What was learned of all people in one part, behavior by behavior.

    Args:
        n_behaviors: how many behaviors there are.
        prior: weight of a mean of 0 before any evidence.

    Attributes:
        mean: per behavior, the population's.
        variance: per behavior, that of the mean, where weights are precisions.
    """

    __slots__ = ("_cells", "_prior", "_weighted", "_weights", "mean", "variance")

    def __init__(self, n_behaviors: int, prior: float) -> None:
        self.mean = [0.0] * n_behaviors
        self.variance = [1.0 / prior if prior else 0.0] * n_behaviors
        self._prior = prior
        self._cells: list[Cell] = []
        self._weights: list[list[float]] = [[] for _ in self.mean]
        self._weighted: list[list[float]] = [[] for _ in self.mean]

    def join(self, cell: "Cell") -> None:
        """One more person is known in this part."""
        cell.index = len(self._cells)
        self._cells.append(cell)
        for weights, weighted in zip(self._weights, self._weighted, strict=True):
            weights.append(0.0)
            weighted.append(0.0)

    def weigh(self, action: int, index: int, weight: float, value: float) -> None:
        """One person's row was moved: work out the mean of a behavior anew."""
        weights, weighted = self._weights[action], self._weighted[action]
        weights[index] = weight
        weighted[index] = weight * value
        # Summed up anew, so that rounding does not depend on the way here.
        total = self._prior + added(weights)
        if total > 0.0:
            self.mean[action] = added(weighted) / total
            self.variance[action] = 1.0 / total

    def visits(self, action: int) -> float:
        """Visits of all people together."""
        return added(cell.row.visits[action] for cell in self._cells)

    def others(self, cell: "Cell", action: int) -> float | None:
        """Mean of all but one person; None if nothing is known of them."""
        weights, weighted = self._weights[action], self._weighted[action]
        total, values = added(weights), added(weighted)
        if cell.index >= 0:
            total -= weights[cell.index]
            values -= weighted[cell.index]
        return values / total if total > _LEAST else None


class Cell:
    """One row as it is read.

    Args:
        name: of the row in the table.
        key: of the part.
        person: whose part it is; None: nobody's own.
        row: values and visits; an empty one stands for a row that is not written yet.
        written: whether the row is in the table.

    Attributes:
        population: all people in this part; None if it is nobody's own.
        index: in the population; -1 before the row was written.
        own: per behavior, what is read of the row itself.
        pull: per behavior, how much of the population's mean is added.
        revision: of an adaptive pooling, when `own` and `pull` were worked out.
    """

    __slots__ = (
        "index",
        "key",
        "name",
        "own",
        "person",
        "population",
        "pull",
        "revision",
        "row",
        "written",
    )
    population: Population

    def __init__(
        self,
        name: Hashable,
        key: Hashable,
        person: Hashable,
        row: Row,
        *,
        written: bool,
    ) -> None:
        self.name, self.key, self.person = name, key, person
        self.row, self.written = row, written
        self.index, self.revision = -1, -1
        self.own: list[float] = row.values.copy()
        self.pull: list[float] = [0.0] * len(self.own)

    def pool(self, action: int, pooling: Pooling) -> None:
        """Work out anew what is read of a behavior, here and in the population."""
        values, visits = self.row
        value = values[action]
        pull, weight = pooling.terms(visits[action], self.person)
        self.own[action] = (1.0 - pull) * value
        self.pull[action] = pull
        if self.index >= 0:
            self.population.weigh(action, self.index, weight, value)

    def pool_all(self, pooling: Pooling) -> None:
        """Work out anew what is read of every behavior."""
        for action in range(len(self.own)):
            self.pool(action, pooling)


_LEAST = 1e-9  # below, the difference is rounding
