import pytest

from learners.errors import ParameterError
from learners.pooling import FullPooling, HierarchicalPooling, NoPooling


def test_without_pooling_nobody_is_drawn_to_anybody():
    assert NoPooling().terms(0.0, "ann") == (0.0, 0.0)
    assert NoPooling().terms(3.0, "ann")[0] == 0.0


def test_with_full_pooling_all_are_one_and_weigh_by_observations():
    assert FullPooling().terms(0.0, "ann") == (1.0, 0.0)
    assert FullPooling().terms(3.0, "ann") == (1.0, 3.0)


def test_the_hierarchical_terms_worked_by_hand():
    pooling = HierarchicalPooling(population=0.5, person=1.0, touch=2.0)
    # own precision 1 + 3 / 4; the mean of three has a variance of 1 + 4 / 3 around
    # the population's
    assert pooling.terms(3.0, "ann") == pytest.approx((1 / 1.75, 1 / (1 + 4 / 3)))
    assert pooling.prior == 4.0


def test_a_stranger_is_read_off_the_population_alone():
    assert HierarchicalPooling().terms(0.0, "eve") == (1.0, 0.0)


def test_the_more_is_known_of_a_person_the_less_it_is_drawn():
    pooling = HierarchicalPooling()
    pulls = [pooling.terms(n, "ann")[0] for n in (0.0, 0.5, 1.0, 10.0, 1000.0)]
    assert pulls == sorted(pulls, reverse=True)
    assert pulls[-1] < 0.01


def test_people_who_hardly_differ_are_nearly_one():
    assert HierarchicalPooling(person=1e-3).terms(10.0, "ann")[0] > 0.999


@pytest.mark.parametrize(
    "make",
    [
        lambda: HierarchicalPooling(person=0.0),
        lambda: HierarchicalPooling(population=-1.0),
        lambda: HierarchicalPooling(touch=float("nan")),
        lambda: FullPooling(prior=-1.0),
    ],
)
def test_a_pooling_out_of_range_is_refused(make):
    with pytest.raises(ParameterError):
        make()
