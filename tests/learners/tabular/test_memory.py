import numpy as np
import pytest

from learners.pooling import AdaptivePooling, HierarchicalPooling, NoPooling
from learners.representation import Named, Views
from learners.tabular import memory as module
from learners.tabular.memory import Memory, remember
from learners.tabular.qtable import QTable


@pytest.fixture
def memory():
    def make(representation=None, pooling=None):
        return Memory(
            QTable(n_behaviors=2), representation or Views(), pooling or NoPooling()
        )

    return make


def test_reading_adds_no_rows(memory, toy):
    for each in (memory(), memory(Named())):
        state = toy("ann reads, bob calls")
        each.values(state), each.visits(state), each.seen(state)
        assert len(each.table) == 0


def test_what_was_read_before_it_was_written_is_read_anew(memory, toy):
    each, state = memory(Named()), toy("ann reads")
    before = each.seen(state)
    (cell,) = before.cells
    each.move(cell, 0, 1.0, 0.5, 1.0)
    assert each.seen(state) is before
    assert list(each.values(state)) == [0.5, 0.0]


def test_a_memory_made_anew_from_its_table_reads_the_same(memory, toy):
    pooling, rng = HierarchicalPooling(), np.random.default_rng(0)
    first = memory(pooling=pooling)
    states = [
        toy("ann reads, bob calls"),
        toy("bob reads, ann calls", "ann robot"),
        toy("eve reads, ann reads", "eve robot"),
    ]
    for step in range(40):
        for cell in first.seen(states[step % 3]).cells:
            first.move(cell, step % 2, float(rng.normal()), 0.3, 1.0)
    again = Memory(first.table, Views(), pooling)
    for state in (*states, toy("joe reads")):
        assert again.values(state) == first.values(state)
        assert again.deviations(state) == first.deviations(state)


def test_each_person_has_a_part_in_the_value_of_a_behavior(memory, toy):
    each, state = memory(), toy("ann reads, bob calls")
    ann, bob = each.seen(state).cells
    each.move(ann, 0, 1.0, 1.0, 1.0)
    each.move(bob, 0, -0.5, 1.0, 1.0)
    assert each.values(state)[0] == 0.5
    alone = toy("ann reads")
    assert each.parts(alone, 0, (ann, bob)) == [1.0, 0.0]  # bob is not there


def test_visits_are_ones_own_and_others_as_far_as_one_is_pulled(memory, toy):
    each = memory(pooling=HierarchicalPooling())
    ann, stranger = toy("ann reads"), toy("eve reads")
    (cell,) = each.seen(ann).cells
    each.move(cell, 0, 1.0, 1.0, 4.0)
    assert each.visits(ann) == [4.0, 0.0]
    assert each.visits(stranger) == [4.0, 0.0]


def test_comparing_tells_an_adaptive_pooling_alone(memory, toy):
    pooling = AdaptivePooling()
    each = memory(pooling=pooling)
    (ann,) = each.seen(toy("ann reads")).cells
    each.compare(ann, 0, 1.0, 1.0)
    assert pooling.revision == 0  # there is nobody to compare with
    (bob,) = each.seen(toy("bob reads")).cells
    each.move(bob, 0, 1.0, 1.0, 1.0)
    each.compare(ann, 0, 1.0, 1.0)
    assert pooling.revision == 1
    assert pooling.trust_in("ann") > 0.5


def test_what_is_remembered_of_states_is_bounded(memory, toy, monkeypatch):
    memo = {}
    for state in range(10):
        remember(memo, state, state, most=4)
        assert memo[state] == state
        assert len(memo) <= 4
    monkeypatch.setattr(module, "MEMO_SIZE", 4)
    each = memory()
    for k in range(20):
        (cell,) = each.seen(toy(f"p{k} reads")).cells
        if k % 2:
            each.move(cell, 0, 1.0, 1.0, 1.0)
    assert len(each.table) == 10
    assert [each.values(toy(f"p{k} reads"))[0] for k in range(4)] == [0, 1, 0, 1]
