"""Arrays that lie side by side in memory."""

import numpy as np
import pytest

from household.compiled.arrays import SideBySide


def test_a_copy_of_the_memory_holds_what_all_arrays_held():
    memory = SideBySide(200)
    marks = memory.zeros((3,), np.bool_)
    numbers = memory.zeros((2, 4))
    marks[1], numbers[:] = True, np.arange(8.0).reshape(2, 4)
    copy = memory.bytes.copy()
    marks[:], numbers[:] = False, 0.0
    for array, held in ((marks, [0, 1, 0]), (numbers, range(8))):
        begin = memory.begin_of(array)
        part = copy[begin : begin + array.nbytes].view(array.dtype)
        assert part.tolist() == list(held)
    assert numbers.flags.aligned
    assert numbers.flags.c_contiguous


def test_memory_that_is_full_says_so():
    memory = SideBySide(16)
    memory.zeros((2,))
    with pytest.raises(ValueError, match="no room"):
        memory.zeros((1,))
