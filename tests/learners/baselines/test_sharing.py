import pytest

from learners.baselines.full_sharing import FullSharing
from learners.baselines.hierarchical_thompson import HierarchicalThompson
from learners.baselines.no_sharing import NoSharing
from learners.errors import StateError
from learners.pooling.rules import HierarchicalPooling
from learners.representation.views import Views


@pytest.fixture
def told(toy, entry, touch):
    """Lets a learner hear: bob calls and taps twice, ann calls and caresses once."""

    def tell(learner):
        phone = toy("ann reads, bob calls")
        swapped = phone.swapped("ann", "bob")
        tap = {"value": -1.0, "giver": "bob"}
        learner.learn(entry(phone, 0, 0.0, touch(time=1.0, **tap)))
        learner.learn(entry(phone, 0, 1.0, touch(time=2.0, **tap)))
        learner.learn(entry(swapped, 0, 2.0, touch(time=3.0, giver="ann")))
        return learner, phone, swapped

    return tell


def test_without_sharing_each_person_is_heard_alone(told, rng):
    learner, phone, swapped = told(NoSharing(2, rng))
    assert learner.q_values(phone).tolist() == [-1.0, 0.0]
    assert learner.q_values(swapped).tolist() == [1.0, 0.0]


def test_with_full_sharing_all_in_one_place_are_one_person(told, rng):
    learner, phone, swapped = told(FullSharing(2, rng))
    for state in (phone, swapped):
        assert learner.q_values(state) == pytest.approx([-1 / 3, 0.0])


def test_opinions_of_all_in_the_situation_add_up(told, rng, entry, touch):
    learner, phone, _ = told(NoSharing(2, rng))
    learner.learn(entry(phone, 0, 3.0, touch(value=0.5, time=4.0, giver="ann")))
    assert learner.q_values(phone).tolist() == [-0.5, 0.0]  # bob -1, the reader +0.5


def test_a_touch_by_somebody_who_is_not_there_has_no_place(told, rng, entry, touch):
    learner, phone, _ = told(NoSharing(2, rng))
    learner.learn(entry(phone, 1, 3.0, touch(value=0.5, time=4.0, giver="guest")))
    assert learner.q_values(phone).tolist() == [-1.0, 0.0]


def test_the_hierarchical_posterior_worked_by_hand(told, rng):
    pooling = HierarchicalPooling(population=1.0, person=1.0, touch=1.0)
    learner, phone, _ = told(HierarchicalThompson(2, rng, pooling=pooling))
    # bob: 2 touches, weight 1 / (1 + 1/2) = 2/3; ann: 1 touch, 1 / (1 + 1) = 1/2
    # precision of the mean 1 + 2/3 + 1/2 = 13/6; mean (-2/3 + 1/2) / (13/6) = -1/13
    # own precision 1 + 2 = 3: 2/3 of the own mean, 1/3 of the common one
    assert learner.q_values(phone)[0] == pytest.approx(-2 / 3 - 1 / 39)
    bob = 1 / 3 + 1 / 9 * 6 / 13
    # the reader has never been heard: a mean of 0 and a variance of 2 beside bob's
    assert learner.estimates(phone).deviations[0] == pytest.approx((bob + 2.0) ** 0.5)


def test_a_stranger_starts_from_the_population(told, toy, rng):
    learner = HierarchicalThompson(
        2,
        rng,
        representation=Views(),
        pooling=HierarchicalPooling(population=1.0, person=1.0, touch=1.0),
    )
    told(learner)
    stranger = toy("eve calls")
    # the population's mean as above; its variance 6 / 13, and 1 of people around it
    assert learner.q_values(stranger) == pytest.approx([-1 / 13, 0.0])
    deviations = learner.estimates(stranger).deviations
    assert deviations == pytest.approx([(1 + 6 / 13) ** 0.5, 2.0**0.5])


def test_learners_by_person_need_states_with_people(rng):
    with pytest.raises(StateError, match="str lacks entities"):
        NoSharing(2, rng).act("no people")
