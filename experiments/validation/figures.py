"""Published figures, what the simulation gives in their place, and plain verdicts."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, TypedDict

from experiments.analysis.statistics import Estimate

Verdict = Literal["as published", "off", "undecided", "not modeled"]

TOLERANCE = 0.25
"""How far a simulated figure may be from a published one whose spread is not known, as
a share of it (our choice)."""


@dataclass(frozen=True, kw_only=True)
class Published:
    """A figure of real people, or what a guideline demands of simulated ones."""

    name: str
    """What was measured."""

    unit: str
    """Of the figure and of what is simulated."""

    said: str
    """The figure as it was published."""

    low: float = -math.inf
    """From here on a simulated figure counts as the published one."""

    high: float = math.inf
    """Up to here."""

    source: str
    """Who measured it."""

    reading: str
    """How it is measured here, and why these bounds."""

    because: str = ""
    """What the simulation does that puts it off, where that is known."""


class Bounds(TypedDict):
    """What `Published` takes as bounds."""

    low: float
    high: float


def around(value: float) -> Bounds:
    """Returns bounds for a figure that was published without its spread."""
    return {"low": value * (1.0 - TOLERANCE), "high": value * (1.0 + TOLERANCE)}


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A published figure beside the simulated one."""

    published: Published
    """What is known of people."""

    where: str
    """In which scene it was simulated; empty if it is not modeled."""

    simulated: Estimate | None
    """What was simulated; None if it is not modeled."""

    verdict: Verdict
    """How the two agree."""


def finding(published: Published, where: str, simulated: Estimate) -> Finding:
    """Returns a figure with its verdict.

    Args:
        published: What is known of people.
        where: The scene.
        simulated: What came out there.
    """
    return Finding(
        published=published,
        where=where,
        simulated=simulated,
        verdict=verdict(published, simulated),
    )


def not_modeled(published: Published) -> Finding:
    """Returns a figure that nothing here answers to."""
    return Finding(published=published, where="", simulated=None, verdict="not modeled")


def verdict(published: Published, simulated: Estimate) -> Verdict:
    """Says plainly whether a simulated figure is as published.

    Args:
        published: With the bounds within which it is.
        simulated: With its interval; without one the value alone decides.

    Returns:
        Undecided where the interval lies on both sides of a bound, or nothing was seen.
    """
    if math.isnan(simulated.value):
        return "undecided"
    no_interval = math.isnan(simulated.low)
    low = simulated.value if no_interval else simulated.low
    high = simulated.value if no_interval else simulated.high
    if published.low <= low and high <= published.high:
        return "as published"
    if high < published.low or low > published.high:
        return "off"
    return "undecided"
