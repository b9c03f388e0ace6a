"""Experiment 5: two people, and analogy between them (5.5, figure 7)."""

from __future__ import annotations

from functools import partial

import numpy as np
import polars as pl

from experiments.analysis import social
from experiments.analysis.claims import Claim
from experiments.analysis.evaluation import BEYOND, Method
from experiments.analysis.measures import Measure, StudyMeasure, of, of_each
from experiments.analysis.statistics import FloatArray, mean
from experiments.analysis.tables import Table
from experiments.figures import CumulativeReward, TouchesByPhase
from experiments.paper.experiment import Experiment, PaperFigure
from experiments.paper.reading_situations import SITUATIONS, reached, table
from experiments.paper.table_1 import computed
from experiments.running.study import Condition

SWAP, ALONE, SKIP = "swap", "no_analogy", "skip_silence"
CONTROLS = (ALONE, SKIP)

PHASE = 1200.0
"""When the roles are inverted. [s]"""

END = float("inf")

first_phase: Measure = partial(social.positive_share, begin=0.0, end=PHASE)
"""Share of caresses among the touches of phase 1."""

second_phase: Measure = partial(social.positive_share, begin=PHASE, end=END)
"""Share of caresses among the touches of phase 2."""


def gain(trial: pl.DataFrame) -> float:
    """Returns how much larger the share of caresses is in phase 2 than in phase 1."""
    return second_phase(trial) - first_phase(trial)


def _reached(frame: pl.DataFrame) -> FloatArray:
    met = reached(frame.filter(pl.col("condition") == SWAP), PHASE)
    return np.array([met[one] > 0 for one in SITUATIONS], dtype=np.float64)


def _situations(frame: pl.DataFrame) -> Table:
    return table(frame.filter(pl.col("condition") == SWAP), PHASE)


def _share(number: int, measure: Measure) -> Method:
    return Method(
        name="Frequency of rewards",
        text=f"caresses among the touches of phase {number}",
        measure=measure,
        is_share=True,
    )


CLAIMS = (
    Claim(
        id="5a",
        text="While it learns, a slight majority of the touches are taps.",
        reading=(
            "Share of caresses among the touches of phase 1, per seed; the mean of all "
            "seeds. Holds at 50 % or less."
        ),
        measure=of(SWAP, first_phase),
        rule="at most",
        threshold=0.5,
        estimate=mean,
        unit="share of touches",
        compared=of_each(CONTROLS, first_phase),
    ),
    Claim(
        id="5b",
        text="With the roles inverted, many more touches are caresses.",
        reading=(
            "Share of caresses among the touches of phase 2, per seed; the mean of all "
            "seeds. Holds at 70 % or more."
        ),
        measure=of(SWAP, second_phase),
        rule="at least",
        threshold=0.7,
        estimate=mean,
        unit="share of touches",
        compared=of_each(CONTROLS, second_phase),
    ),
    Claim(
        id="5c",
        text="Without analogy phase 2 is no better than phase 1.",
        reading=(
            "Share of caresses in phase 2 minus that in phase 1, seed by seed, for a "
            "learner without analogy. Holds if the interval covers 0 or the value is "
            "below 10 percentage points."
        ),
        measure=of(ALONE, gain),
        rule="no better than",
        threshold=0.1,
        estimate=mean,
        unit="share of touches",
        compared=of_each((SWAP, SKIP), gain),
    ),
    Claim(
        id="5d",
        text="There are 28 situations.",
        reading=(
            "Share of the 28 situations (7 activities of the one who does not read, "
            "who reads, whether the other attends to the robot) that are reached in at "
            "least one seed. Where both read, the phase tells whose task it is. Holds "
            "if all are."
        ),
        measure=StudyMeasure(label=SWAP, conditions=(SWAP,), values=_reached),
        rule="at least",
        threshold=1.0,
        estimate=computed,
        unit="share of situations",
    ),
)


def _figure(name: str, condition: str, analogy: str) -> PaperFigure:
    return PaperFigure(
        name=name,
        caption=(
            f"{analogy}. Caresses and taps in phase 1 and in phase 2, and the sum of "
            "all touches; the roles are inverted after 20 minutes."
        ),
        condition=condition,
        plots=(TouchesByPhase(boundary=PHASE), CumulativeReward()),
    )


EXPERIMENT = Experiment(
    number=5,
    title="Learning by analogy",
    question=(
        "Once the robot knows how to behave towards one person, does it know how to "
        "behave towards another?"
    ),
    setup=(
        "Phase 1: ann reads, while bob comes in, works, sleeps, reads and makes a "
        "call. Phase 2: the other way round.",
        "The robot plays, sleeps or says hello, and both touch it as they find it "
        "polite or not.",
        "The social rate, designated credit, and SwapRoles: what is learned of a "
        "situation is true of the same situation with the two people exchanged.",
        "Controls: the same without analogy, and skip_silence, which does not learn "
        "from steps without feedback (designated credit and SwapRoles otherwise).",
    ),
    conditions=(
        Condition(name=SWAP, scenario="experiment_5", learner="designated_swap"),
        Condition(name=ALONE, scenario="experiment_5", learner="designated"),
        Condition(
            name=SKIP,
            scenario="experiment_5",
            learner="skip_silence",
            learner_overrides={"credit": "designated", "analogy": "swap"},
        ),
    ),
    claims=CLAIMS,
    figures=(
        _figure("figure_7", SWAP, "With analogy"),
        _figure("figure_7_no_analogy", ALONE, "Control: without analogy"),
    ),
    tables=(_situations,),
    further=(
        _share(1, first_phase),
        _share(2, second_phase),
        Method(
            name="Q-table",
            text="situations with 8 or more decisions that converged",
            measure=social.learned_share,
            is_share=True,
        ),
        Method(
            name=BEYOND,
            text="touches credited to the pair that they are about",
            measure=social.credit_accuracy,
            is_share=True,
        ),
    ),
)
