import numpy as np
import pytest

from experiments.bench import updates
from learners.analogy.carrying import Propagation
from learners.representation.states import is_state


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    monkeypatch.setattr(updates, "UPDATES", 20)
    monkeypatch.setattr(updates, "SWEEPS", 1)


def test_a_crowd_is_a_state_whose_canonical_form_stands_for_its_closure():
    for state in updates.crowds(3, 20, np.random.default_rng(1)):
        assert is_state(state)
        closure = {analog for analog, _ in Propagation(depth=2).spread(state)}
        assert {analog.canonical() for analog in closure} == {state.canonical()}
        assert len(state.without("e01").entities) == 2


def test_the_table_has_a_row_per_number_of_actors_and_a_column_per_analogy():
    rows = [line.split("|")[1:-1] for line in updates.table((1, 5)).splitlines()]
    assert [cell.strip() for cell in rows[0]] == ["actors", *updates.ANALOGIES]
    assert [row[0].strip() for row in rows[2:]] == ["1", "5"]
    assert rows[3][3].strip() == "-"  # 5! analogs of everything: left out
    assert all("/" in cell for cell in rows[2][1:])
