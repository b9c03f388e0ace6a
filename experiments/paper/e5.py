"""Experiment 5: two people, and analogy between them (5.5, figure 7)."""

from __future__ import annotations

from functools import partial
from typing import Any

import msgspec
import numpy as np
import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.claims import Claim
from experiments.analysis.evaluation import BEYOND, Method
from experiments.analysis.measures import (
    Measure,
    StudyMeasure,
    of,
    of_each,
    on_references,
)
from experiments.analysis.statistics import FloatArray, mean
from experiments.analysis.tables import Table
from experiments.figures import CumulativeReward, TouchesByPhase
from experiments.paper.e3 import SILENCE, silence_controls
from experiments.paper.experiment import Experiment, PaperFigure, references
from experiments.paper.reading_situations import SITUATIONS, reached, table
from experiments.paper.table_1 import computed
from experiments.running.study import Condition
from household.scenario.reading import read_scenario

WATCHING = "_watching"
"""Ends the names of conditions in which the reading person looks at the robot, too."""

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


def _gained_by_analogy(frame: pl.DataFrame) -> FloatArray:
    return measures.per_seed(frame, SWAP, gain) - measures.per_seed(frame, ALONE, gain)


def watching_people() -> list[dict[str, Any]]:
    """Returns the people of experiment 5, all of whom look at the robot now and then.

    Section 4: the actors were "asked to reward or punish the system each time it acts",
    and who never looks cannot. The person who reads looks as often as the other.
    """
    people: list[dict[str, Any]] = msgspec.to_builtins(
        read_scenario("experiment_5").people
    )
    stages = [stage for person in people for stage in person["script"]]
    looking = next(stage for stage in stages if stage.get("look_at") is not None)
    for stage in stages:
        stage |= {key: looking[key] for key in ("look_at", "look_for", "look_away")}
    return people


def _watched(measure: Measure) -> tuple[StudyMeasure, ...]:
    names = (SWAP, *(one.name for one in references("experiment_5")))
    return of_each(tuple(name + WATCHING for name in names), measure)


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


_GAIN = (
    "Two parts. Alone: share of caresses in phase 2 minus that in phase 1, seed by "
    "seed, for a learner without analogy; holds if the interval covers 0 or the value "
    "is below 10 percentage points. Held against analogy: how much larger that gain is "
    "with it, seed by seed; holds if the whole interval is above 0."
)
"""How claim 5c is measured."""

CLAIMS = (
    Claim(
        id="5a",
        text="While it learns, a slight majority of the touches are taps.",
        reading=(
            "Share of caresses among the touches of phase 1, per seed; the mean of all "
            "seeds. Holds from 30 % to 50 %: fewer caresses are more than a slight "
            "majority of taps. Beside it (_watching): the person who reads looks at "
            "the robot part of the time, too, as the one who does not."
        ),
        least=0.3,
        reference=on_references(first_phase),
        measure=of(SWAP, first_phase),
        rule="at most",
        threshold=0.5,
        estimate=mean,
        unit="share of touches",
        compared=(*of_each(CONTROLS, first_phase), *_watched(first_phase)),
    ),
    Claim(
        id="5b",
        text="With the roles inverted, many more touches are caresses.",
        reading=(
            "Share of caresses among the touches of phase 2, per seed; the mean of all "
            "seeds. Holds at 70 % or more. Beside it (_watching): as in 5a."
        ),
        reference=on_references(second_phase),
        measure=of(SWAP, second_phase),
        rule="at least",
        threshold=0.7,
        estimate=mean,
        unit="share of touches",
        compared=(
            *of_each((*CONTROLS, *SILENCE), second_phase),
            *_watched(second_phase),
        ),
    ),
    Claim(
        id="5c",
        text="Without analogy phase 2 is no better than phase 1.",
        reading=_GAIN,
        measure=of(ALONE, gain),
        rule="no better than",
        threshold=0.1,
        estimate=mean,
        unit="share of touches",
        compared=of_each((SWAP, SKIP), gain),
        reference=on_references(gain),
    ),
    Claim(
        id="5c",
        text="Without analogy phase 2 is no better than phase 1.",
        reading=_GAIN,
        measure=StudyMeasure(
            label=f"{SWAP} - {ALONE}, gain",
            conditions=(SWAP, ALONE),
            values=_gained_by_analogy,
        ),
        rule="above",
        threshold=0.0,
        estimate=mean,
        unit="share of touches",
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
        "Beside them: silence counted apart from touches, held back while somebody is "
        "on the way, and both; and the other reading of section 4, in which the person "
        "who reads looks at the robot part of the time, too (_watching).",
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
    beside=(
        *silence_controls("experiment_5", credit="designated", analogy="swap"),
        Condition(
            name=SWAP + WATCHING,
            scenario="experiment_5",
            learner="designated_swap",
            scenario_overrides={"people": watching_people()},
        ),
        *references("experiment_5", WATCHING, people=watching_people()),
    ),
    tables=(_situations,),
    further=(
        _share(1, first_phase),
        _share(2, second_phase),
        Method(
            name="Q-table",
            text="situations with 8 or more decisions that converged",
            measure=measures.learned_share,
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
