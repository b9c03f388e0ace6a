"""What the paper's figures show, each for one trial and for all seeds.

A plot is drawn twice: for the typical trial, and as mean over all seeds with a
pointwise 95 % bootstrap band. Times are drawn in minutes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import cycle
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np
import polars as pl

from experiments.analysis import measures
from experiments.analysis.statistics import FloatArray, mean_band
from experiments.analysis.target_situations import TargetSituation
from experiments.figures.canvas import DASHES, INK
from experiments.figures.colors import CONDITIONS, behavior_colors

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MINUTE = 60.0
POINTS = 121
BINS = 20


class Plot(Protocol):
    """What one panel of a figure shows."""

    @property
    def label(self) -> str:
        """Label of the y axis."""

    @property
    def height(self) -> float:
        """Height in inches."""

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws one trial."""

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws all trials of a condition (with a column `seed`)."""


@dataclass(frozen=True, kw_only=True)
class BehaviorSequence:
    """Which behavior the robot did when; over all seeds: the share of the time."""

    label: str = "behavior"
    height: float = 1.1

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws a lane for each behavior."""
        names = measures.behaviors(trial)
        colors = behavior_colors(names)
        for lane, name in enumerate(names):
            done = trial.filter(pl.col("behavior") == name)
            begun = done["time"].to_numpy() / MINUTE
            ended = done["next_time"].to_numpy() / MINUTE
            spans = list(zip(begun, ended - begun, strict=True))
            axes.broken_barh(spans, (lane - 0.4, 0.8), color=colors[lane])
        axes.set_yticks(range(len(names)), _spoken(names))
        axes.set_ylim(-0.6, len(names) - 0.4)
        axes.grid(visible=False)

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws the share of the time that each behavior takes."""
        end = end_of(trials)
        names = measures.behaviors(trials)
        for line in lines_of(names, behavior_colors(names)):
            share = partial(time_share, column="behavior", value=line.name, end=end)
            band(axes, middles(end), per_trial(trials, share), line)
        axes.set_ylim(0, 1)
        axes.set_ylabel("share of\nthe time")


@dataclass(frozen=True, kw_only=True)
class QValues:
    """The Q-values of a situation."""

    situation: TargetSituation
    height: float = 2.0

    @property
    def label(self) -> str:
        """Label of the y axis."""
        return f"Q in {self.situation.name}"

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws each behavior's value as it changed."""
        key = self.situation.find(trial)
        end = end_of(trial)
        names = measures.behaviors(trial)
        for line in lines_of(names, behavior_colors(names)):
            times, values = measures.q_curve(trial, key, line.name)
            axes.step(
                np.append(times, end) / MINUTE,
                np.append(values, values[-1:] if len(values) else np.nan),
                where="post",
                color=line.color,
                linestyle=line.dash,
                label=_spoken([line.name])[0],
            )
        _finish(axes)

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws each behavior's mean value."""
        key = self.situation.find(trials)
        grid = np.linspace(0, end_of(trials), POINTS)

        def sampled(trial: pl.DataFrame, name: str) -> FloatArray:
            return _sampled(*measures.q_curve(trial, key, name), grid)

        names = measures.behaviors(trials)
        for line in lines_of(names, behavior_colors(names)):
            curves = per_trial(trials, partial(sampled, name=line.name))
            band(axes, grid, curves, line)
        _finish(axes)


