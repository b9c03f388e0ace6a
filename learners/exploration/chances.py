"""With what probability a rule takes each behavior; for reports, not for choosing."""

from functools import singledispatch

import numpy as np
from numpy.typing import NDArray

from learners.exploration.company import SeekCompany
from learners.exploration.rules import (
    EpsilonGreedy,
    Estimates,
    Greedy,
    Softmax,
    Thompson,
    UpperConfidence,
    softmax,
)

Chances = NDArray[np.float64]

NODES = np.linspace(-6.0, 6.0, 121)
"""Where a normal density is summed up, in standard deviations."""

SHARES = (np.arange(400) + 0.5) / 400
"""Where the density of a share is summed up."""


@singledispatch
def chances(rule: object, estimates: Estimates) -> Chances | None:
    """The probability of each behavior.

    Users register their own rules: ``@chances.register``.

    Args:
        rule: An exploration rule.
        estimates: What is known of the behaviors.

    Returns:
        Shape (n_behaviors,), sums to 1; None if the rule is not known here.
    """
    return None


@chances.register
def _greedy(rule: Greedy, estimates: Estimates) -> Chances | None:
    return _best(np.asarray(estimates.values))


@chances.register
def _epsilon(rule: EpsilonGreedy, estimates: Estimates) -> Chances | None:
    values = np.asarray(estimates.values)
    any_of_all: Chances = (1.0 - rule.epsilon) * _best(values)
    return any_of_all + rule.epsilon / len(values)


@chances.register
def _softmax(rule: Softmax, estimates: Estimates) -> Chances | None:
    return np.array(softmax(estimates.values, rule.temperature))


@chances.register
def _bound(rule: UpperConfidence, estimates: Estimates) -> Chances | None:
    visits = np.asarray(estimates.visits)
    with np.errstate(divide="ignore", invalid="ignore"):
        bonus = rule.width * np.sqrt(np.log1p(visits.sum()) / visits)
    bonus[visits <= 0.0] = np.inf
    return _best(np.asarray(estimates.values) + bonus)


@chances.register
def _thompson(rule: Thompson, estimates: Estimates) -> Chances | None:
    """Each draw's density times the chance that all others are below it."""
    from scipy.special import log_ndtr

    if estimates.deviations is None:
        return None
    means = np.asarray(estimates.values)
    deviations = np.maximum(np.asarray(estimates.deviations), 1e-12)
    points = means[:, None] + deviations[:, None] * NODES
    below = log_ndtr((points[..., None] - means) / deviations).sum(axis=-1)
    own = log_ndtr(NODES)
    found: Chances = np.exp(below - own - NODES**2 / 2).sum(axis=1)
    return found / found.sum()


@chances.register
def _company(rule: SeekCompany, estimates: Estimates) -> Chances | None:
    """Alone, each draw's density times the chance that all others are below it."""
    from scipy.special import betainc, betaln, xlog1py, xlogy

    if not estimates.alone:
        return chances(rule.among, estimates)
    hits, misses = rule.posterior(len(estimates.values))
    rates = SHARES[:, None]
    below = np.log(np.maximum(betainc(hits, misses, rates), 1e-300))
    own = xlogy(hits - 1.0, rates) + xlog1py(misses - 1.0, -rates)
    others = below.sum(axis=1, keepdims=True) - below
    found: Chances = np.exp(own - betaln(hits, misses) + others).sum(axis=0)
    return found / found.sum()


def _best(values: Chances) -> Chances:
    """The same for each of the largest ones, nothing for others."""
    top = values == values.max()
    share: Chances = top / np.count_nonzero(top)
    return share
