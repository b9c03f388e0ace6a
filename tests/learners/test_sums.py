"""Sums are the same in every version of Python."""

from learners.sums import added


def test_a_sum_is_added_up_one_by_one():
    """From Python 3.12 on `sum` gives 1 here, and gave 0 before."""
    assert added([1e100, 1.0, -1e100]) == 0.0
    assert added([0.1] * 10) == 0.9999999999999999
    assert added([]) == 0.0
