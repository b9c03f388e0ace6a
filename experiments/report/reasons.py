"""Why a claim does not hold, in two sentences that only the numbers make."""

from __future__ import annotations

from math import inf, isnan

from experiments.analysis.claims import Finding
from experiments.analysis.deciding import FAILS, HOLDS, UNATTAINABLE
from experiments.report.format import finding_interval, finding_value, format_number


def reasons(finding: Finding) -> tuple[str, ...]:
    """Returns why it fails or is undecided; nothing where it holds."""
    if finding.verdict == HOLDS:
        return ()
    if finding.verdict == FAILS:
        return _distance(finding), _standing(finding)
    return _straddling(finding), _deciding(finding)


def _distance(finding: Finding) -> str:
    """How far the value is from where the claim holds."""
    value, claim = finding.estimate.value, finding.claim
    if isnan(value):
        return "Nothing could be measured: no seed met the situation often enough."
    low, high = claim.wanted
    border, side = (low, "below") if value < low else (high, "above")
    gap = abs(value - border)
    far = f"{100 * gap:.0f} percentage points" if claim.is_share else f"{gap:.2f}"
    seeds = f"{finding.estimate.n} seed{'s' if finding.estimate.n != 1 else ''}"
    if isnan(finding.estimate.low):
        return f"The value, {finding_value(finding)}, lies {far} {side} the threshold."
    return (
        f"The value, {finding_value(finding)}, lies {far} {side} the threshold, and so "
        f"does the whole interval of {seeds}, {finding_interval(finding)}: chance does "
        "not explain it."
    )


def _standing(finding: Finding) -> str:
    """What the two references, or other conditions, have to say of it."""
    floor, ceiling = finding.floor, finding.ceiling
    if floor is not None and ceiling is not None:
        low, high = _number(finding, floor.value), _number(finding, ceiling.value)
        ends = f"a random robot ({low}) and the persona reference ({high})"
        if finding.standing == UNATTAINABLE:
            return (
                f"Nothing between {ends} meets the claim, so that no learner that does "
                "better than chance and worse than that reference could."
            )
        span = ceiling.value - floor.value
        way = (finding.estimate.value - floor.value) / span if span else inf
        if 0.0 <= way <= 1.0:
            near = "learned much of" if way >= 0.5 else "learned little of"
            return (
                f"On the way between {ends} it has come {100 * way:.0f} %: here the "
                f"robot {near} what the people want."
            )
    return _others(finding)


def _others(finding: Finding) -> str:
    """Which of the conditions beside it meet the claim."""
    low, high = finding.claim.wanted
    if not finding.compared:
        return "No other condition was measured beside it."
    meets = [
        f"{name} ({_number(finding, one.value)})"
        for name, one in finding.compared.items()
        if low <= one.value <= high
    ]
    if not meets:
        return f"None of the {len(finding.compared)} conditions beside it meets it."
    return f"Of the conditions beside it, this meets it: {', '.join(meets)}."


def _straddling(finding: Finding) -> str:
    low, high = finding.claim.wanted
    inside = low <= finding.estimate.value <= high
    return (
        f"The value, {finding_value(finding)}, is {'within' if inside else 'outside'} "
        f"what the claim allows, but the interval of {finding.estimate.n} seeds, "
        f"{finding_interval(finding)}, reaches across the threshold."
    )


def _deciding(finding: Finding) -> str:
    needed = finding.seeds_to_decide
    if needed is None:
        return "The value lies on the border: no number of seeds decides."
    return f"About {needed:,} seeds would decide, if the value stays."


def _number(finding: Finding, value: float) -> str:
    return format_number(value, is_share=finding.claim.is_share)
