"""Kinds of arrays, by what they hold."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

Indices = NDArray[np.intp]

Mask = NDArray[np.bool_]

NOBODY = -1
"""In an array of indices: none of them."""
