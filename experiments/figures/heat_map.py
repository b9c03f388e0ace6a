"""A heat map: what a claim measures over two constants, and where it holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from experiments.figures.canvas import INK, PAPER

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PALEST, STRONGEST = 0.03, 0.38
"""How opaque a cell is at 0 and at 1; text stays readable on all. Cells are gray, as
colors belong to behaviors, touches and conditions."""


@dataclass(frozen=True, kw_only=True)
class Spot:
    """A cell of a heat map."""

    text: str
    """What stands in it, one or two lines."""

    shade: float
    """How strongly it is colored, 0 to 1."""

    framed: bool
    """Whether it has a thick frame: the claim holds."""

    dotted: bool = False
    """Whether it has a dot in its corner: the experiment itself lies there."""


@dataclass(frozen=True, kw_only=True)
class HeatMap:
    """Cells in rows and columns."""

    across: tuple[str, ...]
    """Levels of the horizontal axis."""

    up: tuple[str, ...]
    """Levels of the vertical axis, from below."""

    spots: tuple[tuple[Spot, ...], ...]
    """Row by row from below, as many in each as there are levels across."""

    @property
    def height(self) -> float:
        """Height in inches."""
        return 0.55 * len(self.up) + 0.2

    def draw(self, axes: Axes) -> None:
        """Draws cells, frames and texts."""
        from matplotlib.patches import Rectangle

        for y, row in enumerate(self.spots):
            for x, spot in enumerate(row):
                alpha = PALEST + (STRONGEST - PALEST) * min(max(spot.shade, 0.0), 1.0)
                corner = (x - 0.5, y - 0.5)
                axes.add_patch(
                    Rectangle(corner, 1, 1, facecolor=INK, alpha=alpha, lw=0)
                )
                axes.add_patch(
                    Rectangle(corner, 1, 1, fill=False, edgecolor=PAPER, lw=1.5)
                )
                axes.text(x, y, spot.text, ha="center", va="center", color=INK, size=9)
                if spot.dotted:
                    axes.plot(x - 0.38, y + 0.34, "o", color=INK, ms=4)
        for y, row in enumerate(self.spots):  # Above the lines between cells.
            for x, spot in enumerate(row):
                if spot.framed:
                    inner = (x - 0.46, y - 0.46)
                    axes.add_patch(
                        Rectangle(inner, 0.92, 0.92, fill=False, edgecolor=INK, lw=1.6)
                    )
        axes.set_xticks(range(len(self.across)), self.across)
        axes.set_yticks(range(len(self.up)), self.up)
        axes.set_xlim(-0.5, len(self.across) - 0.5)
        axes.set_ylim(-0.5, len(self.up) - 0.5)
        axes.tick_params(length=0)
        axes.grid(visible=False)
        for side in axes.spines.values():
            side.set_visible(False)
