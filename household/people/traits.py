"""The constants of personas as a table, for compiled loops over people."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from household.people.persona import Persona

Traits = Any
"""A structured array with a row for each person; rows have a persona's constants under
their own names, as in ``traits[i].praise``. Numba knows its type, type checkers not."""


def traits_of(personas: Sequence[Persona]) -> Traits:
    """Everything about personas that is a number or true or false, shape (n,)."""
    kinds = {float: np.float64, bool: np.bool_}
    names = [
        (name, kinds[type(value)])
        for name in Persona.__struct_fields__
        if type(value := getattr(Persona(name=""), name)) in kinds
    ]
    rows = [tuple(getattr(each, name) for name, _ in names) for each in personas]
    return np.array(rows, dtype=names)
