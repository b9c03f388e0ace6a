"""Estimates with 95 % intervals, contrasts paired by seed, corrections.

Every interval is a bootstrap interval from SciPy with a generator of its own, so the
same numbers give the same interval. Where a bootstrap would claim a certainty that the
sample cannot give, the interval says how it came about instead.

Source: Agarwal et al., "Deep Reinforcement Learning at the Edge of the Statistical
Precipice", NeurIPS 2021, for interquartile mean and probability of improvement.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

LEVEL = 0.95
"""Confidence level of every interval."""

RESAMPLES = 4_000
"""Bootstrap resamples: the ends of an interval then move by about 1 % of its width."""

_SEED = 20_080_312  # the same numbers give the same interval (the date of HRI 2008)


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A value and the interval that it lies in."""

    value: float
    """The point estimate; NaN without data."""

    low: float
    """Lower end of the 95 % interval; NaN if the sample gives none."""

    high: float
    """Upper end of the 95 % interval; NaN if the sample gives none."""

    n: int
    """Sample size (seeds)."""

    method: str
    """How the interval came about."""


def mean(values: npt.ArrayLike) -> Estimate:
    """Returns the mean with its bootstrap interval (BCa).

    Args:
        values: One number per seed, shape (n_seeds,), finite.

    Returns:
        The mean. One seed gives no interval; all seeds equal give an interval of width
        zero that is named "all equal" and not a bootstrap.

    Raises:
        ValueError: If a value is not finite.
    """
    return _estimate(values, np.mean)


def interquartile_mean(values: npt.ArrayLike) -> Estimate:
    """Returns the mean of the middle half with its bootstrap interval (BCa).

    Args:
        values: One number per seed, shape (n_seeds,), finite.
    """
    return _estimate(values, _trimmed)


def proportion(successes: npt.ArrayLike) -> Estimate:
    """Returns the share of successes with its interval.

    Args:
        successes: One 0 or 1 (or bool) per seed, shape (n_seeds,).

    Returns:
        A bootstrap interval (BCa), but the exact binomial one of Clopper and Pearson
        where all or none succeeded: resampling 30 successes of 30 gives 30 of 30 only.

    Raises:
        ValueError: If a value is neither 0 nor 1.
    """
    sample = _checked(successes)
    if not np.isin(sample, (0.0, 1.0)).all():
        raise ValueError("a proportion needs values that are 0 or 1")
    if len(sample) < 2 or 0 < sample.sum() < len(sample):
        return _estimate(sample, np.mean)
    from scipy.stats import binomtest

    share = float(sample.mean())
    exact = binomtest(int(sample.sum()), len(sample)).proportion_ci(LEVEL)
    return Estimate(
        value=share,
        low=float(exact.low),
        high=float(exact.high),
        n=len(sample),
        method="exact binomial",
    )


def paired_difference(treated: npt.ArrayLike, control: npt.ArrayLike) -> Estimate:
    """Returns the mean difference of two conditions that share their seeds.

    Args:
        treated: One number per seed, shape (n_seeds,).
        control: The same seeds in the same order.

    Returns:
        The mean of `treated - control` with its bootstrap interval over seeds.

    Raises:
        ValueError: If the lengths differ or a value is not finite.
    """
    one, other = _checked(treated), _checked(control)
    if one.shape != other.shape:
        raise ValueError(f"not paired: {len(one)} and {len(other)} values")
    return mean(one - other)


def probability_of_improvement(
    treated: npt.ArrayLike, control: npt.ArrayLike
) -> Estimate:
    """Returns how often a random run of one condition beats one of the other.

    Args:
        treated: One number per run, shape (n,).
        control: One number per run, shape (m,).

    Returns:
        P(treated > control) + P(equal) / 2 over all pairs of runs, with a percentile
        bootstrap interval that resamples both.
    """
    from scipy.stats import bootstrap

    one, other = _checked(treated), _checked(control)
    value = float(_improvement(one, other))
    if min(len(one), len(other)) < 2:
        return _without_interval(value, min(len(one), len(other)))
    interval = bootstrap(
        (one, other),
        _improvement,
        n_resamples=RESAMPLES,
        vectorized=False,
        confidence_level=LEVEL,
        method="percentile",
        rng=np.random.default_rng(_SEED),
    ).confidence_interval
    return Estimate(
        value=value,
        low=float(interval.low),
        high=float(interval.high),
        n=min(len(one), len(other)),
        method="bootstrap",
    )


