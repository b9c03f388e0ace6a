"""Sign-asymmetric Q-learning: caress, tap and silence count differently.

Thomaz & Breazeal (2006), "Reinforcement learning with human teachers: evidence of
feedback and guidance with implications for learning performance", AAAI: people mean
different things by reward and by punishment. Here the sign of the touch, unlike the
sign of the error in hysteretic Q-learning, sets a factor on the rate.
"""

from dataclasses import dataclass, field

from learners.errors import check_range
from learners.experience import Reward
from learners.learner import Credit
from learners.qlearner import QLearner, Update
from learners.saving import saved
from learners.tabular.rates import AsynchronousRate, Rate


@saved
@dataclass(eq=False)
class SignAsymmetric(QLearner):
    """Q-learning with a factor on the eligibility by the sign of the touch.

    What counts less also counts as less of a visit.

    Attributes:
        rate: asynchronous by default.
        caress: factor for a positive touch, in [0, 1]. 0.5: our choice; a caress is
            often meant for the company rather than the behavior.
        tap: factor for a negative touch, in [0, 1].
        silence: factor for no touch, in [0, 1]. 0.1: our choice.
    """

    rate: Rate = field(default_factory=AsynchronousRate, kw_only=True)
    caress: float = field(default=0.5, kw_only=True)
    tap: float = field(default=1.0, kw_only=True)
    silence: float = field(default=0.1, kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("caress", "tap", "silence"):
            check_range(name, getattr(self, name), 0.0, 1.0)

    def _updates_of(self, credit: Credit) -> list[Update]:
        factor = self._factor(credit.reward)
        updates = super()._updates_of(credit)
        return [each._replace(weight=each.weight * factor) for each in updates]

    def _factor(self, reward: Reward | None) -> float:
        if reward is None:
            return self.silence
        return self.caress if reward.value >= 0.0 else self.tap
