"""Claims as data: what is said, how it is measured, when it holds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import polars as pl

from experiments.statistics import Estimate, FloatArray, proportion

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

    condition: str
    """The condition, or the contrast of conditions, that it is checked on."""

    measure: Callable[[pl.DataFrame], FloatArray]
    """Takes the study's table, returns one number per seed."""

    rule: str
    """A key of `RULES`."""

    threshold: float
    """What the rule compares with."""

    estimate: Callable[[FloatArray], Estimate] = proportion
    """Takes one number per seed, returns the value with its interval."""

    unit: str = "share of seeds"
    """Of the value and the threshold."""

    def check(self, frame: pl.DataFrame) -> Finding:
        """Returns what came out.

        Args:
            frame: The table of the study that the claim belongs to.
        """
        estimate = self.estimate(self.measure(frame))
        holds = bool(RULES[self.rule](estimate, self.threshold))
        return Finding(claim=self, estimate=estimate, holds=holds)


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A claim and what came out."""

    claim: Claim
    """What was claimed."""

    estimate: Estimate
    """What was measured."""

    holds: bool
    """Whether the claim's rule is met."""

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
        }


def verdicts(findings: Iterable[Finding]) -> dict[str, bool]:
    """Returns for each claim's id whether it holds in all of its conditions."""
    result: dict[str, bool] = {}
    for finding in findings:
        result[finding.claim.id] = result.get(finding.claim.id, True) and finding.holds
    return result
