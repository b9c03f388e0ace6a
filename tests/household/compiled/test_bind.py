"""Bound functions: what they take, fixed or given, and what checked mode finds."""

import os
import subprocess
import sys
from functools import partial
from typing import Annotated, NamedTuple

import numpy as np
import pytest

from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import CHECKED, bind, compiled


class Points(NamedTuple):
    """Where some are, and who of them counts."""

    position: Annotated[Floats, "n", 2]
    counts: Annotated[Mask, "n"]


class Masses(NamedTuple):
    """As many arrays as `Points`, of other kinds."""

    mass: Annotated[Floats, "n"]
    who: Annotated[Indices, "n"]


@compiled
def _middle(points: Points, masses: Masses, axis: int, scale: float) -> float:
    total, weight = 0.0, 0.0
    for i in range(len(points.position)):
        if points.counts[i]:
            total += masses.mass[masses.who[i]] * points.position[i, axis]
            weight += masses.mass[masses.who[i]]
    return scale * total / weight


@compiled
def _total(values: Annotated[Floats, "n"]) -> float:
    return values.sum()


@compiled
def _ends(pair: tuple[float, float]) -> float:
    return pair[0] + pair[1]


def some_points(n=3):
    return Points(np.arange(2.0 * n).reshape(n, 2), np.ones(n, np.bool_))


def some_masses(n=3):
    return Masses(np.arange(1.0, n + 1), np.arange(n))


def test_records_are_fixed_or_given_like_single_arrays():
    points, masses = some_points(), some_masses()
    known = bind(_middle, points, masses)
    given = bind(_middle)
    some_known = bind(_middle, points)
    assert known(1, 2.0) == given(points, masses, 1, 2.0) == some_known(masses, 1, 2.0)
    # (1 * 1 + 2 * 3 + 3 * 5) / (1 + 2 + 3), twice.
    assert known(1, 2.0) == pytest.approx(2 * 22 / 6)
    points.counts[2] = False
    assert known(1, 2.0) == pytest.approx(2 * 7 / 3)


def test_arrays_with_gaps_are_taken_too():
    n, given = 3, bind(_middle)
    wide = np.zeros((n, 4))
    wide[:, ::2] = some_points().position
    points = Points(wide[:, ::2], np.ones(2 * n, np.bool_)[::2])
    assert given(points, some_masses(), 1, 1.0) == pytest.approx(22 / 6)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        (
            {"mass": np.ones(3, np.float32)},
            r"masses.mass: expected array\(float64, 1d, A\), got array\(float32, 1d, C",
        ),
        # Items of the same size: Numba would read ones as tiny numbers.
        ({"mass": np.ones(3, np.int64)}, r"masses.mass: expected array\(float64"),
        ({"who": np.arange(3.0)}, r"masses.who: expected array\(int64"),
        (
            {"mass": np.ones((3, 1))},
            r"masses.mass: expected .*1d, A\), got array\(float64, 2d, C\)",
        ),
        ({"mass": np.ones(2)}, r"masses.mass: expected shape \(3,\), got shape \(2,\)"),
        ({"mass": [1.0, 2.0, 3.0]}, r"masses.mass: expected array"),
    ],
)
def test_checked_mode_names_the_argument_that_is_wrong(changed, message):
    given = bind(_middle)
    with pytest.raises(TypeError, match=rf"_middle\(\), argument {message}"):
        given(some_points(), some_masses()._replace(**changed), 1, 1.0)


def test_checked_mode_tells_records_with_as_many_arrays_apart():
    with pytest.raises(TypeError, match="masses: expected Masses, got Points"):
        bind(_middle)(some_points(), some_points(), 1, 1.0)
    with pytest.raises(TypeError, match="points: expected Points, got tuple"):
        bind(_middle)(tuple(some_points()), some_masses(), 1, 1.0)


def test_checked_mode_looks_at_the_first_arguments_when_they_are_fixed():
    with pytest.raises(TypeError, match=r"masses.mass: expected shape \(3,\)"):
        bind(_middle, some_points(3), some_masses(4))


def test_checked_mode_finds_arrays_that_may_not_be_written_or_lie_otherwise():
    total, values = bind(_total), np.arange(3.0)
    assert total(values) == 3.0
    with pytest.raises(TypeError, match=r"got array\(float64, 1d, A\), not aligned"):
        total(np.zeros(3, [("first", np.bool_), ("then", np.float64)])["then"])
    with pytest.raises(TypeError, match=r"argument values: expected .*, got >f8"):
        total(values.astype(">f8"))
    values.flags.writeable = False
    with pytest.raises(TypeError, match="got readonly array"):
        total(values)


def test_checked_mode_counts_the_items_of_tuples():
    ends = bind(_ends)
    assert ends((1.0, 2.0)) == 3.0
    with pytest.raises(TypeError, match="argument pair: expected 2 items, got 3"):
        ends((1.0, 2.0, 3.0))
    with pytest.raises(TypeError, match=r"argument pair\[1\]: expected float64, got"):
        ends((1.0, None))


@pytest.mark.parametrize(
    ("axis", "scale", "name"), [(0.5, 1.0, "axis"), (0, "much", "scale")]
)
def test_checked_mode_finds_wrong_numbers(axis, scale, name):
    with pytest.raises(TypeError, match=f"argument {name}: expected"):
        bind(_middle)(some_points(), some_masses(), axis, scale)


def test_a_function_that_does_not_say_what_it_takes_is_not_bound():
    @compiled
    def first(values: Floats) -> float:
        return values[0]

    with pytest.raises(TypeError, match="no number, record or array with a shape"):
        bind(first)


def test_unchecked_functions_are_called_directly(monkeypatch):
    monkeypatch.setenv(CHECKED, "0")
    taken = bind(_middle, some_points())
    assert type(taken) is partial
    assert taken(some_masses(), 1, 1.0) == pytest.approx(22 / 6)


def test_checks_are_the_same_where_numba_is_switched_off():
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", __file__, "-k", "not switched_off"],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout
