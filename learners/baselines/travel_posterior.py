"""Credit by Bayes: which behavior would have made the giver set out when it did?

Our own baseline, in the spirit of the delay densities of Knox & Stone (2009): it adds
what a home shows, namely when the giver could perceive a behavior and how long the
way was, and how late and inexactly the robot notices that.
"""

import math
from dataclasses import dataclass

import numpy as np

from learners.credit.history import History
from learners.credit.rules import LEAST_WEIGHT, CreditRule, Weighing
from learners.credit.transitions import SituationNetwork
from learners.errors import check_positive, check_range
from learners.experience import Experience, Reward
from learners.saving import saved
from learners.sums import added


@saved
@dataclass(frozen=True, kw_only=True)
class TravelPosterior(CreditRule):
    """Posterior over past behaviors, given when the giver set out.

    The giver was noticed coming at `approach_began`, some time after it had set out;
    how long after is not known, and the likelihood is the mean over it (a giver that
    did not walk touched at once, and then that time is known). A behavior is perceived
    when it begins, or when the giver turns to the robot while it lasts, or by ear only.
    From then on, the time until setting out is log-normal; a behavior still going on
    may also be judged at any moment, so that an entry is as likely as the best moment
    in it. Weights are the posterior, summing to 1.

    Attributes:
        reaction: [s] median time from perceiving to setting out, > 0. 1 s: people
            take 1.01 s (CHARM, arXiv 2506.13079).
        spread: standard deviation of its logarithm, > 0. 0.62, from there too.
        late: [s] how late the robot notices that somebody sets out or turns to it on
            average, >= 0. 0.5: as our households have it.
        noise: [s] standard deviation of that, >= 0. 0.3, from there too.
        unseen: likelihood of judging by ear alone, against 1 for what was seen, in
            [0, 1]. 0.3: our choice.
    """

    reaction: float = 1.0
    spread: float = 0.62
    late: float = 0.5
    noise: float = 0.3
    unseen: float = 0.3

    def __post_init__(self) -> None:
        check_positive("reaction", self.reaction)
        check_positive("spread", self.spread)
        check_range("late", self.late, 0.0)
        check_range("noise", self.noise, 0.0)
        check_range("unseen", self.unseen, 0.0, 1.0)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """The posterior; the likeliest entry is the designated one."""
        moments = self._setting_out(reward)
        latest = history.in_force(max(moment for moment, _ in moments))
        likelihoods = {
            index: self._mean_likelihood(entry, moments, reward.attention_began)
            for index, entry in enumerate(history.entries[: latest + 1])
        }
        total = added(likelihoods.values())
        if total <= 0.0:  # all too long ago for floating point: the latest it is
            return Weighing({latest: 1.0}, latest)
        posterior = {i: x / total for i, x in likelihoods.items()}
        weights = {i: p for i, p in posterior.items() if p >= LEAST_WEIGHT}
        return Weighing(weights, max(weights, key=weights.__getitem__))

    def _setting_out(self, reward: Reward) -> list[tuple[float, float]]:
        """Moments at which the giver may have set out [s], and their weights."""
        if reward.approach_began is None:
            return [(reward.time, 1.0)]
        if self.noise == 0.0:
            return [(reward.approach_began - self.late, 1.0)]
        expected, latest = reward.approach_began - self.late, reward.time
        return [(min(expected - self.noise * x, latest), w) for x, w in _NORMAL]

    def _mean_likelihood(
        self,
        entry: Experience,
        moments: list[tuple[float, float]],
        noticed: float | None,
    ) -> float:
        """How likely an entry made the giver set out, whenever that was."""
        turned = None if noticed is None else noticed - self.late
        mode = self.reaction * math.exp(-(self.spread**2))  # the likeliest delay
        return added(
            weight * self._likelihood(entry, set_out, turned, mode)
            for set_out, weight in moments
            if entry.time < set_out
        )

    def _likelihood(
        self, entry: Experience, set_out: float, turned: float | None, mode: float
    ) -> float:
        seen = turned is not None and turned < min(entry.next_time, set_out)
        first = max(entry.time, turned) if seen and turned is not None else entry.time
        # The delay can be counted from any moment of the entry: take the likeliest.
        longest = set_out - first
        shortest = max(set_out - entry.next_time, 0.0)
        delay = min(max(mode, shortest), longest)
        return self._density(delay) * (1.0 if seen else self.unseen)

    def _density(self, delay: float) -> float:
        if delay <= _AT_ONCE:
            return 0.0
        z = math.log(delay / self.reaction) / self.spread
        return math.exp(-0.5 * z * z) / (delay * self.spread * _ROOT)


_AT_ONCE = 1e-300  # [s]; what is divided by less has no value in floating point
_ROOT = math.sqrt(2.0 * math.pi)


def _normal_nodes() -> tuple[tuple[float, float], ...]:
    """Standard normal numbers and weights whose mean is nearly that of all of them.

    Gauss-Hermite quadrature, exact for polynomials up to degree 13.
    """
    nodes, weights = np.polynomial.hermite_e.hermegauss(7)
    shares = weights / weights.sum()
    return tuple(zip(nodes.tolist(), shares.tolist(), strict=True))


_NORMAL = _normal_nodes()
