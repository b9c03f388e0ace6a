"""Figures of studies: curves with their intervals, and matrices."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import polars as pl

from experiments.figures.canvas import INK, LINE, styled
from experiments.generalization.findings import score_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLORS: Mapping[str, str] = {
    "whole situation": "#7a7f87",
    "canonical": "#d55e00",
    "adaptive analogy": "#b8860b",
    "canonical without names": "#8c510a",
    "set of views": "#9a4d80",
    "views": "#56b4e9",
    "within hearing, none": "#a6cee3",
    "within hearing, full": "#0072b2",
    "within hearing, hierarchical": "#00795a",
    "within hearing, adaptive": "#6a3d9a",
    "within hearing, by touches": "#444ca0",
    "nested": "#1b9e77",
    "per person": "#c51b7d",
    "network per person": "#b2182b",
    "PPO": "#2b2b2b",
    "untrained": "#7a7f87",
    "random": "#a3a8b0",
    "persona": "#111111",
    "population": "#5d6370",
    "lookahead": "#3b3b6d",
}
"""One color for one learner, in every figure."""

MARKERS = "osD^vPX*<>hp8"
"""For readers without any color."""

SIZE = (5.6, 3.6)
"""Of one panel [inch]."""


def curves(
    frame: pl.DataFrame,
    x: str,
    panels: str | None = None,
    *,
    label: str,
    series: str = "learner",
    column: str = "greedy",
) -> Figure:
    """Returns scores against something, one line for each learner.

    Args:
        frame: The table of a study.
        x: Column of numbers (texts are read as such).
        panels: Factor with a panel for each level; None: one panel.
        label: What the x axis shows.
        series: Factor with a line for each level.
        column: The score.
    """
    levels = [None] if panels is None else _levels(frame, panels)
    names = _levels(frame, series)

    def draw(axes: Axes, level: str | None) -> None:
        rows = frame if panels is None else frame.filter(pl.col(panels) == level)
        there = set(_levels(rows, series))
        for number, name in enumerate(names):
            if name in there:
                own = rows.filter(pl.col(series) == name)
                _line(axes, own, x, (name, number), column)
        axes.axhline(0.0, color=INK, linewidth=0.8)
        axes.set_xlabel(label)
        axes.set_title(_title(level, panels))

    return _arranged(levels, draw, "probe score: random 0, best 1")


def matrix(
    frame: pl.DataFrame, rows: str, columns: str, panels: str, *, column: str = "greedy"
) -> Figure:
    """Returns a score for each pair of levels, as a matrix for each learner.

    Args:
        frame: The table of a study.
        rows: Factor of the rows.
        columns: Factor of the columns.
        panels: Factor with a panel for each level.
        column: The score.
    """
    names, others = _levels(frame, rows), _levels(frame, columns)

    def draw(axes: Axes, level: str | None) -> None:
        chosen = frame.filter(pl.col(panels) == level)
        values = np.array(
            [
                [_score(chosen, {rows: a, columns: b}, column) for b in others]
                for a in names
            ]
        )
        axes.imshow(values, vmin=0.0, vmax=1.0, cmap="Blues", aspect="auto")
        axes.grid(visible=False)
        axes.set_xticks(range(len(others)), others, rotation=30, ha="right")
        axes.set_yticks(range(len(names)), names)
        axes.set_xlabel(columns)
        axes.set_title(str(level))
        for (i, j), value in np.ndenumerate(values):
            ink = "white" if value > 0.6 else INK
            axes.text(j, i, f"{value:z.2f}", ha="center", va="center", color=ink)

    return _arranged(_levels(frame, panels), draw, rows, legend=False)


def bars(frame: pl.DataFrame, by: str, *, series: str = "learner") -> Figure:
    """Returns the score of each learner as a point with its interval.

    Args:
        frame: The table of a study, at one number of touches.
        by: Factor with a panel for each level.
        series: Factor with a point for each level.
    """
    names = _levels(frame, series)

    def draw(axes: Axes, level: str | None) -> None:
        chosen = frame.filter(pl.col(by) == level)
        for place, name in enumerate(reversed(names)):
            found = score_of(chosen.filter(pl.col(series) == name))
            color = COLORS.get(name, INK)
            axes.plot([found.low, found.high], [place, place], color=color)
            axes.plot(found.value, place, "o", color=color)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_yticks(range(len(names)), reversed(names))
        axes.set_ylim(-0.6, len(names) - 0.4)
        axes.grid(visible=False, axis="y")
        axes.grid(visible=True, axis="x", color=LINE)
        axes.set_xlabel("probe score")
        axes.set_title(str(level))

    height = 0.9 + 0.26 * len(names)
    return _arranged(_levels(frame, by), draw, "", legend=False, height=height)


def _line(
    axes: Axes, rows: pl.DataFrame, x: str, named: tuple[str, int], column: str
) -> None:
    name, number = named
    places = sorted(set(rows[x].to_list()), key=float)
    found = [score_of(rows.filter(pl.col(x) == each), column) for each in places]
    at, color = [float(each) for each in places], COLORS.get(name)
    drawn = axes.plot(
        at,
        [each.value for each in found],
        marker=MARKERS[number % len(MARKERS)],
        markersize=4,
        color=color,
        label=name,
    )
    axes.fill_between(
        at,
        [each.low for each in found],
        [each.high for each in found],
        color=drawn[0].get_color(),
        alpha=0.12,
        linewidth=0,
    )


def _score(frame: pl.DataFrame, levels: Mapping[str, str], column: str) -> float:
    chosen = frame.filter(*(pl.col(name) == level for name, level in levels.items()))
    return score_of(chosen, column).value


def _levels(frame: pl.DataFrame, factor: str) -> list[str]:
    return frame[factor].unique(maintain_order=True).to_list()


def _arranged(
    levels: Sequence[str | None],
    draw: Callable[[Axes, str | None], None],
    label: str,
    *,
    legend: bool = True,
    height: float = SIZE[1],
) -> Figure:
    """Puts panels side by side, two in a row, with one legend beside them."""
    from matplotlib.figure import Figure

    columns = min(len(levels), 2)
    rows = -(-len(levels) // columns)
    with styled():
        figure = Figure(
            figsize=(SIZE[0] * columns, height * rows), layout="constrained"
        )
        grid = figure.subplots(rows, columns, squeeze=False, sharey=legend).ravel()
        for axes, level in zip(grid, levels, strict=False):
            draw(axes, level)
        for axes in grid[len(levels) :]:
            axes.set_visible(False)
        for axes in grid[::columns]:
            axes.set_ylabel(label)
        if legend:
            known = {
                name: handle
                for axes in grid
                for handle, name in zip(*axes.get_legend_handles_labels(), strict=True)
            }
            figure.legend(
                known.values(), known, loc="outside right upper", frameon=False
            )
    return figure


def _title(level: str | None, factor: str | None) -> str:
    """What a panel is of; of a number alone nobody would know."""
    if level is None:
        return ""
    return f"{factor}: {level}" if str(level).isdigit() else str(level)
