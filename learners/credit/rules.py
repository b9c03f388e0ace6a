"""Credit: which past pairs (situation, behavior) a reward is about."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

from learners.credit.heuristics import BeforeApproach, Heuristic
from learners.credit.history import History
from learners.credit.transitions import SituationNetwork
from learners.errors import ParameterError, check_positive, check_range, shown
from learners.experience import Reward
from learners.saving import saved

LEAST_WEIGHT = 1e-3
"""Eligibilities below this are left out: Table 1 of the paper shows them as 0.000."""


class Weighing(NamedTuple):
    """How a reward is shared among the entries of the history.

    Attributes:
        weights: eligibility by entry index, each above 0; a pair that occurs more
            than once may stand under its latest index alone.
        designated: index of the entry that it is about above all; None if none is.
    """

    weights: dict[int, float]
    designated: int | None


class CreditRule(ABC):
    """A rule that shares a reward among the entries of the history.

    Users add their own by implementing `weigh`.
    """

    shares_error: ClassVar[bool] = False
    """True: all pairs move by the newest pair's error, as eligibility traces do.
    False: each pair moves towards the reward by its own error."""

    @abstractmethod
    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """Share one reward; the newest entry is the one that it was felt in.

        Args:
            reward: the touch.
            history: entries, oldest first, the newest included.
            network: transition probabilities learned so far.

        Raises:
            ExperienceError: if the history is empty.
        """

    def weigh_silence(self, history: History) -> Weighing:
        """Share the absence of a reward: by default the newest pair's alone."""
        newest = len(history) - 1
        return Weighing({newest: 1.0}, newest)


@saved
@dataclass(frozen=True, kw_only=True)
class Immediate(CreditRule):
    """The reward goes to the newest pair (experiments 1 to 3 of the paper)."""

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """All of it to the entry that the touch was felt in."""
        newest = history.in_force(math.inf)
        return Weighing({newest: 1.0}, newest)


@saved
@dataclass(frozen=True, kw_only=True)
class Trace(CreditRule):
    """Watkins' Q(lambda): the newest pair's error goes back along a fading trace.

    The trace ends at the first behavior that was chosen against the values (values
    before it say nothing of what followed).

    Source: Watkins (1989); Sutton & Barto (1998), section 7.6.

    Attributes:
        decay: gamma * lambda, how much is left per entry back, in [0, 1). 0.09: the
            default gamma of 0.1 and the customary lambda of 0.9.
        replacing: whether a pair met again starts anew at 1 instead of adding up.
    """

    shares_error: ClassVar[bool] = True
    decay: float = 0.09
    replacing: bool = False

    def __post_init__(self) -> None:
        check_range("decay", self.decay, 0.0, 1.0)
        if not isinstance(self.replacing, bool):
            raise ParameterError(
                f"replacing is {shown(self.replacing)}, not true or false"
            )

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """The trace of every pair; the newest pair is the designated one."""
        newest = history.in_force(math.inf)
        return Weighing(self._traces(history), newest)

    def weigh_silence(self, history: History) -> Weighing:
        """The same: an error without reward goes back along the trace, too."""
        return Weighing(self._traces(history), len(history) - 1)

    def _traces(self, history: History) -> dict[int, float]:
        latest: dict[object, int] = {}
        weights: dict[int, float] = {}
        weight = 1.0
        for index in range(len(history) - 1, -1, -1):
            entry = history.entries[index]
            at = latest.setdefault((entry.state, entry.action), index)
            if at == index or not self.replacing:
                weights[at] = weights.get(at, 0.0) + weight
            weight *= self.decay
            if history.exploratory[index] or weight < LEAST_WEIGHT:
                break
        return weights


def reach(reward: float, sigma_stm: float, sigma_rwd: float, *, squared: bool) -> float:
    """How far the paper's eligibility discount reaches in time, one sigma of it [s].

        sigma_stm * exp(-1/2 * (1 - r) / sigma_rwd)

    Args:
        reward: r in [-1, 1]; the higher, the further it reaches.
        sigma_stm: reach of a full caress [s] ("short-term memory").
        sigma_rwd: how little a lower reward shortens the reach.
        squared: square (1 - r) / sigma_rwd, which the printed formula does not, though
            a Gaussian would.
    """
    lack = (1.0 - reward) / sigma_rwd
    return sigma_stm * math.exp(-0.5 * (lack * lack if squared else lack))


_BEYOND = 40.0  # sigmas, where exp(-800) is nothing for floating point


def eligibility(seconds: float, reach: float) -> float:
    """The paper's eligibility discount in time, without its transition probability.

        exp(-1/2 * (t / reach)^2)

    Args:
        seconds: t, time between the pair and the designated one [s].
        reach: see `reach` [s].

    Source: section 3.1 of the paper, as printed.
    """
    if seconds > _BEYOND * reach:  # Also where the reach is nothing.
        return 0.0
    return math.exp(-0.5 * (seconds / reach) ** 2) if seconds else 1.0


@saved
@dataclass(frozen=True, kw_only=True)
class Designated(CreditRule):
    """A heuristic names the pair; eligibility spreads from it both ways in time.

    Each other pair gets `eligibility` times P(s_n | s_p, a_p), how expected its
    situation was after the pair before it, learned at run time; the designated pair
    gets 1. Time between pairs is taken between the beginnings of their entries, as in
    Table 1. The oldest entry has no pair before it, so its P counts as 1 (our choice).

    Source: section 3.1 of the paper.

    Attributes:
        heuristic: names the pair.
        sigma_stm: reach of a full caress [s], > 0. 1.6 s with sigma_rwd = 1 gives a
            full tap a reach of 0.59 s, which Table 1 demands (inferred from it).
        sigma_rwd: how little a lower reward shortens the reach, > 0.
        squared: see `reach`; False is as printed.
    """

    heuristic: Heuristic = field(default_factory=BeforeApproach)
    sigma_stm: float = 1.6
    sigma_rwd: float = 1.0
    squared: bool = False

    def __post_init__(self) -> None:
        if not callable(self.heuristic):
            raise ParameterError(f"heuristic is {shown(self.heuristic)}, no function")
        if not isinstance(self.squared, bool):
            raise ParameterError(f"squared is {shown(self.squared)}, not true or false")
        check_positive("sigma_stm", self.sigma_stm)
        check_positive("sigma_rwd", self.sigma_rwd)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """1 to the designated pair, the eligibility function to its neighbors."""
        designated = self.heuristic(reward, history)
        sigma = reach(
            reward.value, self.sigma_stm, self.sigma_rwd, squared=self.squared
        )
        middle = history.entries[designated].time
        first = history.in_force(middle - _FURTHEST * sigma)
        last = history.in_force(middle + _FURTHEST * sigma)
        weights: dict[int, float] = {}
        for index in range(first, last + 1):
            seconds = abs(history.entries[index].time - middle)
            weight = eligibility(seconds, sigma) if index != designated else 1.0
            if index not in (0, designated) and weight >= LEAST_WEIGHT:
                entry, before = history.entries[index], history.entries[index - 1]
                weight *= network.probability(entry.state, before.state, before.action)
            if weight >= LEAST_WEIGHT:
                weights[index] = weight
        return Weighing(weights, designated)


_FURTHEST = 4.0  # sigmas away, eligibility is below LEAST_WEIGHT: exp(-8) is 0.0003
