import pytest

from learners.tabular.updates import hysteretic, moved, pooled, q_target, td_error


def test_the_target_is_the_reward_and_the_discounted_best_of_what_follows():
    assert q_target(1.0, 0.5, [0.2, 0.6]) == pytest.approx(1.3)


def test_the_error_is_positive_where_the_value_was_too_low():
    assert td_error(0.4, 1.0) == pytest.approx(0.6)


def test_a_step_of_a_quarter_goes_a_quarter_of_the_way():
    assert moved(0.4, 1.2, 0.25) == pytest.approx(0.6)


def test_hysteresis_believes_good_news_more_than_bad():
    assert hysteretic(0.2, 0.5, increase=0.9, decrease=0.1) == 0.9
    assert hysteretic(0.5, 0.2, increase=0.9, decrease=0.1) == 0.1


def test_without_trust_the_own_value_stands_alone():
    assert pooled(0.2, 0.0, -1.0, trust=0.0, noise=0.5) == 0.2


def test_with_full_trust_the_others_value_stands_alone():
    assert pooled(0.2, 7.0, -1.0, trust=1.0, noise=0.5) == pytest.approx(-1.0)


def test_half_trust_and_no_touch_of_ones_own_goes_half_the_way_to_the_others():
    assert pooled(0.0, 0.0, -1.0, trust=0.5, noise=0.5) == pytest.approx(-0.5)


def test_one_touch_of_ones_own_draws_the_value_back_to_it():
    # worth = 0.5 * 0.5 = 0.25; weight = 0.5 * 0.25 / (1 * 0.5 + 0.25) = 1/6
    assert pooled(1.0, 1.0, -1.0, trust=0.5, noise=0.5) == pytest.approx(1 - 2 / 6)
