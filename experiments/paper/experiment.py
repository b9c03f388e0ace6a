"""What an experiment of the paper is: a question, conditions, claims and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import polars as pl

from experiments.analysis import measures
from experiments.analysis.claims import CEILING, FLOOR, Claim, Finding
from experiments.analysis.evaluation import Method
from experiments.analysis.tables import Table
from experiments.analysis.target_situations import TargetSituation
from experiments.figures import (
    Column,
    CumulativeReward,
    Panel,
    Plot,
    TouchFrequency,
    legend_above,
)
from experiments.running.study import Condition, Study, Trial
from experiments.running.trial import run_trial
from experiments.running.trial_columns import COLUMNS

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, kw_only=True)
class PaperFigure:
    """The counterpart of one of the paper's figures: typical seed beside all seeds."""

    name: str
    """File name without suffix, e.g. `figure_3`."""

    caption: str
    """What the figure shows."""

    condition: str
    """Whose trials it shows."""

    plots: tuple[Plot, ...]
    """The same plots as in the paper, from top to bottom."""

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
                panels=tuple(
                    Panel(
                        label=plot.label,
                        height=plot.height,
                        draw=partial(plot.draw_trial, trial=trial),
                    )
                    for plot in self.plots
                ),
            ),
            Column(
                title=f"mean of {n} seeds, 95 % interval",
                panels=tuple(
                    Panel(
                        label=plot.label,
                        height=plot.height,
                        draw=partial(plot.draw_seeds, trials=trials),
                    )
                    for plot in self.plots
                ),
            ),
        )


@dataclass(frozen=True, kw_only=True)
class Experiment:
    """One experiment of the paper."""

    number: int
    """As in the paper, 1 to 5; from 6 on they are ours."""

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

    target_situations: tuple[TargetSituation, ...] = ()
    """The situations to be learned; their Q-values are followed over time."""

    beside: tuple[Condition, ...] = ()
    """What is run beside what is compared: learners and scenarios that are otherwise
    in more than the one thing that the experiment is about."""

    tables: tuple[Callable[[pl.DataFrame], Table], ...] = ()
    """What else is shown: each takes the study's table."""

    further: tuple[Method, ...] = ()
    """Evaluations beside those that every experiment has."""

    of_paper: bool = True
    """Whether it is the paper's, and so are its claims."""

    @property
    def name(self) -> str:
        """Name of its folder."""
        return f"experiment_{self.number}"

    @property
    def run(self) -> Callable[[Trial], pl.DataFrame]:
        """Runs one trial and follows the situations to be learned."""
        return partial(run_trial, followed=self.target_situations)

    @property
    def reference(self) -> str:
        """The condition that the experiment is about."""
        return self.figures[0].condition

    @property
    def all_conditions(self) -> tuple[Condition, ...]:
        """All that is run: what is compared, what is beside it, both references."""
        return (
            *self.conditions,
            *self.beside,
            *references(self.conditions[0].scenario),
        )

    def study(self, seeds: tuple[int, ...]) -> Study:
        """Returns the trials to run."""
        return Study(
            name=self.name,
            conditions=self.all_conditions,
            seeds=seeds,
            run=self.run,
            columns=COLUMNS,
        )

    def condition(self, name: str) -> Condition:
        """Returns a condition by its name."""
        return next(one for one in self.all_conditions if one.name == name)

    def check(self, frame: pl.DataFrame) -> tuple[Finding, ...]:
        """Returns what came of each claim.

        Args:
            frame: The study's table.
        """
        return tuple(claim.check(frame) for claim in self.claims)


def references(
    scenario: str, suffix: str = "", **overrides: object
) -> tuple[Condition, ...]:
    """Returns the conditions that claims have as their floor and their ceiling.

    Args:
        scenario: Where both are run.
        suffix: Added to their names.
        **overrides: Of the scenario.
    """
    learners = {FLOOR: "random", CEILING: "persona_oracle"}
    return tuple(
        Condition(
            name=name + suffix,
            scenario=scenario,
            learner=learner,
            scenario_overrides=overrides,
        )
        for name, learner in learners.items()
    )


def comparison(experiment: Experiment, frame: pl.DataFrame) -> tuple[Column, ...]:
    """Returns all conditions in one figure: cumulative reward, frequency of touches.

    These are the first two evaluation methods of section 4.1 of the paper.

    Args:
        experiment: Whose conditions.
        frame: The study's table.
    """
    plots = (
        CumulativeReward(),
        TouchFrequency(positive=True),
        TouchFrequency(positive=False),
    )
    panels = tuple(
        Panel(
            label=plot.label,
            height=plot.height,
            draw=partial(
                _draw_conditions, plot=plot, experiment=experiment, frame=frame
            ),
        )
        for plot in plots
    )
    return (Column(title="mean over all seeds, 95 % interval", panels=panels),)


def _draw_conditions(
    axes: Axes,
    plot: CumulativeReward | TouchFrequency,
    experiment: Experiment,
    frame: pl.DataFrame,
) -> None:
    for lane, condition in enumerate(experiment.conditions):
        trials = frame.filter(pl.col("condition") == condition.name)
        plot.draw_as(axes, trials, lane)
    if isinstance(plot, TouchFrequency):
        axes.set_ylim(bottom=0)
    else:
        legend_above(axes)
