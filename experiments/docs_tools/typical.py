"""Typical trials: how anybody makes the replay of one, and opens it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import polars as pl

from experiments.analysis.measures import touches, typical_seed
from experiments.paper import EXPERIMENTS, Experiment
from experiments.report.figures import stored_study
from experiments.running.store import Results
from experiments.running.trial import make_home


@dataclass(frozen=True, kw_only=True)
class Typical:
    """The typical trial of an experiment, as in its report."""

    experiment: Experiment
    """What it is of."""

    seed: int
    """Whose cumulative reward is the median of all seeds."""

    caresses: int
    """In this trial."""

    taps: int
    """In this trial."""

    @property
    def heading(self) -> str:
        """What the page calls it."""
        return f"Experiment {self.experiment.number}: {self.experiment.title}"

    @property
    def condition(self) -> str:
        """The condition that the experiment is about."""
        return self.experiment.reference

    @property
    def page(self) -> str:
        """The page of its replay that `household reproduce` makes, in `replays`."""
        return f"{self.experiment.name}_seed_{self.seed}.html"

    @property
    def commands(self) -> tuple[str, str]:
        """What records this trial alone, and what opens it at its first touch."""
        condition = self.experiment.condition(self.condition)
        decisions = make_home(condition).scenario.max_cycles
        out = f"runs/{self.experiment.name}"
        kind = "tap" if self.taps else "caress"
        return (
            f"household train {condition.scenario} --learner {condition.learner} "
            f"--seed {self.seed} --decisions {decisions} --out {out}",
            f'household replay {out} --find "{kind} by"',
        )


def typical(runs: Path) -> list[Typical]:
    """Returns the typical trial of each experiment that was run.

    Args:
        runs: What `household reproduce --out` was given.
    """
    stored = ((one, Results(runs / one.name)) for one in EXPERIMENTS.values())
    return [_typical(*each) for each in stored if each[1].study_file.exists()]


def _typical(experiment: Experiment, results: Results) -> Typical:
    frame = results.read(stored_study(experiment, results))
    seed = typical_seed(frame, experiment.reference)
    mine = pl.col("condition") == experiment.reference, pl.col("seed") == seed
    values = touches(frame.filter(*mine))["value"]
    return Typical(
        experiment=experiment,
        seed=seed,
        caresses=int((values > 0.0).sum()),
        taps=int((values < 0.0).sum()),
    )
