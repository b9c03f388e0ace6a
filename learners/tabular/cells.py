"""Cells of a memory: rows of its table, with what pooling adds to them."""

from collections.abc import Hashable

from learners.pooling.rules import Pooling
from learners.tabular.qtable import Row


class Cell:
    """One row as it is read.

    Attributes:
        name: of the row in the table.
        key: of the part.
        person: whose part it is; None: nobody's own.
        row: values and visits.
        written: whether the row is in the table; else it stands for an empty one.
        population: all people in this part.
        index: in the population; -1 before the row was written.
        own: per behavior, what is read of the row itself.
        pull: per behavior, how much of the population's mean is added.
        variance: per behavior, that of the person's own posterior.
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
        "variance",
        "written",
    )
    population: "Population"
    own: list[float]
    pull: list[float]
    variance: list[float]

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

    def pool(self, action: int, pooling: Pooling) -> None:
        """Work out anew what is read of one behavior."""
        n = self.row.visits[action]
        pull = pooling.pull(n, self.person)
        self.own[action] = (1.0 - pull) * self.row.values[action]
        self.pull[action] = pull
        if pooling.has_posterior:
            self.variance[action] = pooling.variance(n)

    def pool_all(self, pooling: Pooling) -> None:
        """Work out anew what is read of every behavior."""
        values, visits = self.row
        self.pull = [pooling.pull(n, self.person) for n in visits]
        self.own = [(1.0 - p) * v for p, v in zip(self.pull, values, strict=True)]
        self.variance = [pooling.variance(n) for n in visits]


class Population:
    """What was learned of all people in one part, behavior by behavior.

    Args:
        n_behaviors: how many behaviors there are.
        prior: weight of a mean of 0 before any evidence.

    Attributes:
        mean: per behavior, the population's.
    """

    __slots__ = ("_cells", "_prior", "_weighted", "_weights", "mean")

    def __init__(self, n_behaviors: int, prior: float) -> None:
        self.mean = [0.0] * n_behaviors
        self._prior = prior
        self._cells: list[Cell] = []
        self._weights: list[list[float]] = [[] for _ in self.mean]
        self._weighted: list[list[float]] = [[] for _ in self.mean]

    def join(self, cell: Cell) -> None:
        """One more person is known in this part."""
        cell.index = len(self._cells)
        self._cells.append(cell)
        for weights, weighted in zip(self._weights, self._weighted, strict=True):
            weights.append(0.0)
            weighted.append(0.0)

    def pool(self, cell: Cell, action: int, pooling: Pooling) -> None:
        """One person's row was moved: work out the mean of a behavior anew."""
        n = cell.row.visits[action]
        if n <= 0.0:
            return
        weights, weighted = self._weights[action], self._weighted[action]
        weight = pooling.weight(n)
        weights[cell.index] = weight
        weighted[cell.index] = weight * cell.row.values[action]
        # Summed up anew, so that rounding does not depend on the way here.
        self.mean[action] = sum(weighted) / (self._prior + sum(weights))

    def visits(self, action: int) -> float:
        """Visits of all people together."""
        return sum(cell.row.visits[action] for cell in self._cells)

    def variance(self, action: int) -> float:
        """Posterior variance of the mean, where weights are precisions."""
        return 1.0 / (self._prior + sum(self._weights[action]))

    def others(self, cell: Cell, action: int) -> float | None:
        """Mean of all but one person; None if nothing is known of them."""
        weights, weighted = self._weights[action], self._weighted[action]
        total, values = sum(weights), sum(weighted)
        if cell.index >= 0:
            total -= weights[cell.index]
            values -= weighted[cell.index]
        return values / total if total > _LEAST else None


_LEAST = 1e-9  # below, the difference is rounding
