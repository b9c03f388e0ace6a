"""Colors of pictures and replays, chosen for the color-blind as well."""

from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Singles
from household.compiled.jit import compiled

Bytes = NDArray[np.uint8]

ACTIVITY_COLORS = MappingProxyType(
    {
        Activity.WORKING: "#0072b2",
        Activity.READING: "#009e73",
        Activity.SLEEPING: "#6a51a3",
        Activity.PLAYING: "#d55e00",
        Activity.ENTERING: "#666666",
        Activity.CALLING: "#c2438d",
        Activity.UNKNOWN: "#aaaaaa",
    }
)
"""Dark enough for text (after Okabe and Ito)."""

ACTIVITIES = [ACTIVITY_COLORS[activity] for activity in Activity]
"""The same in the order of the activities' values."""

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
"""Of robots' behaviors in the order of their indices, repeated if there are more; the
first are those of Okabe and Ito."""

CARESS, TAP = "#1a9850", "#d73027"
BELIEVED, TRUE = "#ffb000", "#3ddc84"
"""Of lines from a touch to what a learner believes it to be about, and to what it is
really about."""

IDLE = "#777777"


def rgb(color: str) -> tuple[int, int, int]:
    """Red, green and blue of a color such as "#0072b2", each 0 to 255."""
    value = int(color.removeprefix("#"), 16)
    return value >> 16, value >> 8 & 255, value & 255


def behavior_color(behavior: int) -> str:
    """The color of a behavior, or of none (-1)."""
    return IDLE if behavior < 0 else BEHAVIORS[behavior % len(BEHAVIORS)]


def packed(colors: list[str], alpha: int = 255) -> NDArray[np.uint32]:
    """Colors as Rerun packs them, 0xRRGGBBAA."""
    return np.array(
        [int(c.removeprefix("#"), 16) << 8 | alpha for c in colors], dtype=np.uint32
    )


STOPS = np.array([0.0, 0.3, 0.7, 1.0])
HEAT = np.array([[240, 241, 245], [107, 174, 214], [8, 81, 156], [3, 19, 43.0]])
"""Shares, and their colors from nearly white over blue to nearly black."""


@compiled
def heat(values: Singles) -> Bytes:
    """Shares in [0, 1] as colors, interpolated linearly between `STOPS`.

    Args:
        values: Shape (n_moments, n, n).

    Returns:
        Shape (n_moments, n, n, 3): red, green and blue, 0 to 255.
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
