"""What a study found: estimates for each condition, what became of its contrasts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import polars as pl

from experiments.analysis.crossed import crossed, cvar, weighted_iqm
from experiments.analysis.preregistered import FACTORS, Result, results
from experiments.analysis.statistics import Estimate
from experiments.generalization.inquiry import Inquiry


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What one condition came to, at one number of touches."""

    factors: Mapping[str, str]
    """Factor -> level."""

    touches: int
    """From the household that it was probed in."""

    greedy: Estimate
    """Probe score of what it holds best: interquartile mean, crossed bootstrap."""

    deployed: Estimate
    """Probe score of what it does, exploration included."""

    best_constant: float
    """Mean score of the best constant behavior, in hindsight, in each household."""

    worst_people: float
    """Mean of `greedy` over the worst tenth of people."""

    worst_homes: float
    """The same over homes."""

    verdicts_per_minute: Estimate | None
    """What people thought of its own episodes; None where it did not live."""

    trained_touches: float
    met: float | None
    """Share of the choices of training made in a situation met before."""


@dataclass(frozen=True, kw_only=True)
class Findings:
    """What a study found."""

    study: str
    question: str
    seeds: int
    trials: int
    conditions: tuple[Finding, ...]
    contrasts: tuple[Result, ...]
    sentences: tuple[str, ...]
    """In words, made from the numbers."""


def findings(inquiry: Inquiry, frame: pl.DataFrame) -> Findings:
    """Returns what a study found.

    Args:
        inquiry: What was asked.
        frame: Its table: a row for each trial, household and number of touches.
            Households in which it makes no difference what a robot does are left out.
    """
    contrasts = results(frame, inquiry.contrasts)
    said = inquiry.say(frame, contrasts) if inquiry.say is not None else ()
    return Findings(
        study=inquiry.name,
        question=inquiry.question,
        seeds=frame["seed"].n_unique(),
        trials=frame.select("condition", "seed").n_unique(),
        conditions=tuple(
            _finding(dict(condition.factors), touches, rows)
            for condition in inquiry.conditions
            for (touches,), rows in frame.filter(pl.col("condition") == condition.name)
            .sort("touches", maintain_order=True)
            .group_by(["touches"], maintain_order=True)
        ),
        contrasts=contrasts,
        sentences=(*map(sentence, contrasts), *said),
    )


def sentence(result: Result) -> str:
    """Returns what became of a contrast, in words."""
    found = {
        "as expected": "found",
        "the opposite": "the opposite was found",
        "not found": "not found",
    }[result.verdict]
    return (
        f"{result.contrast.text} {found[0].upper()}{found[1:]}: a difference of "
        f"{interval_of(result.difference)}, P(better) = "
        f"{result.improvement.value:.2f}, p = {result.adjusted:.3f} after Holm."
    )


def interval_of(estimate: Estimate, digits: int = 2) -> str:
    """Returns an estimate with its interval: `0.42 [0.31, 0.50]`."""
    value, low, high = (
        f"{each:z.{digits}f}" for each in (estimate.value, estimate.low, estimate.high)
    )
    return value if np.isnan(estimate.low) else f"{value} [{low}, {high}]"


def score_of(rows: pl.DataFrame, column: str = "greedy") -> Estimate:
    """Returns the interquartile mean of a score, crossed over seeds, people, homes."""
    known = rows.filter(pl.col(column).is_not_nan() & pl.col(column).is_not_null())
    factors = {name: known[name].to_numpy() for name in FACTORS}
    return crossed(known[column].to_numpy(), factors, weighted_iqm)


def _finding(
    factors: Mapping[str, str], touches: object, rows: pl.DataFrame
) -> Finding:
    probed = rows.filter(pl.col("greedy").is_not_nan())
    lived = rows.filter(pl.col("verdicts_per_minute").is_not_null())
    met = rows["met"].mean()
    return Finding(
        factors=factors,
        touches=int(str(touches)),
        greedy=score_of(rows),
        deployed=score_of(rows, "deployed"),
        best_constant=_mean(probed, "best_constant"),
        worst_people=_worst(probed, "people"),
        worst_homes=_worst(probed, "home"),
        verdicts_per_minute=score_of(lived, "verdicts_per_minute")
        if len(lived)
        else None,
        trained_touches=_mean(rows, "trained_touches"),
        met=None if met is None else float(str(met)),
    )


def _mean(rows: pl.DataFrame, column: str) -> float:
    return float(np.mean(rows[column].to_numpy())) if len(rows) else float("nan")


def _worst(rows: pl.DataFrame, of: str) -> float:
    if rows.is_empty():
        return float("nan")
    return cvar(rows["greedy"].to_numpy(), rows[of].to_numpy())
