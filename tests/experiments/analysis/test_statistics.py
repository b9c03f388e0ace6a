import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from experiments.analysis import statistics


def test_the_mean_lies_within_its_interval_and_the_interval_has_the_known_width():
    sample = np.random.default_rng(0).normal(3.0, 1.0, size=400)
    found = statistics.mean(sample)
    assert found.low < found.value < found.high
    assert found.value == pytest.approx(sample.mean())
    # 1.96 standard errors on each side: 2 * 1.96 * 1 / sqrt(400) = 0.196
    assert found.high - found.low == pytest.approx(0.196, rel=0.1)
    assert (found.n, found.method) == (400, "bootstrap")


def test_the_same_numbers_give_the_same_interval():
    sample = [0.1, 0.4, 0.2, 0.9, 0.5]
    assert statistics.mean(sample) == statistics.mean(sample)


def test_intervals_cover_the_true_mean_about_as_often_as_they_say():
    rng = np.random.default_rng(1)
    covered = 0
    for _ in range(100):
        found = statistics.mean(rng.normal(size=30))
        covered += found.low <= 0.0 <= found.high
    assert 85 <= covered <= 100


def test_one_seed_gives_a_value_but_no_interval():
    found = statistics.mean([2.0])
    assert found.value == 2.0
    assert np.isnan([found.low, found.high]).all()
    assert found.method == "too few seeds"


def test_no_seed_gives_no_value():
    assert np.isnan(statistics.mean([]).value)


def test_seeds_that_are_all_equal_are_said_to_be_so():
    found = statistics.mean([0.5] * 10)
    assert (found.low, found.value, found.high) == (0.5, 0.5, 0.5)
    assert found.method == "all equal"


def test_thirty_of_thirty_is_not_certainty():
    found = statistics.proportion(np.ones(30))
    # Clopper and Pearson: the lower end is 0.025 ** (1 / 30).
    assert found.low == pytest.approx(0.025 ** (1 / 30), abs=1e-6)
    assert (found.value, found.high) == (1.0, 1.0)
    assert found.method == "exact binomial"


def test_none_of_ten_is_not_impossibility():
    found = statistics.proportion(np.zeros(10))
    assert found.high == pytest.approx(1 - 0.025 ** (1 / 10), abs=1e-6)


def test_a_proportion_of_something_else_than_yes_and_no_is_refused():
    with pytest.raises(ValueError, match="0 or 1"):
        statistics.proportion([0.0, 0.5])


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_values_that_are_not_finite_are_refused(bad):
    with pytest.raises(ValueError, match="finite"):
        statistics.mean([1.0, bad])


def test_a_paired_difference_is_sharper_than_the_spread_of_the_seeds():
    rng = np.random.default_rng(2)
    seeds = rng.normal(0.0, 10.0, size=30)
    treated = seeds + 1.0 + rng.normal(0.0, 0.1, size=30)
    found = statistics.paired_difference(treated, seeds)
    assert found.value == pytest.approx(1.0, abs=0.1)
    assert 0.0 < found.high - found.low < 0.2


def test_conditions_of_different_length_are_not_paired():
    with pytest.raises(ValueError, match="not paired: 2 and 3"):
        statistics.paired_difference([1, 2], [1, 2, 3])


def test_the_interquartile_mean_ignores_the_outer_quarters():
    found = statistics.interquartile_mean([-100, 1, 2, 3, 4, 5, 6, 1000])
    assert found.value == pytest.approx((2 + 3 + 4 + 5) / 4)


def test_the_probability_of_improvement_counts_pairs_and_halves_ties():
    # 2 > 1, 2 = 2, 4 > 1, 4 > 2: three wins and a tie of four pairs
    found = statistics.probability_of_improvement([2, 4], [1, 2])
    assert found.value == pytest.approx(3.5 / 4)
    assert found.low <= found.value <= found.high


def test_holm_multiplies_step_by_step_and_never_falls():
    # Sorted: 0.01 * 4, 0.02 * 3, 0.03 * 2 -> 0.06, 0.04 * 1 -> 0.06
    adjusted = statistics.holm([0.04, 0.01, 0.03, 0.02])
    assert adjusted == pytest.approx([0.06, 0.04, 0.06, 0.06])
    assert statistics.holm([0.9, 0.8]) == pytest.approx([1.0, 1.0])


def test_a_band_leaves_out_curves_where_they_have_no_value():
    curves = np.array([[1.0, np.nan, np.nan], [3.0, 5.0, np.nan]])
    center, low, high = statistics.mean_band(curves)
    assert center[:2] == pytest.approx([2.0, 5.0])
    assert np.isnan([center[2], low[2], high[2]]).all()
    assert (low[:2] <= center[:2]).all()
    assert (center[:2] <= high[:2]).all()


@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=8))
def test_an_interval_always_has_its_ends_in_order(values):
    found = statistics.mean(values)
    assert found.low <= found.high
