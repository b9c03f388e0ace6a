"""Colors of replays and renderings; told apart by the color-blind."""

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Singles
from household.compiled.jit import compiled
from household.view.floorplan_svg import ACTIVITY_COLORS

Bytes = NDArray[np.uint8]

BEHAVIORS = (
    "#e69f00",
    "#56b4e9",
    "#cc79a7",
    "#f0e442",
    "#00b28a",
    "#d55e00",
    "#0072b2",
    "#9a9a9a",
    "#8c564b",
    "#a6d854",
    "#8da0cb",
    "#b3589a",
)
"""Of a robot's behaviors, in the order of its actions, over and over; the first are
those of Okabe and Ito."""

CARESS, TAP = "#1a9850", "#d73027"
BELIEVED, TRUE = "#ffb000", "#3ddc84"
"""Of the line from a touch to what a learner believes that it is about, and to what
it is really about."""

IDLE = "#777777"


def rgb(color: str) -> tuple[int, int, int]:
    """Red, green and blue of a color such as "#0072b2", each 0 to 255."""
    value = int(color.removeprefix("#"), 16)
    return value >> 16, value >> 8 & 255, value & 255


def behavior_color(behavior: int) -> str:
    """The color of a behavior; -1 is none."""
    return IDLE if behavior < 0 else BEHAVIORS[behavior % len(BEHAVIORS)]


def packed(colors: list[str], alpha: int = 255) -> NDArray[np.uint32]:
    """Colors as Rerun packs them, 0xRRGGBBAA."""
    return np.array(
        [int(c.removeprefix("#"), 16) << 8 | alpha for c in colors], dtype=np.uint32
    )


ACTIVITIES = [ACTIVITY_COLORS[activity] for activity in Activity]


STOPS = np.array([0.0, 0.3, 0.7, 1.0])
HEAT = np.array([[240, 241, 245], [107, 174, 214], [8, 81, 156], [3, 19, 43.0]])
"""Shares, and their colors from nearly white over blue to nearly black."""


@compiled
def heat(values: Singles) -> Bytes:
    """Shares in [0, 1] as colors; those between two stops are in proportion.

    Args:
        values: Shape (n_moments, n, n).

    Returns:
        The same shape with three more for red, green and blue.
    """
    moments, n, m = values.shape
    colors = np.empty((moments, n, m, 3), np.uint8)
    for t in range(moments):
        for i in range(n):
            for j in range(m):
                share = min(max(values[t, i, j], 0.0), 1.0)
                k = 0
                while k < len(STOPS) - 2 and share >= STOPS[k + 1]:
                    k += 1
                part, width = share - STOPS[k], STOPS[k + 1] - STOPS[k]
                for c in range(3):
                    rise = (HEAT[k + 1, c] - HEAT[k, c]) / width
                    colors[t, i, j, c] = int(rise * part + HEAT[k, c])
    return colors
