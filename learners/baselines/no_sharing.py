"""No sharing: each person's opinion is learned from that person alone.

No pooling, in the terms of Gelman & Hill (2007), chapter 12.
"""

from collections.abc import Hashable
from dataclasses import dataclass

from learners.baselines.personwise import Personwise
from learners.saving import saved


@saved
@dataclass(eq=False)
class NoSharing(Personwise):
    """A person's expected touch is the mean of its own."""

    def opinion(
        self, person: Hashable, place: Hashable, behavior: int
    ) -> tuple[float, float]:
        """The mean of this person's touches, 0 without any."""
        told = self.opinions.get((place, behavior), {})
        return told.get(person, (0.0, 0.0))[1], 0.0
