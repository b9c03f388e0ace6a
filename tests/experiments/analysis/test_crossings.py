import numpy as np
import pytest

from experiments.analysis.crossings import crossing, crossing_of_seeds

LEVELS = (0.0, 0.25, 0.5, 0.75, 1.0)


def test_a_curve_crosses_between_two_levels():
    # From .10 to -.05 over a quarter: two thirds of the way.
    curve = np.array([0.2, 0.1, -0.05, -0.1, -0.2])
    assert crossing(LEVELS, curve) == pytest.approx(0.25 + 0.25 * 2 / 3)


def test_what_never_helps_crosses_at_once_and_what_always_helps_never():
    assert crossing(LEVELS, np.full(5, -0.1)) == 0.0
    assert crossing(LEVELS, np.full(5, 0.1)) == np.inf


def test_the_interval_holds_the_crossing_of_a_noisy_line():
    rng = np.random.default_rng(0)
    lines = 0.3 - 0.6 * np.array(LEVELS) + rng.normal(0, 0.1, (40, 5))
    found = crossing_of_seeds(LEVELS, lines)
    assert found.low < 0.5 < found.high
    assert found.high - found.low < 0.2


def test_where_some_seeds_never_cross_the_interval_is_open():
    flat = np.repeat(np.array([[0.02], [-0.02], [0.03]]), 5, axis=1)
    assert crossing_of_seeds(LEVELS, flat).high == np.inf
