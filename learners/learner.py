"""What every learner can do, and how it says what it believes a touch was about."""

from collections.abc import Hashable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from learners.experience import Experience, Reward
from learners.saving import saved


@saved
@dataclass(frozen=True, kw_only=True, slots=True)
class Credit:
    """What a learner believes one touch, or the lack of any, to be about.

    Attributes:
        reward: the touch; None for an entry that passed in silence.
        shares: entries of the history with their eligibility, oldest first. 1 is a
            full share; shares are above 0 and need not sum to 1.
        designated: the entry that it is about above all; None if the credit rule
            found none.
    """

    reward: Reward | None
    shares: tuple[tuple[Experience, float], ...]
    designated: Experience | None


class Learner(Protocol):
    """Chooses behaviors and learns from touches; knows nothing of a household."""

    @property
    def n_behaviors(self) -> int:
        """Number of behaviors to choose from."""
        ...

    @property
    def credits(self) -> tuple[Credit, ...]:
        """What the last `learn` believed each of its touches to be about."""
        ...

    def act(self, state: Hashable) -> int:
        """Choose a behavior, an index in 0 .. n_behaviors - 1."""
        ...

    def learn(self, experience: Experience) -> None:
        """Learn from one entry of the history; entries come in order of time.

        Raises:
            LearnerError: if the entry cannot be; what was learned is unchanged.
        """
        ...

    def start_episode(self) -> None:
        """Forget the history but nothing learned: the clock starts anew."""
        ...

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """Value of every behavior in a state, shape (n_behaviors,); a copy."""
        ...

    def save(self, path: str | Path) -> None:
        """Write all it needs to go on exactly as it would have, atomically."""
        ...
