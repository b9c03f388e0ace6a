"""What was measured, as JSON, as a table and as plots."""

from __future__ import annotations

import dataclasses
import os
import platform
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from experiments.running.store import commit, to_json, versions, write_text, write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from rich.console import Group, RenderableType
    from rich.table import Table

    from experiments.bench.measure import Measure, Settings

VERDICTS = {None: "", True: "kept", False: "MISSED"}

COLUMNS = 3
"""Plots side by side."""


def machine() -> dict[str, str]:
    """Returns what this machine is, in a few words."""
    load = ", ".join(f"{each:.1f}" for each in _load())
    return {
        "system": platform.platform(),
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "load at the end": load or "unknown",
    }


def _load() -> tuple[float, ...]:
    return os.getloadavg() if hasattr(os, "getloadavg") else ()


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.exists() else []
    names = [line.partition(": ")[2] for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def document(measures: Iterable[Measure], settings: Settings) -> dict[str, Any]:
    """Returns everything as plain data."""
    return {
        "machine": machine(),
        "versions": versions(),
        "commit": commit(),
        "settings": dataclasses.asdict(settings),
        "measures": [measure.plain() for measure in measures],
    }


def write(measures: Sequence[Measure], settings: Settings, out: Path) -> None:
    """Writes bench.json, bench.md and bench.svg."""
    write_text(out / "bench.json", to_json(document(measures, settings)))
    write_text(out / "bench.md", markdown(measures))
    write_whole(out / "bench.svg", lambda path: _plot(measures, path))


def markdown(measures: Iterable[Measure]) -> str:
    """Returns the table for the docs, with the machine below it."""
    lines = ["| what | median | least | most | budget | |", "|" + " --- |" * 6]
    for part, found in _by_part(measures).items():
        lines.append(f"| **{part}** | | | | | |")
        lines += [f"| {' | '.join(_cells(each)).strip()} |" for each in found]
    told = [f"{name}: {value}" for name, value in machine().items()]
    return "\n".join([*lines, "", "; ".join(told) + ".", ""])


def _by_part(measures: Iterable[Measure]) -> dict[str, list[Measure]]:
    parts: dict[str, list[Measure]] = {}
    for each in measures:
        parts.setdefault(each.part, []).append(each)
    return parts


def tables(measures: Iterable[Measure]) -> Group:
    """Returns all measures, a table for each part; 80 columns are enough."""
    from rich.console import Group

    head = _grid()
    head.add_row("", "median", "least - most", "budget", style="italic")
    shown: list[RenderableType] = [head]
    for part, found in _by_part(measures).items():
        rows = _grid()
        for each in found:
            name, median, least, most, budget, verdict = _cells(each)
            bounds = f"{budget} {verdict}".strip()
            rows.add_row(f"  {name}", median, f"{least} - {most}", bounds)
        shown += [f"[bold]{part}[/bold]", rows]
    return Group(*shown)


def _grid() -> Table:
    """Columns of the same width in all tables."""
    from rich.table import Table

    grid = Table.grid(padding=(0, 2))
    grid.add_column(width=33)
    grid.add_column(width=10, justify="right")
    grid.add_column(width=16, justify="right")
    grid.add_column(width=15)
    return grid


def _cells(each: Measure) -> tuple[str, ...]:
    bounds = (("<=", each.at_most), (">=", each.at_least))
    budget = "".join(f"{sign} {bound:g}" for sign, bound in bounds if bound is not None)
    return (
        each.name,
        f"{_number(each.median)} {each.unit}".rstrip(),
        _number(min(each.values)),
        _number(max(each.values)),
        budget,
        VERDICTS[each.holds],
    )


def _number(value: float) -> str:
    """Three digits or more, without powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def _plot(measures: Sequence[Measure], path: Path) -> None:
    """One plot for each part that grows with something; medians and ranges."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    parts = list(dict.fromkeys(each.part for each in measures if each.x is not None))
    rows = -(-len(parts) // COLUMNS)
    with mpl.rc_context({"svg.hashsalt": "household", "font.size": 9}):
        figure = Figure(figsize=(3.4 * COLUMNS, 2.6 * rows), layout="constrained")
        axes = figure.subplots(rows, COLUMNS, squeeze=False).ravel()
        for part, ax in zip(parts, axes, strict=False):
            _draw(ax, part, [each for each in measures if each.part == part and each.x])
        for ax in axes[len(parts) :]:
            ax.set_visible(False)
        figure.savefig(path, format="svg", metadata={"Date": None})


def _draw(ax: Axes, part: str, measures: Sequence[Measure]) -> None:
    x = [each.x or 0.0 for each in measures]
    ax.plot(x, [each.median for each in measures], marker="o", color="#0072b2")
    ax.fill_between(
        x,
        [min(each.values) for each in measures],
        [max(each.values) for each in measures],
        color="#0072b2",
        alpha=0.2,
        linewidth=0,
    )
    what, _, against = part.partition(" against ")
    ax.set(xlabel=against, ylabel=f"{what} [{measures[0].unit}]")
    ax.set_ylim(bottom=0)
    ax.spines[["top", "right"]].set_visible(False)
