import math

import pytest

from learners.errors import ParameterError
from learners.exploration import (
    EpsilonGreedy,
    Estimates,
    Greedy,
    Softmax,
    Thompson,
    UpperConfidence,
    draw,
    softmax,
)


class Coin:
    """A generator whose draws are written down."""

    def __init__(self, *points):
        self.points = list(points)

    def random(self):
        return self.points.pop(0)


def counted(rule, estimates, rng, n=4000):
    chosen = [rule.choose(estimates, rng) for _ in range(n)]
    return [chosen.count(behavior) / n for behavior in range(len(estimates.values))]


def test_greed_takes_the_best(rng):
    assert Greedy().choose(Estimates([0.1, 0.7, 0.2], [1, 1, 1]), rng) == 1


def test_greed_breaks_ties_at_random(rng):
    shares = counted(Greedy(), Estimates([0.7, 0.1, 0.7], [1, 1, 1]), rng)
    assert shares[1] == 0.0
    assert shares[0] == pytest.approx(0.5, abs=0.05)


def test_epsilon_of_the_choices_are_any_behavior(rng):
    estimates = Estimates([1.0, 0.0], [1, 1])
    shares = counted(EpsilonGreedy(epsilon=0.3), estimates, rng)
    assert shares[1] == pytest.approx(0.15, abs=0.03)


def test_boltzmann_probabilities_worked_by_hand():
    # exp(1/0.5) : exp(0) = 7.389 : 1
    assert softmax([1.0, 0.0], 0.5) == pytest.approx(
        [7.389 / 8.389, 1 / 8.389], rel=1e-4
    )


def test_softmax_survives_large_values():
    assert softmax([1e6, 0.0], 0.1) == [1.0, 0.0]


def test_softmax_chooses_by_its_probabilities(rng):
    shares = counted(Softmax(temperature=0.5), Estimates([1.0, 0.0], [1, 1]), rng)
    assert shares[0] == pytest.approx(7.389 / 8.389, abs=0.03)


@pytest.mark.parametrize(
    ("point", "index"), [(0.0, 0), (0.19, 0), (0.21, 2), (0.99, 2)]
)
def test_a_draw_never_takes_what_cannot_happen(point, index):
    assert draw([0.2, 0.0, 0.8, 0.0], Coin(point)) == index


def test_a_draw_survives_probabilities_that_sum_to_a_hair_under_one():
    assert draw([0.5, 0.5 - 1e-9, 0.0], Coin(1.0 - 1e-12)) == 1


def test_what_was_never_tried_has_no_upper_bound(rng):
    assert UpperConfidence().choose(Estimates([0.9, -1.0], [5, 0]), rng) == 1


def test_the_upper_bound_worked_by_hand(rng):
    # ln(1 + 20) = 3.045; widths sqrt(3.045 / 18) = 0.411 and sqrt(3.045 / 2) = 1.234
    estimates = Estimates([0.8, 0.0], [18, 2])
    assert UpperConfidence(width=0.98).choose(estimates, rng) == 1  # 1.203 < 1.209
    assert UpperConfidence(width=0.96).choose(estimates, rng) == 0  # 1.195 > 1.185


def test_thompson_sampling_chooses_by_the_probability_of_being_best(rng):
    estimates = Estimates([1.0, 0.0], [1, 1], [0.6, 0.8])
    # difference ~ N(1, 1): the first is best with probability Phi(1) = 0.841
    shares = counted(Thompson(), estimates, rng)
    assert shares[0] == pytest.approx(0.841, abs=0.03)


@pytest.mark.parametrize(
    "make",
    [
        lambda: EpsilonGreedy(epsilon=1.1),
        lambda: Softmax(temperature=0.0),
        lambda: UpperConfidence(width=-math.inf),
    ],
)
def test_a_rule_of_exploration_out_of_range_is_refused(make):
    with pytest.raises(ParameterError):
        make()
