import pytest

from learners.analogy.operators import RemoveEntity, SwapRoles
from learners.errors import ParameterError


@pytest.fixture
def three(toy):
    return toy("ann reads, bob calls, eve plays", "bob robot")


def test_swapping_roles_takes_attention_along(toy):
    state = toy("ann reads, bob calls", "bob robot")
    assert list(SwapRoles()(state)) == [toy("ann calls, bob reads", "ann robot")]


def test_swaps_are_listed_for_every_two_entities(three):
    assert len(set(SwapRoles()(three))) == 3


def test_removing_an_entity_leaves_fewer_relations(toy, three):
    assert list(RemoveEntity()(three)) == [
        toy("bob calls, eve plays", "bob robot"),
        toy("ann reads, eve plays"),
        toy("ann reads, bob calls", "bob robot"),
    ]


def test_the_last_entity_is_not_removed(toy):
    assert list(RemoveEntity()(toy("ann reads"))) == []
    assert len(list(RemoveEntity(keep=0)(toy("ann reads")))) == 1


def test_fewer_entities_than_none_cannot_be_kept():
    with pytest.raises(ParameterError):
        RemoveEntity(keep=-1)
