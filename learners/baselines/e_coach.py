"""E-COACH: COACH by episodes, with a discount and a trace that does not fade.

Shah, Halpern, Asadi & Littman (2021), "Convergence of a human-in-the-loop
policy-gradient algorithm with eligibility trace under reward, policy, and advantage
feedback": COACH can settle on the wrong policy; E-COACH counts the steps of the
episode, discounts feedback by gamma^t, and lets the whole episode share in it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from learners.baselines.coach import Coach, DelayedTrace
from learners.credit.rules import CreditRule
from learners.errors import check_range, check_whole
from learners.experience import Experience
from learners.saving import saved
from learners.tabular.cells import Cell


@saved
@dataclass(eq=False)
class ECoach(Coach):
    """COACH over episodes of a fixed number of entries (a home has no others).

    Attributes:
        credit: a trace that does not fade, over the entries of the episode.
        gamma: discount per entry since the episode began, in [0, 1]. 0.9: our choice.
        episode: entries in an episode, >= 1. 10: our choice, a minute or so.
        elapsed: entries of the current episode so far.
    """

    credit: CreditRule = field(
        default_factory=lambda: DelayedTrace(decay=1.0), kw_only=True
    )
    gamma: float = field(default=0.9, kw_only=True)
    episode: int = field(default=10, kw_only=True)
    elapsed: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_range("gamma", self.gamma, 0.0, 1.0)
        check_whole("episode", self.episode, 1, 10**9)

    def check_loaded(self) -> None:
        """Refuse a file with more entries than an episode has.

        Raises:
            LearnerError: if there are.
        """
        super().check_loaded()
        check_whole("elapsed", self.elapsed, 0, self.episode)

    def learn(self, experience: Experience) -> None:
        """Learn from one entry; a new episode begins when the last one is full.

        Raises:
            LearnerError: if the entry cannot be; what was learned is unchanged.
        """
        if self.elapsed == self.episode:
            self.start_episode()
        super().learn(experience)
        self.elapsed += 1

    def start_episode(self) -> None:
        """Forget the history and count the steps anew."""
        super().start_episode()
        self.elapsed = 0

    def _climb(
        self, cell: Cell, action: int, policy: Sequence[float], size: float
    ) -> None:
        super()._climb(cell, action, policy, size * self.gamma**self.elapsed)
