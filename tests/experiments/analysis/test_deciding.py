from math import inf, nan

import pytest

from experiments.analysis.deciding import region, seeds_to_decide, standing, verdict
from experiments.analysis.statistics import Estimate


def estimate(value, low, high, n=30):
    return Estimate(value=value, low=low, high=high, n=n, method="bootstrap")


def test_a_region_holds_the_values_that_are_asked_for():
    assert region("at least", 0.9) == (0.9, inf)
    assert region("above", 0.0) == (0.0, inf)
    assert region("at most", 0.5) == (-inf, 0.5)
    assert region("at most", 0.5, 0.3) == (0.3, 0.5)
    assert region("no better than", 0.1) == (-inf, 0.1)


def test_an_interval_that_ends_on_the_border_decides():
    wanted = (0.9, inf)
    assert verdict(estimate(0.95, 0.9, 1.0), wanted, holds=True) == "holds"
    assert verdict(estimate(0.85, 0.8, 0.9), wanted, holds=False) == "fails"
    assert verdict(estimate(0.9, nan, nan), wanted, holds=True) == "holds"


def test_above_is_undecided_where_the_interval_begins_at_the_border():
    assert verdict(estimate(0.5, 0.0, 1.0), (0.0, inf), holds=False) == "undecided"
    assert verdict(estimate(0.0, 0.0, 0.0), (0.0, inf), holds=False) == "fails"


@pytest.mark.parametrize(
    ("value", "low", "high", "needed"),
    [
        (0.95, 0.85, 1.0, 121),  # .10 must become .05: four times as many
        (0.85, 0.75, 0.95, 121),
        (0.95, 0.92, 1.0, None),
        (0.9, 0.8, 1.0, None),  # on the border: never
    ],
)
def test_intervals_narrow_with_the_square_root_of_the_seeds(value, low, high, needed):
    found = seeds_to_decide(estimate(value, low, high), (0.9, inf))
    assert found == pytest.approx(needed, abs=1) if needed else found is None


def test_of_two_borders_the_nearer_one_takes_more_seeds():
    both = seeds_to_decide(estimate(0.4, 0.2, 0.55), (0.3, 0.5))
    assert both == seeds_to_decide(estimate(0.4, 0.2, 0.45), (0.3, 0.5))
    assert both > 100


def test_what_has_no_references_has_no_standing():
    assert standing((0.5, inf), []) is None
    assert standing((0.5, inf), [nan, nan]) is None
    assert standing((0.3, 0.5), [0.1, 0.6]) is None
    assert standing((0.3, 0.5), [0.1, 0.2]) == "unattainable"
    assert standing((0.3, 0.5), [0.35, 0.45]) == "empty"
