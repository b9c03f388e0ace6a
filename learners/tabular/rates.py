"""Learning rates: how far one update moves a value. Reading a rate changes nothing."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from learners.errors import ParameterError, check_range, is_within, shown
from learners.saving import saved


class Factors(NamedTuple):
    """The social factors of one update.

    Attributes:
        rewarded: whether a touch was given at all.
        attended: whether the giver attended to the robot; without a touch: whether
            anybody did.
        mood: the giver's mood as perceived, in [-1, 1]; 0 without a touch.
    """

    rewarded: bool
    attended: bool
    mood: float


RateNow = Callable[[float], float]
"""The rate of one update, as a function of a pair's visits."""


class Rate(Protocol):
    """A learning rate."""

    def __call__(self, updates: float, visits: float, factors: Factors) -> float:
        """The rate in (0, 1].

        Args:
            updates: t, updates of the whole table so far.
            visits: t_sa, updates of this pair so far.
            factors: the social factors of this update.
        """
        ...


def at(rate: Rate, updates: float, factors: Factors) -> RateNow:
    """The rate of one update of many pairs.

    Args:
        rate: the rule.
        updates: t, updates of the whole table so far.
        factors: the social factors of this update.
    """
    if isinstance(rate, SocialRate):
        return rate.at(factors)
    return lambda visits: rate(updates, visits, factors)


@saved
@dataclass(frozen=True, kw_only=True)
class ConstantRate:
    """The same rate always.

    Attributes:
        alpha: the rate, in [0, 1]. Source: our choice, a common default.
    """

    alpha: float = 0.1

    def __post_init__(self) -> None:
        check_range("alpha", self.alpha, 0.0, 1.0)

    def __call__(self, updates: float, visits: float, factors: Factors) -> float:
        """The constant."""
        return self.alpha


@saved
@dataclass(frozen=True, kw_only=True)
class SynchronousRate:
    """alpha_t = 1 / (1 + t)^w, the same for all pairs.

    Source: section 3.1 of the paper.

    Attributes:
        exponent: w in (1/2, 1]. The paper gives the range alone; 0.77, about its
            middle, is our choice.
    """

    exponent: float = 0.77

    def __post_init__(self) -> None:
        if not (is_within(self.exponent, 0.5, 1.0) and self.exponent > 0.5):
            raise ParameterError(f"exponent is {shown(self.exponent)}, not in (1/2, 1]")

    def __call__(self, updates: float, visits: float, factors: Factors) -> float:
        """The rate after `updates` updates of the whole table."""
        return float((1.0 + updates) ** -self.exponent)


@saved
@dataclass(frozen=True, kw_only=True)
class AsynchronousRate:
    """alpha_t = 1 / (1 + t_sa)^w, each pair by its own visits.

    Source: section 3.1 of the paper.

    Attributes:
        exponent: w in (1/2, 1), see `SynchronousRate`.
    """

    exponent: float = 0.77

    def __post_init__(self) -> None:
        known = is_within(self.exponent, 0.5, 1.0)
        if not (known and 0.5 < self.exponent < 1.0):
            raise ParameterError(f"exponent is {shown(self.exponent)}, not in (1/2, 1)")

    def __call__(self, updates: float, visits: float, factors: Factors) -> float:
        """The rate after `visits` updates of the pair."""
        return float((1.0 + visits) ** -self.exponent)


@saved
@dataclass(frozen=True, kw_only=True)
class SocialRate:
    """alpha_t = 1 / (1 + t_sa)^w(f), with an exponent that depends on social factors.

    The rate falls with time under all factors, and how fast depends on them: slowest
    for a touch given while attending, fastest for a step that nobody rewarded or
    watched. Each factor moves the exponent half its spread up or down from the
    center:

        w(f) = center - reward * (+-1/2) - attention * (+-1/2) - mood * f.mood / 2

    with + where there was a touch, or attention. A spread of 0 switches its factor
    off. By default w is 0.6 for an attending giver's touch, 0.8 for a touch by one who
    looks away, 1.2 for silence under attention and 1.4 for silence unwatched.

    Source: the demands are section 3.1's ("a rate function with parameters for state,
    action, reward, attention, and humor"); state and action enter through t_sa. Form
    and constants are our choice.

    Attributes:
        center: mean exponent, > 1/2; 1 is the upper end of the paper's range, so that
            touches learn (w < 1) and silence all but does not (w > 1).
        reward: spread between no touch and a touch, >= 0; the strongest factor,
            since silence is mostly not meant as a judgment.
        attention: spread between unattended and attended, >= 0; weaker, since a touch
            is meant even if the giver looks away by then.
        mood: spread between the worst and the best mood of the giver, >= 0; the
            weakest, and of this sign because a tap in a bad mood says more about the
            giver than about the behavior. Moods act on touches only.

    Raises:
        ParameterError: if a spread is negative, or the smallest exponent they allow is
            not above 1/2 (values would then never settle).
    """

    center: float = 1.0
    reward: float = 0.6
    attention: float = 0.2
    mood: float = 0.1

    def __post_init__(self) -> None:
        check_range("center", self.center, 0.0)
        for name in ("reward", "attention", "mood"):
            check_range(name, getattr(self, name), 0.0)
        least = self.center - (self.reward + self.attention + self.mood) / 2.0
        if not least > 0.5:
            raise ParameterError(f"the smallest exponent is {least}, not above 1/2")

    def exponent(self, factors: Factors) -> float:
        """The exponent w(f), above 1/2."""
        rewarded, attended, mood = factors
        return (
            self.center
            + (-0.5 if rewarded else 0.5) * self.reward
            + (-0.5 if attended else 0.5) * self.attention
            - 0.5 * mood * self.mood
        )

    def at(self, factors: Factors) -> RateNow:
        """The rate under some factors, as a function of a pair's visits."""
        exponent = -self.exponent(factors)
        return lambda visits: (1.0 + visits) ** exponent

    def __call__(self, updates: float, visits: float, factors: Factors) -> float:
        """The rate after `visits` updates of the pair, under the factors."""
        return float((1.0 + visits) ** -self.exponent(factors))
