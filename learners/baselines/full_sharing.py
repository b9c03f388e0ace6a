"""Full sharing: one opinion for all, learned from everybody.

Complete pooling, in the terms of Gelman & Hill (2007), chapter 12.
"""

from collections.abc import Hashable
from dataclasses import dataclass

from learners.baselines.personwise import Personwise
from learners.saving import saved


@saved
@dataclass(eq=False)
class FullSharing(Personwise):
    """A person's expected touch is the mean of everybody's in the same place."""

    def opinion(
        self, person: Hashable, place: Hashable, behavior: int
    ) -> tuple[float, float]:
        """The mean of all touches given in this place, 0 without any."""
        told = self.opinions.get((place, behavior), {}).values()
        touches = sum(n for n, _ in told)
        if touches == 0.0:
            return 0.0, 0.0
        return sum(n * mean for n, mean in told) / touches, 0.0
