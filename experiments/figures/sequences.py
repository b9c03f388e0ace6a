"""Plots of figures 5 to 7: which situation it was when, touches phase by phase."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import polars as pl

from experiments.analysis import measures
from experiments.analysis.statistics import FloatArray, mean
from experiments.figures.canvas import INK
from experiments.figures.colors import CARESS, SITUATIONS, TAP
from experiments.figures.plots import (
    MINUTE,
    band,
    end_of,
    legend_above,
    lines_of,
    middles,
    per_trial,
    time_share,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, kw_only=True)
class SituationSequence:
    """Which situation it was when; over all seeds: the share of the time."""

    label: str = "situation"
    height: float = 1.7
    most: int = 4
    """How many situations are shown, the most frequent ones."""

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws a lane for each situation."""
        shown = self._shown(trial)
        for lane, key in enumerate(shown):
            held = trial.filter(pl.col("situation") == key)
            begun = held["time"].to_numpy() / MINUTE
            ended = held["next_time"].to_numpy() / MINUTE
            spans = list(zip(begun, ended - begun, strict=True))
            axes.broken_barh(spans, (lane - 0.4, 0.8), color=SITUATIONS[lane])
        axes.set_yticks(range(len(shown)), list(shown.values()))
        axes.set_ylim(-0.6, len(shown) - 0.4)
        axes.grid(visible=False)

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws the share of the time that each situation takes."""
        end = end_of(trials)
        shown = self._shown(trials)
        lines = lines_of(tuple(shown.values()), SITUATIONS)
        for key, line in zip(shown, lines, strict=True):
            share = partial(time_share, column="situation", value=key, end=end)
            band(axes, middles(end), per_trial(trials, share), line)
        axes.set_ylim(0, 1)
        axes.set_ylabel("share of\nthe time")

    def _shown(self, table: pl.DataFrame) -> dict[str, str]:
        """Returns the situations that are shown, by their keys: what each is called."""
        spent = (pl.col("next_time") - pl.col("time")).sum()
        ranked = (
            table.group_by("situation")
            .agg(spent.alias("spent"), pl.col("roles", "attention").first())
            .sort("spent", "situation", descending=[True, False])
            .head(self.most)
        )
        return {row["situation"]: _short(row) for row in ranked.iter_rows(named=True)}


@dataclass(frozen=True, kw_only=True)
class TouchesByPhase:
    """How many caresses and taps each of two phases brought."""

    boundary: float
    """When the second phase begins. [s]"""

    label: str = "touches\nin the phase"
    height: float = 2.2

    def draw_trial(self, axes: Axes, trial: pl.DataFrame) -> None:
        """Draws one trial's counts."""
        self._draw(axes, self._counts(trial)[None], end_of(trial))

    def draw_seeds(self, axes: Axes, trials: pl.DataFrame) -> None:
        """Draws the mean counts with their intervals."""
        self._draw(axes, per_trial(trials, self._counts), end_of(trials))

    def _counts(self, trial: pl.DataFrame) -> FloatArray:
        """Returns caresses of phase 1, of phase 2, taps of 1, of 2; shape (4,)."""
        felt = measures.touches(trial)
        late = felt["time"].to_numpy() >= self.boundary
        caress = felt["value"].to_numpy() > 0
        return np.array(
            [
                np.count_nonzero((caress == kind) & (late == phase))
                for kind in (True, False)
                for phase in (False, True)
            ],
            dtype=np.float64,
        )

    def _draw(self, axes: Axes, counts: FloatArray, end: float) -> None:
        phases = np.array([self.boundary / 2, (self.boundary + end) / 2]) / MINUTE
        width = self.boundary / MINUTE / 4
        for kind, (name, color) in enumerate((("caresses", CARESS), ("taps", TAP))):
            found = [mean(counts[:, 2 * kind + phase]) for phase in (0, 1)]
            height = np.array([one.value for one in found])
            x = phases + (kind - 0.5) * width
            axes.bar(x, height, 0.9 * width, color=color, label=name)
            if len(counts) > 1:
                low = height - [one.low for one in found]
                high = [one.high for one in found] - height
                axes.errorbar(x, height, [low, high], fmt="none", ecolor=INK, capsize=3)
        axes.axvline(self.boundary / MINUTE, color=INK, linewidth=0.8)
        axes.margins(y=0.15)
        for phase, place in enumerate(phases, start=1):
            axes.annotate(
                f"phase {phase}",
                (place, 0.98),
                xycoords=("data", "axes fraction"),
                ha="center",
                va="top",
            )
        axes.set_xlim(0, end / MINUTE)
        legend_above(axes)


def _short(situation: dict[str, Any]) -> str:
    """Returns a situation of one person in a word or two, with `*` for attending."""
    role: str = situation["roles"][0]["role"]
    return f"{role}*" if situation["attention"] else role
