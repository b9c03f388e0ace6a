"""Adaptive pooling: as far as people turned out to agree."""

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import ClassVar

from learners.pooling.agreement import Agreement
from learners.pooling.partial import borrowed
from learners.pooling.rules import Pooling
from learners.saving import saved


@saved
@dataclass(kw_only=True, eq=False)
class AdaptivePooling(Agreement, Pooling):
    """Drawn to the population by the trust in a person, less the more is known of it.

    Trust is the slope of what a person does on what others did in the same part.

    Attributes:
        prior_weight: 0.05: our choice; rates of touches are a tenth or so, and some ten
            comparisons are to overrule the prior.
        noise: 20: our choice, for rates of touches: most moments pass in silence,
            whatever a person's taste.
        revision: how often trust has changed.
    """

    learns: ClassVar[bool] = True
    prior_weight: float = 0.05
    noise: float = 20.0
    revision: int = field(default=0, init=False)

    def terms(self, n: float, person: Hashable) -> tuple[float, float]:
        """By trust, wholly for those who always agree; all weigh by observations."""
        return borrowed(n, self.trust_in(person), self.noise), n

    def compare(
        self, person: Hashable, value: float, prediction: float, weight: float
    ) -> None:
        """Compare what a person did with what was to be expected of others.

        Args:
            person: by name.
            value: the touch by its eligibility, or 0 for silence.
            prediction: mean of the others.
            weight: what the comparison counts, >= 0.
        """
        self._compare(person, value, prediction, weight)
        self.revision += 1
