"""Claims as data: what is claimed, how it is measured, when it holds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import polars as pl

from experiments.analysis import deciding
from experiments.analysis.deciding import Region
from experiments.analysis.measures import StudyMeasure
from experiments.analysis.statistics import Estimate, FloatArray, proportion

FLOOR, CEILING = "random", "persona"
"""Conditions that every claim about behavior is read beside: a robot that does anything
at any time, and one that does what the people who are there prefer most."""

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

    least: float | None = None
    """The value below which a claim of "at most" does not hold, if any."""

    reference: Callable[[str], StudyMeasure] | None = None
    """Takes `FLOOR` or `CEILING`, returns the same measure of it; None where the
    claim is about what a learner believes, which these two have nothing to say of."""

    @property
    def condition(self) -> str:
        """The condition, or the contrast of conditions, that it is checked on."""
        return self.measure.label

    @property
    def wanted(self) -> Region:
        """Values at which it holds."""
        return deciding.region(self.rule, self.threshold, self.least)

    def check(self, frame: pl.DataFrame) -> Finding:
        """Returns what came out.

        Args:
            frame: The table of the study that the claim belongs to.
        """
        ask = self.reference
        return replace(
            self.judge(self.measure.values(frame)),
            floor=self._estimate(ask(FLOOR), frame) if ask else None,
            ceiling=self._estimate(ask(CEILING), frame) if ask else None,
            compared={
                measure.label: self._estimate(measure, frame)
                for measure in self.compared
            },
        )

    def judge(self, values: FloatArray) -> Finding:
        """Returns what came out, without anything beside it.

        Args:
            values: What was measured, one number per seed, shape (n_seeds,); seeds that
                have NaN are left out.
        """
        estimate = self.estimate(values[~np.isnan(values)])
        enough = self.least is None or estimate.value >= self.least
        holds = bool(enough and RULES[self.rule](estimate, self.threshold))
        return Finding(claim=self, estimate=estimate, holds=holds)

    def _estimate(self, measure: StudyMeasure, frame: pl.DataFrame) -> Estimate:
        return self.judge(measure.values(frame)).estimate


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

    floor: Estimate | None = None
    """The same of a random robot."""

    ceiling: Estimate | None = None
    """The same of the persona reference."""

    @property
    def verdict(self) -> str:
        """`holds`, `fails`, or `undecided` where the interval straddles a border."""
        covers_nothing = self.estimate.low <= 0.0 <= self.estimate.high
        if self.claim.rule == "no better than" and covers_nothing:
            return deciding.HOLDS
        return deciding.verdict(self.estimate, self.claim.wanted, holds=self.holds)

    @property
    def seeds_to_decide(self) -> int | None:
        """How many seeds would decide, about; None if it is decided, or never."""
        if self.verdict != deciding.UNDECIDED:
            return None
        return deciding.seeds_to_decide(self.estimate, self.claim.wanted)

    @property
    def standing(self) -> str | None:
        """`empty`, `unattainable`, or None; see `deciding.standing`."""
        known = [one.value for one in (self.floor, self.ceiling) if one is not None]
        return deciding.standing(self.claim.wanted, known)

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
            "least": claim.least,
            "holds": self.holds,
            "verdict": self.verdict,
            "seeds_to_decide": self.seeds_to_decide,
            "floor": _plain(self.floor),
            "ceiling": _plain(self.ceiling),
            "standing": self.standing,
            "unit": claim.unit,
            "n": estimate.n,
            "interval": estimate.method,
            "compared": {name: _plain(one) for name, one in self.compared.items()},
        }


def _plain(estimate: Estimate | None) -> dict[str, float] | None:
    if estimate is None:
        return None
    return {"value": estimate.value, "low": estimate.low, "high": estimate.high}


def overall(findings: Iterable[Finding]) -> dict[str, str]:
    """Returns the verdict on each claim's id, over all of its conditions."""
    found: dict[str, list[str]] = {}
    for finding in findings:
        found.setdefault(finding.claim.id, []).append(finding.verdict)
    return {id: deciding.worst(each) for id, each in found.items()}


def verdicts(findings: Iterable[Finding]) -> dict[str, bool]:
    """Returns for each claim's id whether it holds in all of its conditions."""
    result: dict[str, bool] = {}
    for finding in findings:
        result[finding.claim.id] = result.get(finding.claim.id, True) and finding.holds
    return result
