"""Approach: who visibly walks towards a robot."""

import math

import numpy as np

from household.compiled.arrays import Floats, Mask

ASIDE = math.radians(30.0)
"""How far off the straight way a walker may face and still be seen coming [rad]. People
go around tables and each other; who comes through a door to the side is not seen coming
before that (our choice)."""


def faces(heading: Floats, way: Floats) -> Mask:
    """Whether each body faces where its way leads.

    Args:
        heading: Where each faces, shape (n,) [rad].
        way: From each to the place, shape (n, 2) [m].

    Returns:
        Shape (n,).
    """
    # Not NumPy's cosine, which rounds otherwise on other processors.
    ahead = [
        math.cos(angle) * x + math.sin(angle) * y
        for angle, (x, y) in zip(heading.tolist(), way.tolist(), strict=True)
    ]
    result: Mask = np.array(ahead) >= math.cos(ASIDE) * np.hypot(way[:, 0], way[:, 1])
    return result
