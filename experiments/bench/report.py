"""What was measured, as JSON, as a table and as plots."""

from __future__ import annotations

import dataclasses
import os
import platform
from collections.abc import Iterable, Sequence
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

from experiments.running.files import to_json, write_text, write_whole
from experiments.running.store import commit, versions

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from rich.console import Group, RenderableType
    from rich.table import Table

    from experiments.bench.measurement import Measurement, Settings

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


def document(measurements: Iterable[Measurement], settings: Settings) -> dict[str, Any]:
    """Returns everything as plain data."""
    return {
        "machine": machine(),
        "versions": versions(),
        "commit": commit(),
        "settings": dataclasses.asdict(settings),
        "measures": [each.plain() for each in measurements],
    }


def write(measurements: Sequence[Measurement], settings: Settings, out: Path) -> None:
    """Writes bench.json, bench.md and bench.svg."""
    write_text(out / "bench.json", to_json(document(measurements, settings)))
    write_text(out / "bench.md", markdown(measurements))
    write_whole(out / "bench.svg", lambda path: _plot(measurements, path))


def markdown(measurements: Iterable[Measurement]) -> str:
    """Returns the table for the docs, with the machine below it."""
    lines = ["| what | median | least | most | budget | |", "|" + " --- |" * 6]
    for part, found in _by_part(measurements).items():
        lines.append(f"| **{part}** | | | | | |")
        lines += [f"| {' | '.join(_cells(each)).strip()} |" for each in found]
    facts = [f"{name}: {value}" for name, value in machine().items()]
    return "\n".join([*lines, "", "; ".join(facts) + ".", ""])


def _by_part(measurements: Iterable[Measurement]) -> dict[str, list[Measurement]]:
    parts: dict[str, list[Measurement]] = {}
    for each in measurements:
        parts.setdefault(each.part, []).append(each)
    return parts


def tables(measurements: Iterable[Measurement]) -> Group:
    """Returns all measurements, a table for each part; 80 columns are enough."""
    from rich.console import Group
    from rich.text import Text

    head = _grid()
    head.add_row("", "median", "least - most", "budget", style="italic")
    shown: list[RenderableType] = [head]
    for part, found in _by_part(measurements).items():
        rows = _grid()
        for each in found:
            name, median, least, most, budget, verdict = _cells(each)
            bounds, spread = f"{budget} {verdict}".strip(), f"{least} - {most}"
            rows.add_row(f"  {name}", median, spread.strip(" -"), bounds)
        shown += [Text(part, style="bold"), rows]
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


def _cells(each: Measurement) -> tuple[str, ...]:
    if each.median is None:
        return each.name, "-", "", "", each.hint, ""
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


def _plot(measurements: Sequence[Measurement], path: Path) -> None:
    """One plot for each part that grows with something; medians and ranges."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    parts = list(_by_part(each for each in measurements if each.growth).values())
    rows = -(-len(parts) // COLUMNS)
    with mpl.rc_context({"svg.hashsalt": "household", "font.size": 9}):
        figure = Figure(figsize=(3.4 * COLUMNS, 2.6 * rows), layout="constrained")
        axes = figure.subplots(rows, COLUMNS, squeeze=False).ravel()
        for ax, part in zip(axes, parts, strict=False):
            _draw(ax, part)
        for ax in axes[len(parts) :]:
            ax.set_visible(False)
        figure.savefig(path, format="svg", metadata={"Date": None})


def _draw(ax: Axes, measurements: Sequence[Measurement]) -> None:
    growths = [each.growth for each in measurements if each.growth]
    x = [growth.x for growth in growths]
    ax.plot(
        x, [median(each.values) for each in measurements], marker="o", color="#0072b2"
    )
    ax.fill_between(
        x,
        [min(each.values) for each in measurements],
        [max(each.values) for each in measurements],
        color="#0072b2",
        alpha=0.2,
        linewidth=0,
    )
    ylabel = f"{growths[0].what} [{measurements[0].unit}]"
    ax.set(xlabel=growths[0].against, ylabel=ylabel)
    ax.set_ylim(bottom=0)
    ax.spines[["top", "right"]].set_visible(False)
