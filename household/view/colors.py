"""Colors of pictures and replays, chosen for the color-blind as well."""

from collections.abc import Sequence
from itertools import cycle
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Singles
from household.compiled.jit import compiled_aside

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
"""Of regions on floor plans; dark enough for text (after Okabe and Ito)."""

BEHAVIOR_COLORS = MappingProxyType(
    {
        "bark": "#d55e00",
        "play": "#0072b2",
        "sleep": "#00795a",
        "say_hello": "#9a4d80",
        "follow": "#56b4e9",
        "vacuum": "#e69f00",
        "fetch": "#6b3410",
        "ask": "#f0e442",
        "retreat": "#a6a6a6",
    }
)
"""Of the shipped behaviors by name, in every scenario, replay, picture and figure;
after Okabe and Ito."""

OTHER_BEHAVIORS = ("#8da0cb", "#66a61e", "#e78ac3", "#4d4d4d", "#a6761d")
"""Of users' own behaviors in the order of their indices, repeated if there are more."""

PEOPLE = (
    "#0f6370",
    "#e28694",
    "#7b37b2",
    "#789853",
    "#eb710f",
    "#55cfeb",
    "#6b5642",
    "#9de468",
    "#6327eb",
    "#10ead3",
    "#ebcd9f",
    "#5c99dc",
)
"""Of people in their order, repeated if there are more."""

ROBOTS = ("#1a85ff", "#e81099", "#e9d30f", "#90440f")
"""Of robots in their order, repeated if there are more.

Those of people and of robots were moved apart, as the color-blind see them as well, and
kept neither too dark for a black background nor too light for a white one.
"""

INK = "#1b1f24"
"""Of text: on white paper, and on the labels of the viewer, dark and light."""

CARESS, TAP = "#1a9850", "#d73027"
BELIEVED, TRUE = "#ffb000", "#3ddc84"
"""Of lines from a touch to what a learner believes it to be about, and to what it is
really about."""

IDLE = "#777777"


def rgb(color: str) -> tuple[int, int, int]:
    """Red, green and blue of a color such as "#0072b2", each 0 to 255."""
    value = int(color.removeprefix("#"), 16)
    return value >> 16, value >> 8 & 255, value & 255


def behavior_colors(behaviors: Sequence[str]) -> list[str]:
    """The color of each behavior of a household, by name."""
    others = cycle(OTHER_BEHAVIORS)
    return [BEHAVIOR_COLORS.get(name) or next(others) for name in behaviors]


def people_colors(count: int) -> list[str]:
    """The color of each person."""
    return [PEOPLE[i % len(PEOPLE)] for i in range(count)]


def robot_colors(count: int) -> list[str]:
    """The color of each robot."""
    return [ROBOTS[i % len(ROBOTS)] for i in range(count)]


def ink_on(color: str) -> str:
    """Black or white, whatever is easier to read on a color."""
    red, green, blue = rgb(color)
    return INK if 0.3 * red + 0.59 * green + 0.11 * blue > 140 else "#ffffff"


def shades(color: str, count: int) -> list[str]:
    """Tints of a color, from itself to a paler one, to tell values of a thing apart."""
    tints = []
    for i in range(count):
        white = 0.55 * i / max(1, count - 1)
        mixed = [round(c + (255 - c) * white) for c in rgb(color)]
        tints.append("#{:02x}{:02x}{:02x}".format(*mixed))
    return tints


def packed(colors: Sequence[str], alpha: int = 255) -> NDArray[np.uint32]:
    """Colors as Rerun packs them, 0xRRGGBBAA."""
    return np.array(
        [int(c.removeprefix("#"), 16) << 8 | alpha for c in colors], dtype=np.uint32
    )


STOPS = np.array([0.0, 0.3, 0.7, 1.0])
HEAT = np.array([[240, 241, 245], [107, 174, 214], [8, 81, 156], [3, 19, 43.0]])
"""Shares, and their colors from nearly white over blue to nearly black."""


@compiled_aside
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
