"""Lettering: static text as pixels, legible whatever colors a viewer gives labels."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from household.view.colors import INK
from household.view.raster import Raster

PAPER = "#fafaf8"
"""Background of drawings, in a dark viewer as well."""

POINTS = 72.0
"""Points in an inch."""


class Text(NamedTuple):
    """A text on a drawing whose y points down.

    Attributes:
        x: Where it is.
        y: Where its middle is.
        text: What it says.
        align: "left", "center" or "right" of x; of its start, if it is turned.
        turned: Whether it is read from below.
        color: Of a square before it; None: no square.
    """

    x: float
    y: float
    text: str
    align: str = "left"
    turned: bool = False
    color: str | None = None


class Sheet(NamedTuple):
    """A piece of paper to write on.

    Attributes:
        left: Its edge in the drawing's units.
        top: Its upper edge.
        width: In the same units.
        height: In the same units.
        letter: Height of the letters in the same units.
    """

    left: float
    top: float
    width: float
    height: float
    letter: float


def write(texts: Sequence[Text], sheet: Sheet, scale: float) -> Raster:
    """Writes texts on paper.

    Args:
        texts: What and where.
        sheet: The paper.
        scale: Pixels per unit of the drawing.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    size = (sheet.width * scale / 100, sheet.height * scale / 100)
    figure = Figure(figsize=size, dpi=100, facecolor=PAPER)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set(
        xlim=(sheet.left, sheet.left + sheet.width),
        ylim=(sheet.top + sheet.height, sheet.top),
    )
    points = sheet.letter * scale * POINTS / 100
    for each in texts:
        shape: dict[str, Any] = {"rotation": 90 if each.turned else 0, "color": INK}
        shape |= {"ha": "center", "va": "bottom"} if each.turned else {}
        aside = 0.0
        if each.color is not None:
            side = 0.8 * sheet.letter
            corners = ((0, -1), (2, -1), (2, 1), (0, 1))
            x, y = zip(*corners, strict=True)
            axes.fill(
                each.x + np.array(x) * side / 2,
                each.y + np.array(y) * side / 2,
                color=each.color,
            )
            aside = 1.4 * sheet.letter
        shape = {"ha": each.align, "va": "center_baseline"} | shape
        axes.text(each.x + aside, each.y, each.text, fontsize=points, **shape)
    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    rgba = np.asarray(canvas.buffer_rgba())
    return Raster(rgba[..., :3].copy(), sheet.left, sheet.top, scale)
