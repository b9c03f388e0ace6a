"""How numbers are said, the same in the terminal and in the report."""

from __future__ import annotations

from fractions import Fraction
from math import isnan

from experiments.analysis.claims import Finding
from experiments.analysis.statistics import Estimate

VERDICTS = {True: "✓ holds", False: "✗ fails"}
"""Told by sign and word, never by color alone."""


def number(value: float, *, is_share: bool) -> str:
    """Returns a number as people read it: `83 %`, `0.42`, `-7.1`."""
    if isnan(value):
        return "unknown"
    if is_share:
        return f"{_plain(100 * value, 0)} %"
    return _plain(value, 2 if abs(value) < 10 else 1)


def _plain(value: float, digits: int) -> str:
    # Adding 0.0 turns a rounded -0.0 into 0.0.
    rounded = round(value, digits) + 0.0
    return f"{rounded:.{digits}f}".replace("-", "\N{MINUS SIGN}")


def interval(estimate: Estimate, *, is_share: bool) -> str:
    """Returns the interval, or why there is none."""
    if isnan(estimate.low):
        return estimate.method
    low = number(estimate.low, is_share=is_share).removesuffix(" %")
    return f"{low} to {number(estimate.high, is_share=is_share)}"


def is_share(finding: Finding) -> bool:
    """Returns whether a finding is a share of something."""
    return finding.claim.unit.startswith("share")


def value(finding: Finding) -> str:
    """Returns what was measured."""
    return number(finding.estimate.value, is_share=is_share(finding))


def spread(finding: Finding) -> str:
    """Returns the interval of what was measured."""
    return interval(finding.estimate, is_share=is_share(finding))


def threshold(finding: Finding) -> str:
    """Returns rule and threshold: `at least 90 %`."""
    claim = finding.claim
    thirds = Fraction(claim.threshold).limit_denominator(3)
    if thirds.denominator == 3 and abs(float(thirds) - claim.threshold) < 1e-9:
        return f"{claim.rule} {thirds}"
    return f"{claim.rule} {number(claim.threshold, is_share=is_share(finding))}"
