"""How numbers are written, the same in the terminal and in the report."""

from __future__ import annotations

from fractions import Fraction
from math import isnan

from experiments.analysis.claims import Finding
from experiments.analysis.statistics import Estimate

VERDICTS = {True: "✓ holds", False: "✗ fails"}
"""Told by sign and word, never by color alone."""


def format_number(value: float, *, is_share: bool) -> str:
    """Returns a number as people read it: `83 %`, `0.42`, `-7.1`."""
    text = _digits(value, is_share=is_share)
    return f"{text} %" if is_share and not isnan(value) else text


def format_interval(estimate: Estimate, *, is_share: bool) -> str:
    """Returns the interval, or why there is none."""
    if isnan(estimate.low):
        return estimate.method
    low = _digits(estimate.low, is_share=is_share)
    return f"{low} to {format_number(estimate.high, is_share=is_share)}"


def format_verdict(holds: bool) -> str:
    """Returns whether a claim holds, as a sign and a word."""
    return VERDICTS[holds]


def finding_value(finding: Finding) -> str:
    """Returns what was measured."""
    return format_number(finding.estimate.value, is_share=finding.claim.is_share)


def finding_interval(finding: Finding) -> str:
    """Returns the interval of what was measured."""
    return format_interval(finding.estimate, is_share=finding.claim.is_share)


def finding_threshold(finding: Finding) -> str:
    """Returns rule and threshold: `at least 90 %`."""
    claim = finding.claim
    thirds = Fraction(claim.threshold).limit_denominator(3)
    if thirds.denominator == 3 and abs(float(thirds) - claim.threshold) < 1e-9:
        return f"{claim.rule} {thirds}"
    return f"{claim.rule} {format_number(claim.threshold, is_share=claim.is_share)}"


def _digits(value: float, *, is_share: bool) -> str:
    """Returns a number without its unit."""
    if isnan(value):
        return "unknown"
    scaled = 100 * value if is_share else value
    digits = 0 if is_share else 2 if abs(value) < 10 else 1
    # Adding 0.0 turns a rounded -0.0 into 0.0.
    rounded = round(scaled, digits) + 0.0
    return f"{rounded:.{digits}f}".replace("-", "\N{MINUS SIGN}")
