"""Contrasts that a study names before it is run, corrected for their number."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import polars as pl

from experiments.analysis.crossed import crossed, p_value, weighted_mean
from experiments.analysis.statistics import (
    Estimate,
    holm,
    probability_of_improvement,
)
from experiments.errors import ExperimentError

MOST = 6
"""So many contrasts a study may name."""

ALPHA = 0.05
"""Chance, over all contrasts of a study, to call a difference that is none."""

PAIRED = ("seed", "people", "home", "roles", "touches")
"""Columns that two rows to be compared have in common, as far as they are there."""

FACTORS = ("seed", "people", "home")
"""What is resampled."""


@dataclass(frozen=True, kw_only=True)
class Contrast:
    """A difference that a study is about, named before it is run."""

    text: str
    """What is expected, in one sentence."""

    more: Mapping[str, object]
    """Column -> value, of the rows that are expected to be higher."""

    less: Mapping[str, object]
    """The same for those that they are compared with."""

    score: str = "greedy"
    """Column that is compared."""


@dataclass(frozen=True, kw_only=True)
class Result:
    """What came of a contrast."""

    contrast: Contrast
    difference: Estimate
    """Mean difference over pairs, crossed bootstrap over seeds, people and homes."""

    improvement: Estimate
    """How often a random one of `more` beats a random one of `less`, over seeds."""

    p: float
    """Two-sided, as it comes."""

    adjusted: float
    """After Holm's correction for the number of contrasts of the study."""

    @property
    def verdict(self) -> str:
        """`as expected`, `the opposite` or `not found`."""
        if self.adjusted > ALPHA:
            return "not found"
        return "as expected" if self.difference.value > 0 else "the opposite"


def results(frame: pl.DataFrame, contrasts: Sequence[Contrast]) -> tuple[Result, ...]:
    """Returns what came of a study's contrasts.

    Args:
        frame: A row for each score, with `seed`, and `people` and `home` if known.
        contrasts: As named beforehand, at most 6.

    Raises:
        ExperimentError: If there are too many, or one has no pairs.
    """
    if len(contrasts) > MOST:
        raise ExperimentError(
            f"{len(contrasts)} contrasts; allowed: at most {MOST}, named beforehand."
        )
    pairs = [_pairs(frame, each) for each in contrasts]
    raw = [p_value(_difference(each), _factors(each)) for each in pairs]
    return tuple(
        Result(
            contrast=contrast,
            difference=crossed(_difference(pair), _factors(pair), weighted_mean),
            improvement=_improvement(pair),
            p=p,
            adjusted=float(adjusted),
        )
        for contrast, pair, p, adjusted in zip(
            contrasts, pairs, raw, holm(raw), strict=True
        )
    )


def _pairs(frame: pl.DataFrame, contrast: Contrast) -> pl.DataFrame:
    """Rows of both sides that share seed, people and home; mean over what is left."""
    keys = [name for name in PAIRED if name in frame.columns]
    # What is compared must not be what is paired by.
    keys = [k for k in keys if contrast.more.get(k) == contrast.less.get(k)]
    sides = []
    for chosen in (contrast.more, contrast.less):
        rows = frame.filter(
            *(pl.col(name) == value for name, value in chosen.items()),
            pl.col(contrast.score).is_not_nan(),
        )
        sides.append(rows.group_by(keys).agg(pl.col(contrast.score).mean()))
    pairs = sides[0].join(sides[1], on=keys, suffix="_less").sort(keys)
    if pairs.is_empty():
        pairs = _by_seed(sides, contrast.score)
    if pairs.is_empty():
        raise ExperimentError(f"contrast {contrast.text!r}: nothing to compare.")
    return pairs.rename({contrast.score: "more", f"{contrast.score}_less": "less"})


def _by_seed(sides: Sequence[pl.DataFrame], score: str) -> pl.DataFrame:
    """Where two conditions have other people or homes, seeds alone are paired."""
    means = [side.group_by("seed").agg(pl.col(score).mean()) for side in sides]
    return means[0].join(means[1], on="seed", suffix="_less").sort("seed")


def _difference(pairs: pl.DataFrame) -> np.ndarray:
    return (pairs["more"] - pairs["less"]).to_numpy()


def _factors(pairs: pl.DataFrame) -> dict[str, np.ndarray]:
    return {name: pairs[name].to_numpy() for name in FACTORS if name in pairs.columns}


def _improvement(pairs: pl.DataFrame) -> Estimate:
    seeds = pairs.group_by("seed").agg(pl.col("more", "less").mean()).sort("seed")
    return probability_of_improvement(
        seeds["more"].to_numpy(), seeds["less"].to_numpy()
    )
