"""How numbers are written, the same in the terminal and in the report."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import isnan

from experiments.analysis.claims import Finding, overall
from experiments.analysis.deciding import EMPTY, FAILS, HOLDS, UNATTAINABLE, UNDECIDED
from experiments.analysis.statistics import Estimate

VERDICTS = {HOLDS: "✓ holds", FAILS: "✗ fails", UNDECIDED: "? undecided"}
"""Told by sign and word, never by color alone."""


def tally(findings: Iterable[Finding]) -> str:
    """Returns how many claims hold: `11 of 17 claims hold, 2 undecided`."""
    found = list(overall(findings).values())
    undecided = found.count(UNDECIDED)
    more = f", {undecided} undecided" if undecided else ""
    return f"{found.count(HOLDS)} of {len(found)} claims hold{more}"


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


def format_verdict(verdict: str) -> str:
    """Returns whether a claim holds, as a sign and a word."""
    return VERDICTS[verdict]


def finding_references(finding: Finding) -> str:
    """Returns what a random robot and the persona reference reach: `12 to 62 %`."""
    if finding.floor is None or finding.ceiling is None:
        return "none"
    is_share = finding.claim.is_share
    low = _digits(finding.floor.value, is_share=is_share)
    return f"{low}, {format_number(finding.ceiling.value, is_share=is_share)}"


def finding_remarks(finding: Finding) -> tuple[str, ...]:
    """Returns what must be known beside the verdict, in sentences."""
    remarks = []
    if finding.verdict == UNDECIDED:
        needed = finding.seeds_to_decide
        remarks.append(
            "The value lies on the border: no number of seeds decides."
            if needed is None
            else f"About {needed:,} seeds would decide, if the value stays."
        )
    if finding.standing is not None:
        remarks.append(_STANDINGS[finding.standing])
    return tuple(remarks)


_STANDINGS = {
    EMPTY: "Empty: a random robot and the persona reference meet it, too.",
    UNATTAINABLE: "Unattainable: nothing between a random robot and the persona "
    "reference meets it.",
}


def finding_value(finding: Finding) -> str:
    """Returns what was measured."""
    return format_number(finding.estimate.value, is_share=finding.claim.is_share)


def finding_interval(finding: Finding) -> str:
    """Returns the interval of what was measured."""
    return format_interval(finding.estimate, is_share=finding.claim.is_share)


def finding_threshold(finding: Finding) -> str:
    """Returns rule and threshold: `at least 90 %`."""
    claim = finding.claim
    if claim.least is not None:
        low = _digits(claim.least, is_share=claim.is_share)
        return f"{low} to {format_number(claim.threshold, is_share=claim.is_share)}"
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
