"""The constants of personas as a table, for compiled loops over people."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from household.scenario.persona import Persona

Traits = NDArray[np.void]
"""A structured array with a row for each person; rows have a persona's constants under
their own names, as in ``traits[i]["praise"]``."""

KINDS = {float: np.float64, bool: np.bool_}


def _columns() -> np.dtype[np.void]:
    usual = Persona(name="")
    kinds = {name: type(getattr(usual, name)) for name in Persona.__struct_fields__}
    return np.dtype([(n, KINDS[kind]) for n, kind in kinds.items() if kind in KINDS])


COLUMNS = _columns()
"""Everything about a persona that is a number or true or false. One object for all
tables: compiled functions take a microsecond longer to recognize an equal one."""


def traits_of(personas: Sequence[Persona]) -> Traits:
    """The constants of these personas, shape (n,)."""
    names = COLUMNS.names or ()
    rows = [tuple(getattr(each, name) for name in names) for each in personas]
    return np.array(rows, dtype=COLUMNS)