@dataclass(frozen=True, kw_only=True)
class CumulativeReward:
    """The sum of all touches so far."""

    label: str = "cumulative\nreward"
    height: float = 1.7

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws one trial's sum."""
        times, values = _cumulative(trial)
        axes.step(times / MINUTE, values, where="post", color=INK)
        _zero(axes)

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws the mean sum."""
        self.draw_as(axes, trials, None)
        _zero(axes)

    def draw_as(self, axes: Axes, trials: pl.DataFrame, lane: int | None) -> None:
        """Draws the mean sum as one of several conditions."""
        grid = np.linspace(0, end_of(trials), POINTS)
        curves = per_trial(trials, lambda t: _sampled(*_cumulative(t), grid))
        band(axes, grid, curves, _line(_condition(trials), lane))


@dataclass(frozen=True, kw_only=True)
class TouchFrequency:
    """How often the robot is caressed (up) or tapped (down)."""

    positive: bool
    height: float = 1.5

    @property
    def label(self) -> str:
        """Label of the y axis."""
        return f"{'caresses' if self.positive else 'taps'}\nper minute"

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws one trial's counts."""
        end = end_of(trial)
        axes.step(
            middles(end) / MINUTE, self._counts(trial, end), where="mid", color=INK
        )
        axes.set_ylim(bottom=0)

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws the mean counts."""
        self.draw_as(axes, trials, None)
        axes.set_ylim(bottom=0)

    def draw_as(self, axes: Axes, trials: pl.DataFrame, lane: int | None) -> None:
        """Draws the mean counts as one of several conditions."""
        end = end_of(trials)
        counts = per_trial(trials, lambda t: self._counts(t, end))
        band(axes, middles(end), counts, _line(_condition(trials), lane))

    def _counts(self, trial: pl.DataFrame, end: float) -> FloatArray:
        felt = measures.touches(trial)
        signed = felt.filter((pl.col("value") > 0) == pl.lit(self.positive))
        found, _ = np.histogram(signed["time"].to_numpy(), bins=BINS, range=(0, end))
        return found / (end / BINS / MINUTE)


def per_trial(
    trials: pl.DataFrame, curve: Callable[[pl.DataFrame], FloatArray]
) -> FloatArray:
    """Returns one curve per seed, shape (n_seeds, n_points)."""
    parts = trials.sort("seed", maintain_order=True).partition_by("seed")
    return np.array([curve(part) for part in parts])


def _sampled(times: FloatArray, values: FloatArray, grid: FloatArray) -> FloatArray:
    """Returns a stepwise curve at the points of a grid; NaN before it begins."""
    index = np.searchsorted(times, grid, side="right") - 1
    padded = np.append(values, np.nan)
    return padded[np.where(index < 0, len(values), index)]


def time_share(trial: pl.DataFrame, column: str, value: str, end: float) -> FloatArray:
    """Returns the share of each bin of time in which a column has a value.

    Args:
        trial: The table of a trial.
        column: `behavior` or `situation`.
        value: Which value.
        end: End of the last bin. [s]

    Returns:
        Shape (BINS,).
    """
    edges = np.linspace(0, end, BINS + 1)
    done = trial.filter(pl.col(column) == value)
    begun, ended = done["time"].to_numpy(), done["next_time"].to_numpy()
    before = np.clip(edges[:, None], begun, ended) - begun
    shares: FloatArray = np.diff(before.sum(axis=1)) / np.diff(edges)
    return shares


def _cumulative(trial: pl.DataFrame) -> tuple[FloatArray, FloatArray]:
    ordered = trial.sort("next_time")
    times = np.insert(ordered["next_time"].to_numpy(), 0, 0.0)
    return times, np.insert(ordered["reward"].to_numpy().cumsum(), 0, 0.0)


def middles(end: float) -> FloatArray:
    """Returns the middles of the bins of time that `time_share` counts in."""
    return (np.arange(BINS) + 0.5) * end / BINS


def end_of(table: pl.DataFrame) -> float:
    """Returns when the last entry of a table ended, in seconds."""
    return float(table["next_time"].to_numpy().max())


def _condition(trials: pl.DataFrame) -> str:
    return str(trials["condition"][0]) if "condition" in trials.columns else "mean"


def _spoken(names: tuple[str, ...] | list[str]) -> list[str]:
    return [name.replace("_", " ") for name in names]


class Line(NamedTuple):
    """How something is drawn as a line.

    Attributes:
        name: What it is called in the legend.
        color: Its own.
        dash: Its line style, for readers without any color.
    """

    name: str
    color: str
    dash: Any


def lines_of(names: Sequence[str], colors: Sequence[str]) -> list[Line]:
    """Returns how some things are drawn, each with a dash of its own."""
    return [Line(*one) for one in zip(names, colors, cycle(DASHES), strict=False)]


def _line(condition: str, lane: int | None) -> Line:
    """Returns how one of several conditions is drawn, or the only one (None)."""
    if lane is None:
        return Line(condition, INK, "solid")
    return Line(condition, CONDITIONS[lane], DASHES[lane])


def band(axes: Axes, times: FloatArray, curves: FloatArray, line: Line) -> None:
    """Draws the mean of some curves with its interval."""
    center, low, high = mean_band(curves)
    minutes, color, label = times / MINUTE, line.color, _spoken([line.name])[0]
    axes.plot(minutes, center, color=color, linestyle=line.dash, label=label)
    axes.fill_between(minutes, low, high, color=color, alpha=0.18, linewidth=0)


def _finish(axes: Axes) -> None:
    _zero(axes)
    legend_above(axes)


def legend_above(axes: Axes) -> None:
    """Names the lines in a line above the axes."""
    axes.legend(loc="lower right", bbox_to_anchor=(1, 0.97), ncols=4, borderaxespad=0.1)


def _zero(axes: Axes) -> None:
    axes.axhline(0, color=INK, linewidth=0.8)
