"""Verdicts: what an estimate, its interval and two references say of a claim."""

from __future__ import annotations

from collections.abc import Iterable
from math import ceil, inf, isfinite, isnan

from experiments.analysis.statistics import Estimate

HOLDS, FAILS, UNDECIDED = "holds", "fails", "undecided"

EMPTY, UNATTAINABLE = "empty", "unattainable"

Region = tuple[float, float]
"""Values at which a claim holds, both ends included."""


def region(rule: str, threshold: float, least: float | None = None) -> Region:
    """Returns the values at which a claim holds.

    Args:
        rule: A key of `claims.RULES`.
        threshold: What the rule compares with.
        least: The value below which a claim of "at most" does not hold, if any.
    """
    if rule in ("at least", "above"):
        return threshold, inf
    return -inf if least is None else least, threshold


def verdict(estimate: Estimate, wanted: Region, *, holds: bool) -> str:
    """Returns `holds`, `fails`, or `undecided` where the interval straddles a border.

    Args:
        estimate: What was measured; without an interval the value decides.
        wanted: Values at which the claim holds.
        holds: Whether the claim's rule is met.
    """
    # Within the region, and the rule is not met: "above" asks for the whole interval.
    within = wanted[0] < estimate.value <= wanted[1]
    if _straddled(estimate, wanted) or (within and not holds):
        return UNDECIDED
    return HOLDS if holds else FAILS


def seeds_to_decide(estimate: Estimate, wanted: Region) -> int | None:
    """Returns how many seeds would decide, if the value stays what it is.

    An interval becomes narrower with the square root of the number of seeds.

    Args:
        estimate: What was measured.
        wanted: Values at which the claim holds.

    Returns:
        None where the verdict is decided, or the value lies on the border, so that no
        number of seeds decides.
    """
    needed = []
    for border in _touched(estimate, wanted):
        gap = abs(estimate.value - border)
        if gap < 1e-9:
            return None
        end = estimate.low if estimate.value > border else estimate.high
        side = abs(estimate.value - end)
        needed.append(ceil(estimate.n * (side / gap) ** 2) + 1)
    return max(needed, default=None)


def standing(wanted: Region, references: Iterable[float]) -> str | None:
    """Returns whether a claim asks for what everybody can, or for what nobody can.

    Args:
        wanted: Values at which the claim holds.
        references: What a random robot and the persona reference reach.

    Returns:
        `empty` if the claim holds wherever between them one is, `unattainable` if it
        holds nowhere between them, None if it tells good from bad.
    """
    known = [value for value in references if not isnan(value)]
    if not known:
        return None
    low, high = min(known), max(known)
    if wanted[0] <= low and high <= wanted[1]:
        return EMPTY
    return UNATTAINABLE if high < wanted[0] or wanted[1] < low else None


def worst(verdicts: Iterable[str]) -> str:
    """Returns the verdict on all of some findings: one that fails decides."""
    return max(verdicts, key=(HOLDS, UNDECIDED, FAILS).index)


def _straddled(estimate: Estimate, wanted: Region) -> list[float]:
    """Borders that lie inside the interval."""
    borders = filter(isfinite, wanted)
    return [border for border in borders if estimate.low < border < estimate.high]


def _touched(estimate: Estimate, wanted: Region) -> list[float]:
    """Borders inside the interval or at its end, where that is not a point."""
    if not estimate.low < estimate.high:
        return []
    return [b for b in filter(isfinite, wanted) if estimate.low <= b <= estimate.high]
