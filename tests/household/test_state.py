"""State: what is put back in place, and what is replaced."""

import pickle
from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Indices
from household.state import Stateful, put_back, state_of


class Pair(NamedTuple):
    """Two arrays that belong together."""

    numbers: Floats
    places: Indices


class Holder(Stateful):
    """Holds a record."""

    STATE = ("pair",)

    def __init__(self):
        self.pair = Pair(np.zeros(2), np.arange(2))


def test_a_record_of_arrays_is_put_back_in_place():
    holder = Holder()
    kept, arrays = pickle.loads(pickle.dumps(state_of(holder))), holder.pair
    holder.pair.numbers[:], holder.pair.places[0] = 3.0, 7
    put_back(holder, kept)
    assert holder.pair is arrays
    assert [array.tolist() for array in arrays] == [[0.0, 0.0], [0, 1]]


def test_a_record_whose_arrays_have_grown_since_is_replaced_by_one_of_its_kind():
    holder = Holder()
    kept = pickle.loads(pickle.dumps(state_of(holder)))
    holder.pair = Pair(np.ones(5), np.arange(2) + 4)
    put_back(holder, kept)
    assert isinstance(holder.pair, Pair)
    assert [array.tolist() for array in holder.pair] == [[0.0, 0.0], [0, 1]]
