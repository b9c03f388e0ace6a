from itertools import pairwise

import numpy as np
import pytest

from experiments.bench import updates
from experiments.bench.crowds import experiences, walk
from experiments.bench.updates import Composition, Times, memory, table, times
from learners.analogy.carrying import Propagation
from learners.representation import Nameless, Views
from learners.representation.states import is_state


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    monkeypatch.setattr(updates, "UPDATES", 20)
    monkeypatch.setattr(updates, "SWEEPS", 1)


@pytest.fixture
def states():
    return walk(3, 20, np.random.default_rng(1))


def test_a_crowd_is_a_state_whose_canonical_form_stands_for_its_closure(states):
    for state in states:
        assert is_state(state)
        closure = {analog for analog, _ in Propagation(depth=2).spread(state)}
        assert {analog.canonical() for analog in closure} == {state.canonical()}
        assert len({Nameless().parts(analog) for analog in closure}) == 1
        assert len(state.without("e01").entities) == 2
        assert len(Views().parts(state)) == 3


def test_one_actor_at_a_time_changes_its_place(states):
    for before, after in pairwise(states):
        changed = set(before.plays) ^ set(after.plays)
        assert len({name for name, _, _ in changed}) <= 1


def test_touches_come_every_few_entries_and_a_bout_lasts_some(states):
    lived = list(experiences(states, np.random.default_rng(0)))
    assert [bool(e.rewards) for e in lived[:5]] == [True, False, False, False, True]
    assert [e.chosen for e in lived[:4]] == [True, False, True, False]
    assert lived[0].action == lived[1].action


@pytest.mark.parametrize("composition", updates.PEOPLE.values())
def test_time_and_memory_of_every_composition_are_measured(composition):
    found = times(composition, 3, known=True)
    assert min(found.update, found.choice, memory(composition, 3)) > 0.0


def test_the_tables_have_a_row_per_number_of_actors_and_a_column_per_learner(
    monkeypatch,
):
    def measured(composition, n_actors, *, known):
        return Times(update=float(n_actors), choice=0.5)

    monkeypatch.setattr(updates, "times", measured)
    analogies = table(updates.ANALOGIES, (1, 5), updates.known_and_new)
    rows = [
        [c.strip() for c in line.split("|")[1:-1]] for line in analogies.split("\n")
    ]
    assert rows[0] == ["actors", *updates.ANALOGIES]
    assert rows[2] == ["1", *["1.0 / 1.0"] * 5]
    assert rows[3][3] == "-"  # 5! analogs of everything: left out
    people = table(
        {"views": Composition(learner="views")}, (8,), updates.update_and_choice
    )
    assert people.endswith("| 8 | 8.0 / 0.5 |")
