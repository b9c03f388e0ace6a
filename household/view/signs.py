"""Signs: what people do as small line drawings, the same in replays and pictures."""

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats

POINTS = 8
"""Points of every sign; the last one is repeated where fewer suffice."""

STROKES: dict[Activity, tuple[tuple[float, float], ...]] = {
    # A screen on its foot.
    Activity.WORKING: (
        (0, -0.5), (0, -0.2), (0.55, -0.2), (0.55, 0.5), (-0.55, 0.5), (-0.55, -0.2),
        (0, -0.2),
    ),
    # An open book.
    Activity.READING: (
        (0, -0.4), (-0.6, -0.2), (-0.6, 0.45), (0, 0.25), (0.6, 0.45), (0.6, -0.2),
        (0, -0.4), (0, 0.25),
    ),
    # A Z.
    Activity.SLEEPING: ((-0.4, 0.45), (0.4, 0.45), (-0.4, -0.45), (0.4, -0.45)),
    # A kite.
    Activity.PLAYING: (
        (0, -0.6), (-0.4, 0.1), (0, 0.55), (0.4, 0.1), (0, -0.6), (0, 0.55),
    ),
    # An arrow through a door.
    Activity.ENTERING: (
        (-0.6, 0), (0.1, 0), (-0.2, 0.3), (0.1, 0), (-0.2, -0.3), (0.1, 0), (0.5, 0.55),
        (0.5, -0.55),
    ),
    # A receiver.
    Activity.CALLING: (
        (-0.55, 0.0), (-0.55, 0.35), (-0.25, 0.5), (0.25, 0.5), (0.55, 0.35),
        (0.55, 0.0),
    ),
    # A dash: on the way.
    Activity.UNKNOWN: ((-0.25, 0.0), (0.25, 0.0)),
}  # fmt: skip
"""The lines of each sign, y up, in a circle of radius 1."""


def _padded(points: tuple[tuple[float, float], ...]) -> list[tuple[float, float]]:
    return [*points, *(POINTS - len(points)) * points[-1:]]


SIGNS: Floats = np.array([_padded(STROKES[each]) for each in Activity], np.float64)
"""The same in the order of the activities' values, shape (n_activities, POINTS, 2)."""
