"""Q-learning that skips steps without feedback: silence says nothing.

Loftin, Peng, MacGlashan, Littman, Taylor, Huang & Roberts (2016), "Learning behaviors
via human-delivered discrete feedback: modeling implicit feedback strategies to speed up
learning", JAAMAS 30, discuss learners that take no feedback for no information; here
the paper's own Q-learning is one. The one to beat: it cannot forget what people no
longer reward, which is what the paper's social rate is for.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from learners.learner import Credit
from learners.qlearner import QLearner
from learners.saving import saved
from learners.tabular.rates import AsynchronousRate, Rate


@saved
@dataclass(eq=False)
class SkipSilence(QLearner):
    """Q-learning on touches alone.

    Attributes:
        rate: asynchronous by default; with silence skipped, no social rate is needed.
    """

    rate: Rate = field(default_factory=AsynchronousRate, kw_only=True)

    def _absorb(self, credits: Sequence[Credit]) -> None:
        super()._absorb([each for each in credits if each.reward is not None])
