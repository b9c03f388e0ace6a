import pytest

from learners.tabular.updates import hysteretic, moved, q_target, td_error


def test_the_target_is_the_reward_and_the_discounted_best_of_what_follows():
    assert q_target(1.0, 0.5, [0.2, 0.6]) == pytest.approx(1.3)


def test_the_error_is_positive_where_the_value_was_too_low():
    assert td_error(0.4, 1.0) == pytest.approx(0.6)


def test_a_step_of_a_quarter_goes_a_quarter_of_the_way():
    assert moved(0.4, 1.2, 0.25) == pytest.approx(0.6)


def test_hysteresis_believes_good_news_more_than_bad():
    assert hysteretic(0.2, 0.5, increase=0.9, decrease=0.1) == 0.9
    assert hysteretic(0.5, 0.2, increase=0.9, decrease=0.1) == 0.1
