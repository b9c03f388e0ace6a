"""Credit by Bayes: which behavior would have made the giver set out when it did?

Our own baseline, in the spirit of the delay densities of Knox & Stone (2009): it adds
what a home shows, namely when the giver could perceive a behavior and how long the
way was.
"""

import math
from dataclasses import dataclass

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

    The giver set out at `approach_began` (it touched at once if it did not walk). A
    behavior is perceived when it begins, or when the giver turns to the robot while it
    lasts, or by ear only. From then on, the time until setting out is log-normal; a
    behavior still going on may also be judged at any moment, so that an entry is as
    likely as the best moment in it. Weights are the posterior, summing to 1.

    Attributes:
        reaction: [s] median time from perceiving to setting out, > 0. 1 s: our choice.
        spread: standard deviation of its logarithm, > 0. 0.8: our choice (16 % take
            more than 2.2 s).
        unseen: likelihood of judging by ear alone, against 1 for what was seen, in
            [0, 1]. 0.3: our choice.
    """

    reaction: float = 1.0
    spread: float = 0.8
    unseen: float = 0.3

    def __post_init__(self) -> None:
        check_positive("reaction", self.reaction)
        check_positive("spread", self.spread)
        check_range("unseen", self.unseen, 0.0, 1.0)

    def weigh(
        self, reward: Reward, history: History, network: SituationNetwork
    ) -> Weighing:
        """The posterior; the likeliest entry is the designated one."""
        set_out = reward.approach_began
        set_out = reward.time if set_out is None else set_out
        latest = history.in_force(set_out)
        mode = self.reaction * math.exp(-(self.spread**2))  # the likeliest delay
        likelihoods = {
            index: self._likelihood(entry, set_out, reward.attention_began, mode)
            for index, entry in enumerate(history.entries[: latest + 1])
        }
        total = added(likelihoods.values())
        if total <= 0.0:  # all too long ago for floating point: the latest it is
            return Weighing({latest: 1.0}, latest)
        posterior = {i: x / total for i, x in likelihoods.items()}
        weights = {i: p for i, p in posterior.items() if p >= LEAST_WEIGHT}
        return Weighing(weights, max(weights, key=weights.__getitem__))

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
