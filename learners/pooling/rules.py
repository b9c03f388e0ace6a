"""Rules of pooling: none, full, and hierarchical.

What is learned of each person in a part of a situation is kept apart, as a mean and how
much it is of. What is read of a person is drawn towards the population:

    (1 - pull) * own + pull * common,   common = sum of w * own / (prior + sum of w)

over all people known in this part. A stranger has nothing of its own and starts from
the population as far as the rule pulls it there. Gelman & Hill (2007), "Data analysis
using regression and multilevel/hierarchical models", chapter 12.
"""

from abc import ABC, abstractmethod
from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import Any, ClassVar

from learners.errors import check_positive, check_range
from learners.saving import DERIVED, saved


class Pooling(ABC):
    """How far people are read off each other; users add their own."""

    has_posterior: ClassVar[bool] = False
    """Whether weights are precisions and `between` is known, so that what is read is
    the mean of a posterior."""

    learns: ClassVar[bool] = False
    """Whether it changes with what people are found to do; see `AdaptivePooling`."""

    prior: float = 0.0
    """Weight of a population mean of 0 before any evidence, >= 0."""

    between: float = 0.0
    """Variance of people around the population; of a posterior, pull times it is the
    variance of a person, were the population's mean known."""

    @abstractmethod
    def terms(self, n: float, person: Hashable) -> tuple[float, float]:
        """How a person of n observations and the population draw on each other.

        Returns:
            How far the person is drawn to the population, in [0, 1], and what it weighs
            in the population's mean, 0 without observations.
        """


@saved
@dataclass(frozen=True, kw_only=True)
class NoPooling(Pooling):
    """Each person by itself; a stranger starts from nothing."""

    def terms(self, n: float, person: Hashable) -> tuple[float, float]:
        """Not at all, whatever the population."""
        return 0.0, n


@saved
@dataclass(frozen=True, kw_only=True)
class FullPooling(Pooling):
    """All people are one; a stranger is known as well as anybody.

    Attributes:
        prior: observations of 0 that the population's mean begins with, >= 0.
    """

    prior: float = 0.0

    def __post_init__(self) -> None:
        check_range("prior", self.prior, 0.0)

    def terms(self, n: float, person: Hashable) -> tuple[float, float]:
        """All the way; everybody weighs by observations."""
        return 1.0, n


def _derived() -> Any:  # noqa: ANN401 - a field of whatever type
    return field(init=False, repr=False, compare=False, metadata=DERIVED)


@saved
@dataclass(frozen=True, kw_only=True)
class HierarchicalPooling(Pooling):
    """Normal observations around a person's mean, normal means around a population's.

    For each part and behavior: population mean m ~ N(0, population^2), a person's mean
    ~ N(m, person^2), what it does ~ N(its mean, touch^2). What is read is the posterior
    mean of the person.

    Attributes:
        population: standard deviation of population means, > 0. 0.5: our choice, for
            means of touches, which lie in [-1, 1].
        person: standard deviation of people around them, > 0. 0.3: our choice; people
            agree more than they differ.
        touch: standard deviation of what a person does around its mean, > 0. 0.5: our
            choice.
    """

    has_posterior: ClassVar[bool] = True
    population: float = 0.5
    person: float = 0.3
    touch: float = 0.5
    # Worked out once, as they are asked for with every update.
    prior: float = _derived()
    between: float = _derived()
    _within: float = _derived()
    _precision: float = _derived()

    def __post_init__(self) -> None:
        for name in ("population", "person", "touch"):
            check_positive(name, getattr(self, name))
        worked_out = {
            "prior": 1.0 / self.population**2,
            "between": self.person**2,
            "_within": self.touch**2,
            "_precision": 1.0 / self.person**2,
        }
        for name, value in worked_out.items():
            object.__setattr__(self, name, value)

    def terms(self, n: float, person: Hashable) -> tuple[float, float]:
        """The less, the more is known; weights are precisions of people's means."""
        if n <= 0.0:
            return 1.0, 0.0
        return (
            self._precision / (self._precision + n / self._within),
            1.0 / (self.between + self._within / n),
        )
