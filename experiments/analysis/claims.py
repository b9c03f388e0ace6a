"""Claims as data: what is claimed, how it is measured, when it holds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import polars as pl

from experiments.analysis.measures import StudyMeasure
from experiments.analysis.statistics import Estimate, FloatArray, proportion

RULES: Mapping[str, Callable[[Estimate, float], bool]] = {
    "at least": lambda found, threshold: found.value >= threshold,
    "at most": lambda found, threshold: found.value <= threshold,
    "above": lambda found, threshold: found.low > threshold,
    "no better than": lambda found, threshold: (
        found.low <= 0.0 <= found.high or found.value < threshold
    ),
}
"""When a claim holds. The point value decides, except for "above" (the whole interval
lies above the threshold) and "no better than" (the interval covers 0, or the value is
below the threshold)."""


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One statement of the paper, made checkable before anything was run."""

    id: str
    """Number of the experiment and a letter, as in `1a`."""

    text: str
    """The statement, in one sentence."""

    reading: str
    """What exactly is measured; where the paper leaves it open, our reading."""

    measure: StudyMeasure
    """What is measured, and on which conditions; seeds that give NaN are left out."""

    rule: str
    """A key of `RULES`."""

    threshold: float
    """What the rule compares with."""

    estimate: Callable[[FloatArray], Estimate] = proportion
    """Takes one number per seed, returns the value with its interval."""

    unit: str = "share of seeds"
    """Of the value and the threshold."""

    is_share: bool = True
    """Whether to show both in percent."""

    compared: tuple[StudyMeasure, ...] = ()
    """The same measured on other conditions, without a verdict."""

    @property
    def condition(self) -> str:
        """The condition, or the contrast of conditions, that it is checked on."""
        return self.measure.label

    def check(self, frame: pl.DataFrame) -> Finding:
        """Returns what came out.

        Args:
            frame: The table of the study that the claim belongs to.
        """
        estimate = self._estimate(self.measure, frame)
        return Finding(
            claim=self,
            estimate=estimate,
            holds=bool(RULES[self.rule](estimate, self.threshold)),
            compared={
                measure.label: self._estimate(measure, frame)
                for measure in self.compared
            },
        )

    def _estimate(self, measure: StudyMeasure, frame: pl.DataFrame) -> Estimate:
        values = measure.values(frame)
        return self.estimate(values[~np.isnan(values)])


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A claim and what came out."""

    claim: Claim
    """What was claimed."""

    estimate: Estimate
    """What was measured."""

    holds: bool
    """Whether the claim's rule is met."""

    compared: Mapping[str, Estimate] = field(default_factory=dict)
    """What was measured on other conditions, by their labels."""

    def plain(self) -> dict[str, Any]:
        """Returns the finding as it is written to `claims.json`."""
        claim, estimate = self.claim, self.estimate
        return {
            "id": claim.id,
            "condition": claim.condition,
            "text": claim.text,
            "reading": claim.reading,
            "value": estimate.value,
            "low": estimate.low,
            "high": estimate.high,
            "rule": claim.rule,
            "threshold": claim.threshold,
            "holds": self.holds,
            "unit": claim.unit,
            "n": estimate.n,
            "interval": estimate.method,
            "compared": {
                name: {"value": other.value, "low": other.low, "high": other.high}
                for name, other in self.compared.items()
            },
        }


def verdicts(findings: Iterable[Finding]) -> dict[str, bool]:
    """Returns for each claim's id whether it holds in all of its conditions."""
    result: dict[str, bool] = {}
    for finding in findings:
        result[finding.claim.id] = result.get(finding.claim.id, True) and finding.holds
    return result
