"""How a behavior is chosen from what is known of each."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple, Protocol

import numpy as np

from learners.errors import check_positive, check_range
from learners.saving import saved
from learners.sums import added


class Estimates(NamedTuple):
    """What is known of the behaviors in one state; sequences of length n_behaviors.

    Attributes:
        values: expected value of each.
        visits: updates behind each value.
        deviations: standard deviation of each value's posterior; None if the learner
            keeps no posterior.
        alone: whether nobody perceives the robot; told to `SeekCompany` alone.
    """

    values: Sequence[float]
    visits: Sequence[float]
    deviations: Sequence[float] | None = None
    alone: bool = False


class Exploration(Protocol):
    """An exploration rule."""

    @property
    def needs_visits(self) -> bool:
        """Whether it asks for `Estimates.visits`."""
        ...

    @property
    def needs_posterior(self) -> bool:
        """Whether it asks for `Estimates.deviations`."""
        ...

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """Index of the chosen behavior."""
        ...


def best(values: Sequence[float], rng: np.random.Generator) -> int:
    """Index of the largest value; ties are broken at random."""
    top = max(values)
    ties = [index for index, value in enumerate(values) if value == top]
    return ties[0] if len(ties) == 1 else ties[int(rng.random() * len(ties))]


def softmax(values: Sequence[float], temperature: float) -> list[float]:
    """Boltzmann probabilities exp(v / temperature) / sum, length n_behaviors."""
    top = max(values)
    weights = [math.exp((value - top) / temperature) for value in values]
    total = added(weights)
    return [weight / total for weight in weights]


def draw(probabilities: Sequence[float], rng: np.random.Generator) -> int:
    """An index drawn with the given probabilities, which sum to 1."""
    point = float(rng.random())
    for index, probability in enumerate(probabilities):
        point -= probability
        if point < 0.0:
            return index
    # Rounding can leave a sum a hair under 1; the point then belongs to the last one
    # that can happen at all.
    return max(i for i, p in enumerate(probabilities) if p > 0.0)


@saved
@dataclass(frozen=True, kw_only=True)
class Greedy:
    """Always the best behavior so far."""

    needs_visits: ClassVar[bool] = False
    needs_posterior: ClassVar[bool] = False

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """The best one; ties at random."""
        return best(estimates.values, rng)


@saved
@dataclass(frozen=True, kw_only=True)
class EpsilonGreedy:
    """The best behavior, or now and then any.

    Attributes:
        epsilon: probability of drawing any behavior, in [0, 1]. Source: our choice.
    """

    epsilon: float = 0.1
    needs_visits: ClassVar[bool] = False
    needs_posterior: ClassVar[bool] = False

    def __post_init__(self) -> None:
        check_range("epsilon", self.epsilon, 0.0, 1.0)

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """The best one with probability 1 - epsilon, else any."""
        if rng.random() < self.epsilon:
            return int(rng.random() * len(estimates.values))
        return best(estimates.values, rng)


@saved
@dataclass(frozen=True, kw_only=True)
class Softmax:
    """Better behaviors more often (Boltzmann exploration).

    Attributes:
        temperature: > 0, in units of touches: a behavior one whole caress better than
            another is chosen exp(1 / temperature) times as often. 0.2: about 150
            times. Source: our choice; the paper does not say how it explored.
    """

    temperature: float = 0.2
    needs_visits: ClassVar[bool] = False
    needs_posterior: ClassVar[bool] = False

    def __post_init__(self) -> None:
        check_positive("temperature", self.temperature)

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """A draw from the Boltzmann distribution."""
        return draw(softmax(estimates.values, self.temperature), rng)


@saved
@dataclass(frozen=True, kw_only=True)
class UpperConfidence:
    """The behavior that could be best: Q + width * sqrt(ln(1 + sum n) / n).

    A behavior never tried comes first.

    Source: UCB1 (Auer, Cesa-Bianchi & Fischer 2002), applied in each state.

    Attributes:
        width: > 0; sqrt(2) is UCB1's for rewards in [0, 1]. Source: our choice, half
            of it, since most touches of a behavior agree.
    """

    width: float = 0.7
    needs_visits: ClassVar[bool] = True
    needs_posterior: ClassVar[bool] = False

    def __post_init__(self) -> None:
        check_positive("width", self.width)

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """The behavior with the highest upper bound; ties at random."""
        log_total = math.log1p(added(estimates.visits))
        return best(
            [
                value + self.width * math.sqrt(log_total / count)
                if count > 0.0
                else math.inf
                for value, count in zip(estimates.values, estimates.visits, strict=True)
            ],
            rng,
        )


@saved
@dataclass(frozen=True, kw_only=True)
class Thompson:
    """The behavior that is best in one draw from the posterior.

    Only for learners that keep a posterior (`Estimates.deviations`).

    Source: Thompson (1933); normal posteriors.
    """

    needs_visits: ClassVar[bool] = False
    needs_posterior: ClassVar[bool] = True

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """The best of one normal draw per behavior."""
        means, deviations = estimates.values, estimates.deviations or ()
        points = rng.standard_normal(len(means)).tolist()
        draws = [
            mean + deviation * point
            for mean, deviation, point in zip(means, deviations, points, strict=True)
        ]
        return draws.index(max(draws))
