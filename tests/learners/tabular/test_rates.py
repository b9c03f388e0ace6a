import itertools

import pytest

from learners.errors import ParameterError
from learners.tabular.rates import (
    AsynchronousRate,
    ConstantRate,
    Factors,
    SocialRate,
    SynchronousRate,
)

TOUCH = Factors(rewarded=True, attended=True, mood=0.0)
AVERTED = Factors(rewarded=True, attended=False, mood=0.0)
WATCHED = Factors(rewarded=False, attended=True, mood=0.0)
NOTHING = Factors(rewarded=False, attended=False, mood=0.0)


def test_a_constant_rate_stays():
    assert ConstantRate(alpha=0.3)(99, 99, NOTHING) == 0.3


def test_a_synchronous_rate_falls_with_updates_of_the_whole_table():
    assert SynchronousRate(exponent=1.0)(3, 50, NOTHING) == pytest.approx(0.25)


def test_an_asynchronous_rate_falls_with_visits_of_the_pair():
    assert AsynchronousRate(exponent=0.75)(50, 15, TOUCH) == pytest.approx(0.125)


@pytest.mark.parametrize(
    ("factors", "exponent"),
    [(TOUCH, 0.6), (AVERTED, 0.8), (WATCHED, 1.2), (NOTHING, 1.4)],
)
def test_the_social_exponent_has_its_documented_values(factors, exponent):
    assert SocialRate().exponent(factors) == pytest.approx(exponent)


def test_the_social_rate_is_that_power_of_the_visits():
    assert SocialRate()(50, 3, TOUCH) == pytest.approx(4**-0.6)
    assert SocialRate()(50, 3, NOTHING) == pytest.approx(4**-1.4)


def test_a_good_mood_lets_a_touch_teach_more_than_a_bad_one():
    rate = SocialRate()
    good, bad = TOUCH._replace(mood=1.0), TOUCH._replace(mood=-1.0)
    assert rate.exponent(good) == pytest.approx(0.55)
    assert rate.exponent(bad) == pytest.approx(0.65)


@pytest.mark.parametrize(
    ("switched_off", "one", "other"),
    [
        ("reward", TOUCH, WATCHED),
        ("attention", TOUCH, AVERTED),
        ("mood", TOUCH, TOUCH._replace(mood=1.0)),
    ],
)
def test_a_spread_of_zero_switches_its_factor_off(switched_off, one, other):
    rate = SocialRate(**{switched_off: 0.0})
    assert rate.exponent(one) == rate.exponent(other)
    assert SocialRate().exponent(one) != SocialRate().exponent(other)


@pytest.mark.parametrize("factors", [TOUCH, AVERTED, WATCHED, NOTHING])
def test_the_social_rate_falls_with_time_under_all_factors(factors):
    rates = [SocialRate()(0, visits, factors) for visits in range(20)]
    assert all(later < earlier for earlier, later in itertools.pairwise(rates))


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda: ConstantRate(alpha=1.5), "alpha"),
        (lambda: ConstantRate(alpha=float("nan")), "alpha"),
        (lambda: SynchronousRate(exponent=0.5), r"\(1/2, 1\]"),
        (lambda: AsynchronousRate(exponent=1.0), r"\(1/2, 1\)"),
        (lambda: SocialRate(reward=-0.1), "reward"),
        (lambda: SocialRate(center=0.9), "smallest exponent"),
    ],
)
def test_a_rate_out_of_range_is_refused(make, reason):
    with pytest.raises(ParameterError, match=reason):
        make()
