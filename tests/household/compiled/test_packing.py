"""Packing: what is in a block comes out of it as it was, and only from its own."""

import copy
import gc
from typing import Annotated, NamedTuple

import numpy as np
import pytest
from numba import typeof

from household.compiled.arrays import Floats, Mask
from household.compiled.jit import bind, compiled
from household.compiled.packing import layout_of


class Weights(NamedTuple):
    """Numbers of all kinds beside an array."""

    each: Annotated[Floats, "n"]
    offset: float
    last: int
    doubled: bool


@compiled
def _weighted(
    table: Annotated[Floats, "n", 2],
    nested: tuple[Weights, tuple[Mask, float]],
    column: int,
    scale: float,
) -> float:
    weights, (counts, factor) = nested
    total = 0.0
    for i in range(weights.last + 1):
        if counts[i]:
            total += weights.each[i] * table[i, column]
    return scale * factor * (total * (2.0 if weights.doubled else 1.0) + weights.offset)


@compiled
def _fill(values: Annotated[Floats, "n"], value: float) -> None:
    values[:] = value


@compiled
def _nothing_given(values: Annotated[Floats, "n"], index: int) -> float:
    return values[index]


def a_table():
    return np.arange(6.0).reshape(3, 2)


def some_weights(**changes):
    usual = Weights(np.array([1.0, 10.0, 100.0]), -0.5, 1, doubled=True)
    return usual._replace(**changes), (np.array([True, True, False]), 0.25)


def test_arrays_numbers_and_records_within_tuples_come_out_as_they_were():
    weighted = bind(_weighted, a_table(), some_weights())
    # (1 * 1 + 10 * 3) * 2 - 0.5, a quarter of it, four times.
    assert weighted(1, 4.0) == 61.5
    plain = bind(
        _weighted, a_table(), some_weights(doubled=False, offset=np.float64(0))
    )
    assert plain(0, 4.0) == 20.0


def test_arrays_with_gaps_and_transposed_ones_keep_their_strides():
    usual = bind(_weighted, a_table(), some_weights())
    wide, columns = np.full((3, 5), np.nan), np.asfortranarray(a_table())
    wide[:, 1::3] = a_table()
    for table in (
        wide[:, 1::3],
        columns,
        columns.T.copy().T,
        a_table()[::-1].copy()[::-1],
    ):
        other = bind(_weighted, table, some_weights())
        assert [other(k, 1.0) for k in (0, 1)] == [usual(k, 1.0) for k in (0, 1)]


def test_compiled_functions_write_into_the_very_arrays_that_are_fixed():
    values = np.zeros(4)
    bind(_fill, values[1:3])(7.0)
    assert values.tolist() == [0.0, 7.0, 7.0, 0.0]


def test_nothing_needs_to_be_given_when_all_is_fixed():
    assert bind(_nothing_given, np.arange(3.0), 2)() == 2.0


def test_fixed_arrays_live_as_long_as_the_function():
    first = bind(_nothing_given, np.full(10**6, 3.0))
    gc.collect()
    np.full(10**6, 5.0)  # Would lie where the other one was.
    assert first(999_999) == 3.0


def test_a_bound_function_cannot_be_copied_as_it_would_share_arrays_unseen(monkeypatch):
    monkeypatch.setenv("HOUSEHOLD_CHECKED", "0")
    with pytest.raises(TypeError, match="memoryview"):
        copy.deepcopy(bind(_fill, np.zeros(2)))


def test_what_is_of_one_layout_is_of_one_type_for_numba():
    table = np.zeros((3, 4))
    fixed = table.copy()
    fixed.setflags(write=False)
    values = (
        1,
        1.0,
        True,
        table,
        table + 1.0,
        table.T,
        table[:, ::2],
        fixed,
        table[0],
        table.astype(np.float32),
        table.astype(bool),
        Weights(np.ones(2), 0.5, 1, doubled=True),
        Weights(np.ones(5), 1.5, 2, doubled=False),
        (np.ones(2), 0.5, 1, True),
        (table, (table, 1.0)),
        (table, (table.T, 1.0)),
        (table, table, 1.0),
    )
    for one in values:
        for other in values:
            same = layout_of(one) == layout_of(other)
            assert same == (typeof(one) == typeof(other)), (one, other)
