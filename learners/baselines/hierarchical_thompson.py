"""Hierarchical Thompson sampling over actors.

Hong, Kveton, Zaheer & Ghavamzadeh (2022), "Hierarchical Bayesian bandits", AISTATS:
each person is a bandit whose means are drawn around those of the population, and one
draw from the posterior of both decides.
"""

from collections.abc import Hashable
from dataclasses import dataclass, field

from learners.baselines.personwise import Personwise
from learners.errors import check_positive
from learners.exploration import Exploration, Thompson
from learners.saving import saved


@saved
@dataclass(eq=False)
class HierarchicalThompson(Personwise):
    """Normal touches around a person's taste, normal tastes around the population's.

    For each place and behavior: population mean m ~ N(0, population^2), a person's
    taste ~ N(m, person^2), its touches ~ N(taste, touch^2).

    Attributes:
        exploration: Thompson sampling.
        population: standard deviation of population means, > 0. 0.5: our choice, since
            touches lie in [-1, 1].
        person: standard deviation of people around them, > 0. 0.3: our choice; people
            agree more than they differ.
        touch: standard deviation of touches around a taste, > 0. 0.5: our choice.
    """

    exploration: Exploration = field(default_factory=Thompson, kw_only=True)
    population: float = field(default=0.5, kw_only=True)
    person: float = field(default=0.3, kw_only=True)
    touch: float = field(default=0.5, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("population", "person", "touch"):
            check_positive(name, getattr(self, name))

    def opinion(
        self, person: Hashable, place: Hashable, behavior: int
    ) -> tuple[float, float]:
        """Posterior mean and variance of a person's taste."""
        told = self.opinions.get((place, behavior), {})
        between, within = self.person**2, self.touch**2
        weights = [1.0 / (between + within / n) for n, _ in told.values()]
        precision = 1.0 / self.population**2 + sum(weights)
        means = [mean for _, mean in told.values()]
        common = sum(w * m for w, m in zip(weights, means, strict=True)) / precision
        n, mean = told.get(person, (0.0, 0.0))
        own_precision = 1.0 / between + n / within
        shrink = 1.0 / between / own_precision  # how far the taste is the population's
        variance = 1.0 / own_precision + shrink**2 / precision
        return (1.0 - shrink) * mean + shrink * common, variance
