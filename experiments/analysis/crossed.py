"""Statistics over several samples at once: seeds, people and homes are all drawn.

A score belongs to a seed, to the people and to the home that it was measured with, and
each of them was drawn from many. A bootstrap over seeds alone takes the people at hand
for all there are. The crossed one draws the levels of every factor anew, and a score
counts as often as its levels were drawn, multiplied.

Sources: Owen, "The pigeonhole bootstrap", Annals of Applied Statistics 1, 2007, for the
crossed bootstrap; Agarwal et al., NeurIPS 2021, for interquartile mean and performance
profiles; Rockafellar and Uryasev, 2002, for CVaR.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from experiments.analysis.statistics import LEVEL, Estimate, FloatArray

RESAMPLES = 2_000
"""Bootstrap resamples: the ends of an interval then move by about 2 % of its width."""

WORST = 0.1
"""Which share of people or homes CVaR is the mean of."""

_SEED = 20_080_312  # the same numbers give the same interval (the date of HRI 2008)

Labels = Sequence[object] | npt.NDArray[np.generic]
"""The level of a factor that each score belongs to."""

Statistic = Callable[[FloatArray, FloatArray], float]
"""Takes scores and how often each counts, both of shape (n_scores,)."""


def weighted_mean(values: FloatArray, weights: FloatArray) -> float:
    """Returns the mean of values that count several times; NaN if none counts."""
    total = weights.sum()
    return float(values @ weights / total) if total > 0 else float("nan")


def weighted_iqm(values: FloatArray, weights: FloatArray) -> float:
    """Returns the mean of the middle half of values that count several times.

    With whole weights it is what `scipy.stats.trim_mean` gives for each value repeated
    that often, but that a quarter is cut off exactly, also where it ends within a
    value.
    """
    total = weights.sum()
    if total <= 0:
        return float("nan")
    order = np.argsort(values, kind="stable")
    ends = np.cumsum(weights[order])
    begins = ends - weights[order]
    inside = np.clip(ends, total / 4, 3 * total / 4) - np.clip(
        begins, total / 4, 3 * total / 4
    )
    return float(values[order] @ inside / inside.sum())


def draws(factors: Mapping[str, Labels], n: int = RESAMPLES) -> FloatArray:
    """Returns how often each score counts in each crossed resample.

    Args:
        factors: Factor -> its level for each score.
        n: How many resamples.

    Returns:
        Shape (n, n_scores): the product, over factors, of how often the score's level
        was drawn among as many levels as there are.
    """
    rng = np.random.default_rng(_SEED)
    weights: FloatArray | None = None
    for labels in factors.values():
        names, at = np.unique(_comparable(labels), return_inverse=True)
        counts = rng.multinomial(len(names), np.full(len(names), 1 / len(names)), n)
        counted = counts[:, at].astype(np.float64)
        weights = counted if weights is None else weights * counted
    if weights is None:
        raise ValueError("at least one factor is needed, such as the seeds")
    return weights


def crossed(
    values: npt.ArrayLike,
    factors: Mapping[str, Labels],
    statistic: Statistic = weighted_iqm,
) -> Estimate:
    """Returns a statistic of scores with its crossed bootstrap interval (percentile).

    Args:
        values: One number for each score, shape (n_scores,), finite.
        factors: Factor -> its level for each score: seeds, people, homes.
        statistic: Of scores and how often each counts.

    Returns:
        The estimate. Its `n` is that of the factor with the fewest levels of those
        that have two or more: what the interval can rest on. Factors with one level
        are not resampled.

    Raises:
        ValueError: If there is no factor, or a value is not finite.
    """
    scores = np.asarray(values, dtype=np.float64)
    if scores.ndim != 1 or not np.isfinite(scores).all():
        raise ValueError("expected one finite number for each score")
    ones, nan = np.ones(len(scores)), float("nan")
    value = statistic(scores, ones) if len(scores) else nan
    several = {name: labels for name, labels in factors.items() if _levels(labels) > 1}
    if not several or not len(scores):
        return Estimate(value=value, low=nan, high=nan, n=1, method="too few levels")
    resampled = _resampled(scores, several, statistic)
    low, high = np.nanquantile(resampled, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return Estimate(
        value=value,
        low=float(low),
        high=float(high),
        n=min(_levels(labels) for labels in several.values()),
        method=f"crossed bootstrap over {', '.join(several)}",
    )


def p_value(values: npt.ArrayLike, factors: Mapping[str, Labels]) -> float:
    """Returns how compatible paired differences are with a mean of 0, two-sided.

    Args:
        values: A difference for each pair of scores, shape (n_scores,).
        factors: Factor -> its level for each pair.

    Returns:
        Twice the smaller share of crossed resamples whose mean lies on one side of 0,
        the sample itself counted among them, so that it is never 0.
    """
    scores = np.asarray(values, dtype=np.float64)
    several = {name: labels for name, labels in factors.items() if _levels(labels) > 1}
    if not several:
        return 1.0
    means = _resampled(scores, several, weighted_mean)
    means = means[~np.isnan(means)]
    below, above = (means <= 0.0).sum() + 1, (means >= 0.0).sum() + 1
    return float(min(1.0, 2.0 * min(below, above) / (len(means) + 1)))


def profile(values: npt.ArrayLike, thresholds: npt.ArrayLike) -> FloatArray:
    """Returns the performance profile: the share of scores above each threshold.

    Args:
        values: Shape (n_scores,).
        thresholds: Shape (n_thresholds,).
    """
    scores = np.asarray(values, dtype=np.float64)
    above = scores[:, None] > np.asarray(thresholds, dtype=np.float64)[None, :]
    return np.asarray(above.mean(axis=0), dtype=np.float64)


def profile_band(
    values: npt.ArrayLike, thresholds: npt.ArrayLike, factors: Mapping[str, Labels]
) -> tuple[FloatArray, FloatArray]:
    """Returns the pointwise 95 % band of a performance profile, crossed bootstrap."""
    scores = np.asarray(values, dtype=np.float64)
    above = scores[:, None] > np.asarray(thresholds, dtype=np.float64)[None, :]
    weights = draws(factors)
    weights = weights[weights.sum(axis=1) > 0]
    shares = (weights @ above) / weights.sum(axis=1, keepdims=True)
    low, high = np.quantile(shares, [(1 - LEVEL) / 2, (1 + LEVEL) / 2], axis=0)
    return low, high


def cvar(values: npt.ArrayLike, of: Labels, worst: float = WORST) -> float:
    """Returns the mean over the worst share of people, homes or whatever is named.

    Args:
        values: Shape (n_scores,); higher is better.
        of: Whom each score belongs to; their scores are averaged first.
        worst: Which share of them; the last of them may count in part, so that it is
            exactly that share.
    """
    scores = np.asarray(values, dtype=np.float64)
    _, at = np.unique(_comparable(of), return_inverse=True)
    means = np.sort(np.bincount(at, scores) / np.bincount(at))
    share = worst * len(means)
    weights = np.clip(share - np.arange(len(means)), 0.0, 1.0)
    return float(means @ weights / share)


def _resampled(
    scores: FloatArray, factors: Mapping[str, Labels], statistic: Statistic
) -> FloatArray:
    """The statistic of each resample; NaN where no score was drawn."""
    weights = draws(factors)
    if statistic is weighted_mean:  # the same in one go
        with np.errstate(invalid="ignore"):
            return np.asarray(weights @ scores / weights.sum(axis=1), dtype=np.float64)
    return np.array([statistic(scores, each) for each in weights])


def _levels(labels: Labels) -> int:
    return len(np.unique(_comparable(labels)))


def _comparable(labels: Labels) -> npt.NDArray[np.generic]:
    """Labels as an array that can be sorted."""
    array = np.asarray(labels)
    return array.astype(str) if array.dtype == object else array
