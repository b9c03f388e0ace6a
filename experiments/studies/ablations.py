"""Two ideas at a time, each with and without the other: 2 x 2 ablations.

The paper brings in the social rate together with attention in the situation, and its
rate answers at once how much a touch and how much silence is to teach. Here the two
halves of each pair are parted.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np
import polars as pl

from experiments.analysis import measures
from experiments.analysis.statistics import Estimate, FloatArray, mean
from experiments.running.study import Condition, Study, Trial
from experiments.running.trial import run_trial

RATES = ("asynchronous", "social")
"""Levels of the rate."""

OUTCOMES: Mapping[str, str] = {
    "right": "right choices, last quarter",
    "attended": "right choices under attention, last quarter",
    "reward": "sum of all touches",
}
"""What is kept of each trial."""


@dataclass(frozen=True, kw_only=True)
class Ablation:
    """Two factors of two levels each, on one scenario."""

    name: str
    """Of its folder."""

    title: str
    """In which experiment, in a few words."""

    factors: Mapping[str, tuple[str, str]]
    """Factor -> levels, first without an idea and then with it."""

    conditions: tuple[Condition, ...]
    """All four."""

    def study(self, seeds: tuple[int, ...]) -> Study:
        """Returns the trials to run."""
        return Study(
            name=f"maps/{self.name}",
            conditions=self.conditions,
            seeds=seeds,
            run=run_ablated,
        )

    def estimate(self, frame: pl.DataFrame, outcome: str, *levels: str) -> Estimate:
        """Returns an outcome at a level of each factor.

        Args:
            frame: The study's table.
            outcome: One of `OUTCOMES`.
            *levels: One of each factor, in order.
        """
        return _mean(self._values(frame, outcome, *levels))

    def effects(self, frame: pl.DataFrame, outcome: str) -> Mapping[str, Estimate]:
        """Returns what each factor adds in the mean, and what both add together.

        Args:
            frame: The study's table.
            outcome: One of `OUTCOMES`.

        Returns:
            By factor, paired by seed; by both names joined with " x ", how much more
            the first adds with the second than without it.
        """
        first, second = self.factors.values()
        (neither, b), (a, both) = (
            [self._values(frame, outcome, one, other) for other in second]
            for one in first
        )
        names = tuple(self.factors)
        return {
            names[0]: _mean((a + both - neither - b) / 2),
            names[1]: _mean((b + both - neither - a) / 2),
            " x ".join(names): _mean(both - b - a + neither),
        }

    def _values(self, frame: pl.DataFrame, outcome: str, *levels: str) -> FloatArray:
        """One number per seed, in the order of the seeds."""
        chosen = dict(zip(self.factors, levels, strict=True))
        rows = frame.filter(**chosen).sort("seed")
        return rows[outcome].cast(pl.Float64).fill_null(np.nan).to_numpy()


def _mean(values: FloatArray) -> Estimate:
    return mean(values[~np.isnan(values)])


def run_ablated(trial: Trial) -> pl.DataFrame:
    """Runs a trial and keeps its outcomes alone.

    Returns:
        One row with the columns of `OUTCOMES`; null where there was nothing to measure.
    """
    frame = run_trial(trial)
    chosen = frame.filter(pl.col("chosen"))
    found = {
        "right": _right(chosen),
        "attended": _right(chosen.filter(pl.col("attended"))),
        "reward": measures.final_reward(frame),
    }
    schema = dict.fromkeys(OUTCOMES, pl.Float64)
    return pl.DataFrame([found], schema=schema).fill_nan(None)


def _right(decisions: pl.DataFrame) -> float:
    last = measures.last_quarter(decisions)
    return np.nan if last.is_empty() else float(measures.appropriate(last).mean())


def _representation() -> Ablation:
    levels = (("roles", "none"), ("roles_and_attention", "robot"))
    return Ablation(
        name="rate_representation",
        title="Experiments 1 and 2",
        factors={"rate": RATES, "situation": ("roles", "roles_and_attention")},
        conditions=tuple(
            Condition(
                name=f"{rate}+{situation}",
                scenario="experiment_2",
                learner=f"q_{rate}",
                scenario_overrides={"situation": {"attention": attention}},
                factors={"rate": rate, "situation": situation},
            )
            for rate, (situation, attention) in product(RATES, levels)
        ),
    )


PAPER: Mapping[int, Mapping[str, str]] = {
    1: {},
    2: {},
    3: {},
    4: {"credit": "designated"},
    5: {"credit": "designated", "analogy": "swap"},
}
"""Settings of the paper's learners beside the rate, by experiment."""


def _silence(number: int) -> Ablation:
    """Whether silence teaches at all, at either rate."""
    taught = (("nothing", "skip_silence"), ("0", "q_social"))
    return Ablation(
        name=f"rate_silence_{number}",
        title=f"Experiment {number}",
        factors={"rate": RATES, "silence_teaches": ("nothing", "0")},
        conditions=tuple(
            Condition(
                name=f"{rate}+{silence}",
                scenario=f"experiment_{number}",
                learner=learner,
                learner_overrides={**PAPER[number], "rate": rate},
                factors={"rate": rate, "silence_teaches": silence},
            )
            for rate, (silence, learner) in product(RATES, taught)
        ),
    )


ABLATIONS: Mapping[str, Ablation] = {
    each.name: each for each in (_representation(), *map(_silence, PAPER))
}
"""By name: rate x representation, then rate x what silence teaches."""
