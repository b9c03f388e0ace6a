"""What a study on drawn households found: estimates for each of its conditions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import polars as pl

from experiments.analysis.statistics import Estimate, mean, paired_difference
from experiments.running.study import Study


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What one condition came to, over households."""

    factors: Mapping[str, str]
    """Factor -> level."""

    greedy: Estimate
    """Probe score of what it holds best."""

    deployed: Estimate
    """Probe score of what it does, exploration included."""

    best_constant: Estimate
    """Probe score of the best constant behavior, in hindsight, household by
    household."""

    beyond_constant: Estimate
    """Greedy minus best constant, paired by household."""

    touches: Estimate
    """Touches that it learned from."""

    met: Estimate
    """Share of the choices that it made in a situation met before."""


def findings(study: Study, frame: pl.DataFrame) -> tuple[Finding, ...]:
    """Returns one finding for each condition, in order.

    Args:
        study: What was run.
        frame: Its table: a row for each trial. Trials without a probe set, because it
            made no difference what the robot did, are left out.
    """
    return tuple(
        _finding(
            condition.factors,
            frame.filter(
                (pl.col("condition") == condition.name) & pl.col("greedy").is_not_nan()
            ),
        )
        for condition in study.conditions
    )


def _finding(factors: Mapping[str, str], rows: pl.DataFrame) -> Finding:
    def over(column: str) -> Estimate:
        return mean(rows[column].to_numpy())

    return Finding(
        factors=factors,
        greedy=over("greedy"),
        deployed=over("deployed"),
        best_constant=over("best_constant"),
        beyond_constant=paired_difference(
            rows["greedy"].to_numpy(), rows["best_constant"].to_numpy()
        ),
        touches=over("touches"),
        met=over("met"),
    )
