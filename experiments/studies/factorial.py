"""The factorial: every learning rate with every credit rule and every analogy.

The paper changes the scenario together with the learner from one experiment to the
next. Here each of its three ideas is varied alone, on each of its five scenarios.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import product
from typing import NamedTuple

import numpy as np
import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.claims import Claim
from experiments.analysis.measures import StudyMeasure
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


@dataclass(frozen=True, kw_only=True)
class Contrast:
    """A directional statement: two levels of one factor, on one scenario."""

    number: int
    """Of the experiment whose scenario it is."""

    text: str
    """What is claimed."""

    factor: str
    """One of `FACTORS`."""

    more: str
    """Level that the claim is about."""

    less: str
    """Level that it is compared with."""

    fixed: Mapping[str, str]
    """The paper's levels of the other factors."""

    rule: str = "above"
    """A key of `claims.RULES`."""

    threshold: float = 0.0
    """What the rule compares with."""

    def claims(self) -> tuple[Claim, Claim]:
        """Returns the statement at the paper's levels, and averaged over all others."""
        return self._claim("paper's levels", self.fixed), self._claim("all levels", {})

    def _claim(self, where: str, fixed: Mapping[str, str]) -> Claim:
        return Claim(
            id=f"F{self.number}",
            text=self.text,
            reading="Appropriate choices, paired by seed.",
            measure=StudyMeasure(
                label=f"{self.more} - {self.less}, {where}",
                conditions=self._compared(fixed),
                values=partial(self._difference, fixed=fixed),
            ),
            rule=self.rule,
            threshold=self.threshold,
            estimate=mean,
            unit="share of choices",
        )

    def _compared(self, fixed: Mapping[str, str]) -> tuple[str, ...]:
        """Names of the conditions at the fixed levels and at one of the two."""
        return tuple(
            condition.name
            for condition in conditions(self.number)
            if fixed.items() <= condition.factors.items()
            and condition.factors[self.factor] in (self.more, self.less)
        )

    def _difference(self, frame: pl.DataFrame, fixed: Mapping[str, str]) -> FloatArray:
        one = level_means(frame, "right", {**fixed, self.factor: self.more})
        return one - level_means(frame, "right", {**fixed, self.factor: self.less})


_PLAIN = {"credit": "immediate", "analogy": "none"}

FINDINGS = (
    Contrast(
        number=1,
        text="Standard Q-learning suffers from silence.",
        factor="rate",
        more="skip_silence",
        less="asynchronous",
        fixed=_PLAIN,
    ),
    Contrast(
        number=2,
        text="The social rate is better than the asynchronous one.",
        factor="rate",
        more="social",
        less="asynchronous",
        fixed=_PLAIN,
    ),
    Contrast(
        number=3,
        text="A classic trace is no answer to delayed touches.",
        factor="credit",
        more="trace",
        less="immediate",
        fixed={"rate": "social", "analogy": "none"},
        rule="no better than",
        threshold=0.1,
    ),
    Contrast(
        number=4,
        text="Designated credit is.",
        factor="credit",
        more="designated",
        less="immediate",
        fixed={"rate": "social", "analogy": "none"},
    ),
    Contrast(
        number=5,
        text="Swapping roles carries over to the other person.",
        factor="analogy",
        more="swap",
        less="none",
        fixed={"rate": "social", "credit": "designated"},
    ),
)
"""The paper's five findings, each as one factor's effect on appropriate choices."""

_DESIGNATED = {"credit": "designated", "analogy": "none"}

_LEVELS: Mapping[int, Mapping[str, str]] = {
    **dict.fromkeys((1, 2, 3), _PLAIN),
    4: _DESIGNATED,
    5: {"credit": "designated", "analogy": "swap"},
}
"""The paper's credit and analogy in each experiment."""


def against_silence(number: int) -> Contrast:
    """Returns whether the social rate beats not learning from silence at all."""
    return Contrast(
        number=number,
        text="The social rate is better than learning from touches alone.",
        factor="rate",
        more="social",
        less="skip_silence",
        fixed=_LEVELS[number],
    )


def estimates(frame: pl.DataFrame, outcome: str) -> Mapping[Combination, Estimate]:
    """Returns an outcome of every combination that was run."""
    found = {}
    ran = frame.select(Combination._fields).unique(maintain_order=True)
    for levels in map(Combination._make, ran.iter_rows()):
        values = level_means(frame, outcome, levels._asdict())
        found[levels] = mean(values[~np.isnan(values)])
    return found
