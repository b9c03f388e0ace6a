"""Advice: a robot that is not sure what a touch was about asks "why?"."""

from collections.abc import Callable
from dataclasses import dataclass, field

from learners.credit.heuristics import AttentionShift, BeforeApproach, Heuristic
from learners.credit.history import History
from learners.errors import ExperienceError, ParameterError, check_range
from learners.experience import Experience, Reward
from learners.saving import ATTACHED, saved
from learners.sums import added

Ask = Callable[[Reward, tuple[Experience, ...]], int | None]
"""Puts the candidate entries before the giver, who points at one of them (its index
among the candidates) or at none (None: the robot keeps its own first guess)."""


@saved
@dataclass(kw_only=True)
class Advice:
    """Heuristics vote for a pair; where the vote is close, the giver decides.

    Source: sections 3.1 and 6 of the paper ("when in doubt, the system asks which
    actions were responsible for the reward"); how doubt is measured is our choice.

    Attributes:
        ask: puts the question; what an answer costs the giver is the caller's affair.
        heuristics: the voters and the weights of their votes.
        margin: ask if the two leading pairs' shares of the vote differ by at most
            this, in [0, 1].
        asked: how often it asked so far.
    """

    ask: Ask = field(metadata=ATTACHED)
    heuristics: tuple[tuple[Heuristic, float], ...] = (
        (BeforeApproach(), 1.0),
        (AttentionShift(), 1.0),
    )
    margin: float = 0.2
    asked: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        check_range("margin", self.margin, 0.0, 1.0)
        if not self.heuristics or any(not w > 0.0 for _, w in self.heuristics):
            raise ParameterError("Advice needs heuristics, each with a weight above 0")

    def __call__(self, reward: Reward, history: History) -> int:
        """Index of the entry with most votes, or of the one the giver points at."""
        first, *others = self._ranked(reward, history)
        if not others or first[1] - others[0][1] > self.margin:
            return first[0]
        # Whatever is about as likely as the leader stands for election.
        close = [i for i, share in others if first[1] - share <= self.margin]
        candidates = sorted([first[0], *close])
        self.asked += 1
        answer = self.ask(reward, tuple(history.entries[i] for i in candidates))
        if answer is None:
            return first[0]
        if not 0 <= answer < len(candidates):
            raise ExperienceError(
                f"the giver pointed at candidate {answer} of {len(candidates)}"
            )
        return candidates[answer]

    def _ranked(self, reward: Reward, history: History) -> list[tuple[int, float]]:
        votes: dict[int, float] = {}
        for heuristic, weight in self.heuristics:
            index = heuristic(reward, history)
            votes[index] = votes.get(index, 0.0) + weight
        total = added(votes.values())
        ranked = sorted(votes.items(), key=lambda vote: -vote[1])
        return [(index, weight / total) for index, weight in ranked]
