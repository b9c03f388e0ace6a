"""The situation network: which situation follows which, counted at run time."""

from collections.abc import Hashable
from dataclasses import dataclass, field

from learners.errors import check_whole
from learners.saving import saved


@saved
@dataclass(kw_only=True, eq=False)
class SituationNetwork:
    """Transition counts, and the probabilities P(s' | s, a) they give.

    Source: sections 2.2 and 3.1 of the paper ("transition probabilities from
    state-action pair to states are learned at run-time").
    """

    counts: dict[tuple[Hashable, int], dict[Hashable, int]] = field(
        default_factory=dict, init=False, repr=False
    )

    def check_loaded(self) -> None:
        """Refuse transitions that were counted and never happened.

        Raises:
            LearnerError: if a count is below 1.
        """
        for followers in self.counts.values():
            for count in followers.values():
                check_whole("the count of a transition", count, 1, 2**63)

    def count(self, state: Hashable, action: int, next_state: Hashable) -> None:
        """Count one transition."""
        followers = self.counts.setdefault((state, action), {})
        followers[next_state] = followers.get(next_state, 0) + 1

    def probability(self, next_state: Hashable, state: Hashable, action: int) -> float:
        """P(next_state | state, action), the share of the counts; 0 if never seen."""
        followers = self.counts.get((state, action))
        if not followers:
            return 0.0
        return followers.get(next_state, 0) / sum(followers.values())