def holm(p_values: Sequence[float]) -> FloatArray:
    """Returns p-values adjusted for their number by Holm's step-down rule.

    Args:
        p_values: Shape (n,), each in [0, 1].

    Returns:
        Adjusted p-values in the order given, shape (n,).

    Source: Holm, "A Simple Sequentially Rejective Multiple Test Procedure", 1979.
    """
    p = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(p)
    factors = len(p) - np.arange(len(p))
    adjusted = np.empty_like(p)
    adjusted[order] = np.minimum(np.maximum.accumulate(factors * p[order]), 1.0)
    return adjusted


def mean_band(samples: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Returns mean, lower and upper end at each point of many curves.

    Args:
        samples: One curve per seed, shape (n_seeds, n_points); NaN where a curve has no
            value, which leaves it out at that point.

    Returns:
        Three arrays of shape (n_points,); pointwise percentile bootstrap over seeds,
        NaN at points without data.
    """
    rng = np.random.default_rng(_SEED)
    picks = rng.integers(0, len(samples), size=(1_000, len(samples)))
    known = ~np.isnan(samples)
    filled = np.where(known, samples, 0.0)
    weights = np.zeros((len(picks), len(samples)))
    np.add.at(weights, (np.arange(len(picks))[:, None], picks), 1.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        resampled = (weights @ filled) / (weights @ known)
        center = filled.sum(axis=0) / known.sum(axis=0)
    tails = [(1 - LEVEL) / 2, (1 + LEVEL) / 2]
    low, high = _quantiles(resampled, tails)
    return center, low, high


def _quantiles(resampled: FloatArray, tails: list[float]) -> FloatArray:
    known = ~np.isnan(resampled).all(axis=0)
    found = np.full((len(tails), resampled.shape[1]), np.nan)
    found[:, known] = np.nanquantile(resampled[:, known], tails, axis=0)
    return found


def _estimate(
    values: npt.ArrayLike, statistic: Callable[..., npt.ArrayLike]
) -> Estimate:
    sample = _checked(values)
    if len(sample) == 0:
        return _without_interval(float("nan"), 0)
    value = float(np.asarray(statistic(sample)))
    if len(sample) == 1:
        return _without_interval(value, 1)
    if np.ptp(sample) == 0:
        return Estimate(
            value=value, low=value, high=value, n=len(sample), method="all equal"
        )
    low, high = _bootstrap(sample, statistic)
    return Estimate(value=value, low=low, high=high, n=len(sample), method="bootstrap")


def _bootstrap(
    sample: FloatArray, statistic: Callable[..., npt.ArrayLike]
) -> tuple[float, float]:
    """Returns the BCa interval, or the percentile one where BCa is not defined."""
    import warnings

    from scipy.stats import bootstrap

    for method in ("BCa", "percentile"):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # "degenerate": answered by the next method
            interval = bootstrap(
                (sample,),
                statistic,
                n_resamples=RESAMPLES,
                confidence_level=LEVEL,
                method=method,
                rng=np.random.default_rng(_SEED),
            ).confidence_interval
        if np.isfinite(interval.low) and np.isfinite(interval.high):
            break
    return float(interval.low), float(interval.high)


def _without_interval(value: float, n: int) -> Estimate:
    nan = float("nan")
    return Estimate(value=value, low=nan, high=nan, n=n, method="too few seeds")


def _trimmed(sample: FloatArray, axis: int = -1) -> npt.ArrayLike:
    from scipy.stats import trim_mean

    trimmed: npt.ArrayLike = trim_mean(sample, 0.25, axis=axis)
    return trimmed


def _improvement(one: FloatArray, other: FloatArray) -> float:
    return float(np.mean((np.sign(one[:, None] - other[None, :]) + 1.0) / 2.0))


def _checked(values: npt.ArrayLike) -> FloatArray:
    sample = np.atleast_1d(np.asarray(values, dtype=np.float64))
    if sample.ndim != 1 or not np.isfinite(sample).all():
        raise ValueError("expected one finite number per seed")
    return sample
