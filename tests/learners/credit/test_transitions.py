import pytest

from learners.credit.transitions import SituationNetwork


@pytest.fixture
def network():
    network = SituationNetwork()
    for following in ("b", "b", "c", "b"):
        network.count("a", 0, following)
    return network


def test_a_probability_is_the_share_of_the_counts(network):
    assert network.probability("b", "a", 0) == 0.75
    assert network.probability("c", "a", 0) == 0.25


def test_what_was_never_seen_has_probability_zero(network):
    assert network.probability("d", "a", 0) == 0.0
    assert network.probability("b", "a", 1) == 0.0


def test_asking_for_a_probability_counts_nothing(network):
    network.probability("b", "z", 0)
    assert set(network.counts) == {("a", 0)}
