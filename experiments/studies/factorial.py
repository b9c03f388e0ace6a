"""The factorial: every learning rate with every credit rule and every analogy.

The paper changes the scenario together with the learner from one experiment to the
next. Here each of its three ideas is varied alone, on each of its five scenarios.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from itertools import product
from typing import NamedTuple

import numpy as np
import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.statistics import Estimate, FloatArray, mean
from experiments.paper import EXPERIMENTS, e5
from experiments.running.study import Condition, Study, Trial
from experiments.running.trial import run_trial

LEARNERS: Mapping[str, str] = {
    "asynchronous": "q_asynchronous",
    "social": "q_social",
    "skip_silence": "skip_silence",
}
"""First factor: level -> learner. The last one learns nothing from steps without
feedback, at the asynchronous rate otherwise."""

FACTORS: Mapping[str, tuple[str, ...]] = {
    "rate": tuple(LEARNERS),
    "credit": ("immediate", "trace", "designated"),
    "analogy": ("none", "swap", "swap_remove", "adaptive"),
}
"""Factor -> levels."""


class Combination(NamedTuple):
    """A level of each factor, in the order of `FACTORS`."""

    rate: str
    credit: str
    analogy: str


PAPER: Mapping[int, frozenset[Combination]] = {
    1: frozenset({Combination("asynchronous", "immediate", "none")}),
    2: frozenset({Combination("social", "immediate", "none")}),
    3: frozenset(
        {
            Combination("social", "immediate", "none"),
            Combination("social", "trace", "none"),
        }
    ),
    4: frozenset({Combination("social", "designated", "none")}),
    5: frozenset(
        {
            Combination("social", "designated", "swap"),
            Combination("social", "designated", "none"),
        }
    ),
}
"""The combinations that the paper ran, or ours for its experiment, by experiment."""

OUTCOMES: Mapping[str, str] = {
    "right": "appropriate choices",
    "reward": "cumulative reward",
    "credited": "touches credited to the pair that they are about",
}
"""What is kept of each trial. `right` is the share of appropriate choices: in
experiments 1 to 4 in the last quarter of the decisions, mean of the situations that the
paper names; in experiment 5 over all decisions of phase 2."""


def study(number: int, seeds: tuple[int, ...]) -> Study:
    """Returns the 36 conditions of the factorial on one experiment's scenario.

    Args:
        number: Of the experiment.
        seeds: The same as of the plain run, so that all are paired.
    """
    return Study(
        name=f"factorial/experiment_{number}",
        conditions=conditions(number),
        seeds=seeds,
        run=partial(run_combination, number=number),
    )


def conditions(number: int) -> tuple[Condition, ...]:
    """Returns a condition for each combination of levels, on one scenario.

    Args:
        number: Of the experiment whose scenario it is.
    """
    return tuple(
        Condition(
            name="+".join(levels),
            scenario=f"experiment_{number}",
            learner=LEARNERS[levels.rate],
            learner_overrides={"credit": levels.credit, "analogy": levels.analogy},
            factors=levels._asdict(),
        )
        for levels in map(Combination._make, product(*FACTORS.values()))
    )


def run_combination(trial: Trial, number: int) -> pl.DataFrame:
    """Runs a trial and keeps its outcomes alone.

    Args:
        trial: What to run.
        number: Of the experiment.

    Returns:
        One row with the columns of `OUTCOMES`; null where there was nothing to measure.
    """
    frame = run_trial(trial)
    found = {
        "right": _right(frame, number),
        "reward": measures.final_reward(frame),
        "credited": social.credit_accuracy(frame),
    }
    schema = dict.fromkeys(OUTCOMES, pl.Float64)
    return pl.DataFrame([found], schema=schema).fill_nan(None)


def _right(frame: pl.DataFrame, number: int) -> float:
    situations = EXPERIMENTS[number].target_situations
    if situations:
        shares = [social.right_share(frame, one.find(frame)) for one in situations]
        return float(np.mean(shares))
    late = frame.filter(pl.col("chosen") & (pl.col("time") >= e5.PHASE))
    return float(measures.appropriate(late).mean())


def level_means(
    frame: pl.DataFrame, outcome: str, levels: Mapping[str, str]
) -> FloatArray:
    """Returns an outcome per seed, averaged over all combinations with some levels.

    Args:
        frame: The table of one of the studies.
        outcome: One of `OUTCOMES`.
        levels: Factor -> level; factors that are not named are averaged over.

    Returns:
        Shape (n_seeds,), in the order of the seeds; NaN where all is null.
    """
    means = (
        frame.filter(**levels).group_by("seed").agg(pl.col(outcome).mean()).sort("seed")
    )
    values: FloatArray = means[outcome].cast(pl.Float64).fill_null(np.nan).to_numpy()
    return values


def estimates(frame: pl.DataFrame, outcome: str) -> Mapping[Combination, Estimate]:
    """Returns an outcome of every combination that was run."""
    found = {}
    ran = frame.select(Combination._fields).unique(maintain_order=True)
    for levels in map(Combination._make, ran.iter_rows()):
        values = level_means(frame, outcome, levels._asdict())
        found[levels] = mean(values[~np.isnan(values)])
    return found
