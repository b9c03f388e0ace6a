"""Seeking company: what to do where nobody is there to learn from."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from learners.errors import SavedFileError, check_part
from learners.exploration.rules import Estimates, Exploration, Softmax
from learners.saving import saved

MOST = 10**15
"""More than this are not counted in floating point."""


@saved
@dataclass(kw_only=True, eq=False)
class SeekCompany:
    """Among people another rule; alone, what brings the robot among people.

    Nobody touches a robot that nobody perceives, and nobody minds what it does. So it
    is noted how often somebody perceived it after each behavior, and one is chosen by
    Thompson sampling with a uniform prior (Thompson 1933; Chapelle & Li 2011, "An
    empirical evaluation of Thompson sampling"). Whether it is alone a robot can tell
    itself, from who attends to it and who would hear it.

    Attributes:
        among: the rule among people.
        found: behavior -> how often somebody perceived the robot next.
        missed: behavior -> how often still nobody did.
    """

    among: Exploration = field(default_factory=Softmax)
    found: dict[int, int] = field(init=False, repr=False, default_factory=dict)
    missed: dict[int, int] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        check_part("the rule among people", self.among, "choose", "needs_posterior")

    def check_loaded(self) -> None:
        """Refuse counts that cannot be.

        Raises:
            SavedFileError: if one is negative, or more than anybody lives through.
        """
        counts = (*self.found.values(), *self.missed.values())
        if not all(0 <= count <= MOST for count in counts):
            raise SavedFileError("a count of company is negative or far too large")

    @property
    def needs_visits(self) -> bool:
        """As the rule among people."""
        return self.among.needs_visits

    @property
    def needs_posterior(self) -> bool:
        """As the rule among people."""
        return self.among.needs_posterior

    def note(self, action: int, *, found: bool) -> None:
        """Note whether somebody perceived the robot after what it did alone."""
        counts = self.found if found else self.missed
        counts[int(action)] = counts.get(int(action), 0) + 1

    def choose(self, estimates: Estimates, rng: np.random.Generator) -> int:
        """The rule's choice among people; alone, the best of one draw for each."""
        if not estimates.alone:
            return self.among.choose(estimates, rng)
        hits, misses = self.posterior(len(estimates.values))
        return int(rng.beta(hits, misses).argmax())

    def posterior(
        self, n_behaviors: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Parameters of each behavior's beta distribution, of shape (n_behaviors,)."""
        return _counted(self.found, n_behaviors), _counted(self.missed, n_behaviors)


def _counted(counts: Mapping[int, int], n_behaviors: int) -> NDArray[np.float64]:
    """One more of each than was counted."""
    return np.array([1.0 + counts.get(each, 0) for each in range(n_behaviors)])
