"""Verdicts on simulated figures are plain and follow from the interval."""

import math

import pytest

from experiments.analysis.statistics import Estimate
from experiments.validation.figures import Published, around, finding, verdict

NAN = math.nan


def published(low=1.0, high=2.0):
    return Published(
        name="a figure",
        unit="s",
        said="1 to 2",
        low=low,
        high=high,
        source="somebody",
        reading="somehow",
    )


def estimate(value, low=NAN, high=NAN):
    return Estimate(value=value, low=low, high=high, n=9, method="by hand")


@pytest.mark.parametrize(
    ("simulated", "expected"),
    [
        (estimate(1.5, 1.2, 1.8), "as published"),
        (estimate(1.5, 1.0, 2.0), "as published"),
        (estimate(2.5, 2.1, 2.9), "off"),
        (estimate(0.5, 0.1, 0.9), "off"),
        (estimate(1.9, 1.6, 2.2), "undecided"),
        (estimate(1.5, 0.5, 2.5), "undecided"),
        (estimate(1.5), "as published"),
        (estimate(2.5), "off"),
        (estimate(NAN), "undecided"),
    ],
)
def test_a_verdict_follows_from_where_the_interval_lies(simulated, expected):
    assert verdict(published(), simulated) == expected
    assert finding(published(), "a scene", simulated).verdict == expected


def test_a_figure_without_a_spread_may_be_a_quarter_off():
    assert around(2.0) == {"low": 1.5, "high": 2.5}
