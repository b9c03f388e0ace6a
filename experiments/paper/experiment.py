"""What an experiment of the paper is: a question, conditions, claims and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import polars as pl

from experiments.analysis import measures
from experiments.analysis.claims import Claim, Finding
from experiments.analysis.evaluation import Method
from experiments.analysis.tables import Table
from experiments.analysis.target_situations import Scene
from experiments.figures import Cell, Column, CumulativeReward, Row, TouchFrequency
from experiments.figures.rows import legend_above
from experiments.running.study import Condition, Study
from experiments.running.trial import run_trial

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, kw_only=True)
class PaperFigure:
    """The counterpart of one of the paper's figures: typical seed beside all seeds."""

    name: str
    """File name without suffix, e.g. `figure_3`."""

    caption: str
    """What there is to see."""

    condition: str
    """Whose trials it shows."""

    rows: tuple[Row, ...]
    """The same rows as in the paper, from top to bottom."""

    def columns(self, frame: pl.DataFrame) -> tuple[Column, ...]:
        """Returns the typical seed and the mean over all seeds.

        Args:
            frame: The study's table.
        """
        seed = measures.typical_seed(frame, self.condition)
        trials = frame.filter(pl.col("condition") == self.condition)
        trial = trials.filter(pl.col("seed") == seed)
        n = trials["seed"].n_unique()
        return (
            Column(
                title=f"typical seed ({seed})",
                cells=tuple(
                    Cell(
                        label=row.label,
                        height=row.height,
                        draw=partial(row.draw_trial, trial=trial),
                    )
                    for row in self.rows
                ),
            ),
            Column(
                title=f"mean of {n} seeds, 95 % interval",
                cells=tuple(
                    Cell(
                        label=row.label,
                        height=row.height,
                        draw=partial(row.draw_seeds, trials=trials),
                    )
                    for row in self.rows
                ),
            ),
        )


@dataclass(frozen=True, kw_only=True)
class Experiment:
    """One experiment of the paper."""

    number: int
    """As in the paper, 1 to 5."""

    title: str
    """A few words."""

    question: str
    """What was asked, for somebody who has not read the paper."""

    setup: tuple[str, ...]
    """What was done, one sentence or two each."""

    conditions: tuple[Condition, ...]
    """What is compared; same home, same seeds, same exploration."""

    claims: tuple[Claim, ...]
    """What the paper says came out."""

    figures: tuple[PaperFigure, ...]
    """Counterparts of the paper's figures; the first one's condition is the
    experiment's own, the others are its controls."""

    scenes: tuple[Scene, ...] = ()
    """The situations to be learned, for the analysis of the Q-table."""

    tables: tuple[Callable[[pl.DataFrame], Table], ...] = ()
    """What else is shown: each takes the study's table."""

    further: tuple[Method, ...] = ()
    """What else tells how well a condition did, beside what every experiment has."""

    @property
    def name(self) -> str:
        """Name of its folder."""
        return f"experiment_{self.number}"

    @property
    def reference(self) -> str:
        """The condition that the experiment is about."""
        return self.figures[0].condition

    def study(self, seeds: tuple[int, ...]) -> Study:
        """Returns the trials to run."""
        return Study(
            name=self.name, conditions=self.conditions, seeds=seeds, run=run_trial
        )

    def condition(self, name: str) -> Condition:
        """Returns a condition by its name."""
        return next(one for one in self.conditions if one.name == name)

    def check(self, frame: pl.DataFrame) -> tuple[Finding, ...]:
        """Returns what came of each claim.

        Args:
            frame: The study's table.
        """
        return tuple(claim.check(frame) for claim in self.claims)


def comparison(experiment: Experiment, frame: pl.DataFrame) -> tuple[Column, ...]:
    """Returns all conditions in one figure: cumulative reward, frequency of touches.

    These are the first two evaluation methods of section 4.1 of the paper.

    Args:
        experiment: Whose conditions.
        frame: The study's table.
    """
    rows = (
        CumulativeReward(),
        TouchFrequency(positive=True),
        TouchFrequency(positive=False),
    )
    cells = tuple(
        Cell(
            label=row.label,
            height=row.height,
            draw=partial(_draw_conditions, row=row, experiment=experiment, frame=frame),
        )
        for row in rows
    )
    return (Column(title="mean over all seeds, 95 % interval", cells=cells),)


def _draw_conditions(
    axes: Axes,
    row: CumulativeReward | TouchFrequency,
    experiment: Experiment,
    frame: pl.DataFrame,
) -> None:
    for lane, condition in enumerate(experiment.conditions):
        trials = frame.filter(pl.col("condition") == condition.name)
        row.draw_as(axes, trials, lane)
    if isinstance(row, TouchFrequency):
        axes.set_ylim(bottom=0)
    else:
        legend_above(axes)
