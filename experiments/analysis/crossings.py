"""Where a difference changes its sign: at which heterogeneity gain turns to harm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from experiments.analysis.statistics import LEVEL, Estimate, FloatArray

RESAMPLES = 2_000

_SEED = 20_080_312  # the same numbers give the same interval (the date of HRI 2008)


def crossing(levels: Sequence[float], differences: FloatArray) -> float:
    """Returns where a curve of differences first falls from above 0 to 0 or below.

    Args:
        levels: Rising, shape (n_levels,).
        differences: Shape (n_levels,).

    Returns:
        Between the two levels, by linear interpolation; the first level if it is never
        above 0, infinity if it never falls.
    """
    if differences[0] <= 0.0:
        return float(levels[0])
    for place in range(1, len(levels)):
        before, after = differences[place - 1], differences[place]
        if after <= 0.0:
            share = before / (before - after)
            return float(
                levels[place - 1] + share * (levels[place] - levels[place - 1])
            )
    return float("inf")


def crossing_of_seeds(levels: Sequence[float], differences: FloatArray) -> Estimate:
    """Returns the crossing of the mean curve, with its interval over seeds.

    Args:
        levels: Rising, shape (n_levels,).
        differences: Shape (n_seeds, n_levels), paired: a whole seed is resampled.

    Returns:
        Percentile bootstrap. An end of the interval that is infinite means that the
        curve may not cross within the levels.
    """
    rng = np.random.default_rng(_SEED)
    n = len(differences)
    picks = rng.integers(0, n, size=(RESAMPLES, n))
    found = np.sort(
        [crossing(levels, differences[pick].mean(axis=0)) for pick in picks]
    )
    tail = round((1 - LEVEL) / 2 * RESAMPLES)
    return Estimate(
        value=crossing(levels, differences.mean(axis=0)),
        low=float(found[tail]),
        high=float(found[-tail - 1]),
        n=n,
        method="bootstrap",
    )
