import numpy as np
import pytest

from learners.errors import ParameterError
from learners.tabular.qtable import QTable


def test_an_update_moves_a_value_and_counts_its_visit():
    table = QTable(n_behaviors=2)
    row = table.add("s")
    row.move(1, target=1.0, step=0.25, visits=1.0)
    row.move(1, target=1.0, step=0.5, visits=0.5)
    assert table.values("s") == [0.0, 0.625]
    assert table.visits("s") == [0.0, 1.5]


def test_reading_changes_nothing():
    table = QTable(n_behaviors=2, initial=0.3)
    table.array("s")[0] = 9.0
    assert table.values("s") == [0.3, 0.3]
    assert table.visits("s") == [0.0, 0.0]
    assert (len(table), table.updates) == (0, 0)


def test_an_array_of_values_is_a_copy():
    table = QTable(n_behaviors=2)
    table.add("s").move(0, target=1.0, step=1.0, visits=1.0)
    table.array("s")[0] = 9.0
    np.testing.assert_array_equal(table.array("s"), [1.0, 0.0])


def test_a_table_without_behaviors_is_refused():
    with pytest.raises(ParameterError, match="n_behaviors"):
        QTable(n_behaviors=0)
