"""Puts panels on a page: side by side for print, one by one for the report.

A figure is some columns of panels that share their x axis. Files are the same, byte for
byte, for the same data.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from experiments.figures.colors import THEMED
from experiments.running.files import write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLUMN_WIDTH = 5.6
"""Width of a column. [inch]"""

INK, LINE, PAPER = "#1b1f24", "#d3d8de", "#ffffff"

PALETTE = ("#d55e00", "#0072b2", "#00795a", "#9a4d80")
"""Of what has no color of its own: Okabe and Ito's, darkened for print."""

DASHES = ((0, (4, 1.5)), "solid", (0, (1, 1)), (0, (5, 1, 1, 1)))
"""Line styles that go with the palette, for readers without any color."""

_THEMED = {INK: "--ink", LINE: "--line", PAPER: "--paper"} | THEMED

_STYLE: dict[Any, object] = {
    "axes.axisbelow": True,
    "axes.edgecolor": INK,
    "axes.facecolor": PAPER,
    "axes.grid": True,
    "axes.grid.axis": "y",
    "axes.labelcolor": INK,
    "axes.labelsize": 11,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlecolor": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 12,
    "figure.facecolor": PAPER,
    "font.size": 11,
    "grid.color": LINE,
    "legend.fontsize": 10,
    "legend.frameon": False,
    "legend.labelcolor": INK,
    "savefig.dpi": 160,
    "svg.fonttype": "path",
    "svg.hashsalt": "household",
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
}


@dataclass(frozen=True, kw_only=True)
class Panel:
    """One pair of axes."""

    label: str
    """What the y axis shows, with its unit."""

    draw: Callable[[Axes], None]
    """Draws into the axes; times are in minutes."""

    height: float = 1.7
    """[inch]"""


@dataclass(frozen=True, kw_only=True)
class Column:
    """Panels one below the other, with one horizontal axis."""

    title: str
    """What the column shows."""

    panels: tuple[Panel, ...]
    """From top to bottom."""

    across: str = "time [min]"
    """What the x axis shows, with its unit."""

    is_scale: bool = True
    """Whether round numbers are to be marked on the x axis; else as the panels do."""


def save(
    columns: Sequence[Column], stem: Path, kinds: Sequence[str] = (".svg", ".png")
) -> tuple[Path, ...]:
    """Writes a figure, as SVG and as PNG unless said otherwise.

    Args:
        columns: Shown side by side.
        stem: Path without its suffix.
        kinds: Suffixes of the files.

    Returns:
        The files.
    """
    paths = tuple(stem.with_suffix(kind) for kind in kinds)
    with styled():
        figure = _arranged(columns)
        for path in paths:
            _write(figure, path)
    return paths


def inline(columns: Sequence[Column], name: str) -> tuple[str, ...]:
    """Returns one SVG element per column, to be set in a page.

    Colors are the page's (`--ink`, `--line`, `--behavior-bark`, ...), so they follow
    its light or dark theme; the size is that of the surrounding box.

    Args:
        columns: Drawn one by one, so that they can stand below each other on a phone.
        name: Keeps the ids of several figures in one page apart.
    """
    return tuple(
        _for_page(_svg(column), column, f"{name}-{index}")
        for index, column in enumerate(columns)
    )


@contextmanager
def styled() -> Iterator[None]:
    """Has everything drawn within look like the figures of the paper's experiments."""
    import matplotlib as mpl

    with mpl.rc_context():
        mpl.rcdefaults()  # a user's matplotlibrc must not change the files
        mpl.rcParams.update(_STYLE)
        yield


def _arranged(columns: Sequence[Column]) -> Figure:
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    heights = [panel.height for panel in columns[0].panels]
    figure = Figure(
        figsize=(COLUMN_WIDTH * len(columns), sum(heights) + 0.9), layout="constrained"
    )
    grid = figure.subplots(
        len(heights), len(columns), sharex="col", squeeze=False, height_ratios=heights
    )
    for index, column in enumerate(columns):
        for axes, panel in zip(grid[:, index], column.panels, strict=True):
            axes.set_ylabel(panel.label)
            panel.draw(axes)
        below = 14 if grid[0, index].get_legend() is None else 26
        grid[0, index].set_title(column.title, pad=below)
        grid[-1, index].set_xlabel(column.across)
        if column.is_scale:
            locator = MaxNLocator(6, steps=[1, 2, 5, 10])
            grid[-1, index].xaxis.set_major_locator(locator)
    figure.align_ylabels()
    engine = figure.get_layout_engine()
    if engine is not None:
        engine.execute(figure)
        figure.set_layout_engine(None)  # Nor is it drawn to be laid out for each file.
    return figure


def _write(figure: Figure, path: Path) -> None:
    kind = path.suffix.removeprefix(".")
    metadata = {"Date": None, "Creator": None} if kind == "svg" else {"Software": None}
    write_whole(
        path,
        lambda temporary: figure.savefig(temporary, format=kind, metadata=metadata),
    )


def _svg(column: Column) -> str:
    buffer = io.StringIO()
    with styled():
        metadata = {"Date": None, "Creator": None}
        _arranged([column]).savefig(buffer, format="svg", metadata=metadata)
    return buffer.getvalue()


def _for_page(svg: str, column: Column, name: str) -> str:
    body = svg[svg.index("<svg") :]
    body = re.sub(r' (?:width|height)="[\d.]+pt"', "", body, count=2)
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", body)
    for color, variable in _THEMED.items():
        body = body.replace(color, f"var({variable})")
    shown = ", ".join(panel.label.replace("\n", " ") for panel in column.panels)
    return body.replace("<svg", f'<svg role="img" aria-label="{shown}"', 1)
