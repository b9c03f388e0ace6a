import pytest

from learners.pooling.partial import pooled


def test_without_trust_the_own_value_stands_alone():
    assert pooled(0.2, 0.0, -1.0, trust=0.0, noise=0.5) == 0.2


def test_with_full_trust_the_others_value_stands_alone():
    assert pooled(0.2, 7.0, -1.0, trust=1.0, noise=0.5) == pytest.approx(-1.0)


def test_half_trust_and_no_touch_of_ones_own_goes_half_the_way_to_the_others():
    assert pooled(0.0, 0.0, -1.0, trust=0.5, noise=0.5) == pytest.approx(-0.5)


def test_one_touch_of_ones_own_draws_the_value_back_to_it():
    # worth = 0.5 * 0.5 = 0.25; weight = 0.5 * 0.25 / (1 * 0.5 + 0.25) = 1/6
    assert pooled(1.0, 1.0, -1.0, trust=0.5, noise=0.5) == pytest.approx(1 - 2 / 6)
