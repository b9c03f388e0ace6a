"""The paper's findings as contrasts: one factor of the factorial, two of its levels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import polars as pl

from experiments.analysis.claims import Claim
from experiments.analysis.measures import StudyMeasure
from experiments.analysis.statistics import FloatArray, mean
from experiments.studies.factorial import conditions, level_means


@dataclass(frozen=True, kw_only=True)
class Contrast:
    """A directional statement: two levels of one factor, on one scenario."""

    number: int
    """Of the experiment whose scenario it is."""

    text: str
    """What is claimed."""

    factor: str
    """One of `FACTORS`."""

    more: str
    """Level that the claim is about."""

    less: str
    """Level that it is compared with."""

    fixed: Mapping[str, str]
    """The paper's levels of the other factors."""

    rule: str = "above"
    """A key of `claims.RULES`."""

    threshold: float = 0.0
    """What the rule compares with."""

    def claims(self) -> tuple[Claim, Claim]:
        """Returns the statement at the paper's levels, and averaged over all others."""
        return self._claim("paper's levels", self.fixed), self._claim("all levels", {})

    def _claim(self, where: str, fixed: Mapping[str, str]) -> Claim:
        return Claim(
            id=f"F{self.number}",
            text=self.text,
            reading="Appropriate choices, paired by seed.",
            measure=StudyMeasure(
                label=f"{self.more} - {self.less}, {where}",
                conditions=self._compared(fixed),
                values=partial(self._difference, fixed=fixed),
            ),
            rule=self.rule,
            threshold=self.threshold,
            estimate=mean,
            unit="share of choices",
        )

    def _compared(self, fixed: Mapping[str, str]) -> tuple[str, ...]:
        """Names of the conditions at the fixed levels and at one of the two."""
        return tuple(
            condition.name
            for condition in conditions(self.number)
            if fixed.items() <= condition.factors.items()
            and condition.factors[self.factor] in (self.more, self.less)
        )

    def _difference(self, frame: pl.DataFrame, fixed: Mapping[str, str]) -> FloatArray:
        one = level_means(frame, "right", {**fixed, self.factor: self.more})
        return one - level_means(frame, "right", {**fixed, self.factor: self.less})


_PLAIN = {"credit": "immediate", "analogy": "none"}

FINDINGS = (
    Contrast(
        number=1,
        text="Standard Q-learning suffers from silence.",
        factor="rate",
        more="skip_silence",
        less="asynchronous",
        fixed=_PLAIN,
    ),
    Contrast(
        number=2,
        text="The social rate is better than the asynchronous one.",
        factor="rate",
        more="social",
        less="asynchronous",
        fixed=_PLAIN,
    ),
    Contrast(
        number=3,
        text="A classic trace is no answer to delayed touches.",
        factor="credit",
        more="trace",
        less="immediate",
        fixed={"rate": "social", "analogy": "none"},
        rule="no better than",
        threshold=0.1,
    ),
    Contrast(
        number=4,
        text="Designated credit is.",
        factor="credit",
        more="designated",
        less="immediate",
        fixed={"rate": "social", "analogy": "none"},
    ),
    Contrast(
        number=5,
        text="Swapping roles carries over to the other person.",
        factor="analogy",
        more="swap",
        less="none",
        fixed={"rate": "social", "credit": "designated"},
    ),
)
"""The paper's five findings, each as one factor's effect on appropriate choices."""

_DESIGNATED = {"credit": "designated", "analogy": "none"}

_LEVELS: Mapping[int, Mapping[str, str]] = {
    **dict.fromkeys((1, 2, 3), _PLAIN),
    4: _DESIGNATED,
    5: {"credit": "designated", "analogy": "swap"},
}
"""The paper's credit and analogy in each experiment."""


def against_silence(number: int) -> Contrast:
    """Returns whether the social rate beats not learning from silence at all."""
    return Contrast(
        number=number,
        text="The social rate is better than learning from touches alone.",
        factor="rate",
        more="social",
        less="skip_silence",
        fixed=_LEVELS[number],
    )
