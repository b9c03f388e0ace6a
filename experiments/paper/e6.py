"""Experiment 6, ours: what remembering costs when tastes change.

The paper's social rate learns hardly anything from silence, and skip_silence nothing at
all. In experiments 1 to 5 that costs nothing, as people there always want the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import polars as pl

from experiments.analysis import measures
from experiments.analysis.claims import Claim
from experiments.analysis.evaluation import BEYOND, Method
from experiments.analysis.measures import (
    Measure,
    StudyMeasure,
    of_each,
    on_references,
)
from experiments.analysis.statistics import FloatArray, mean
from experiments.analysis.target_situations import TargetSituation
from experiments.figures import BehaviorSequence, CumulativeReward, QValues
from experiments.paper.experiment import Experiment, PaperFigure
from experiments.running.study import Condition

PLAY = TargetSituation(name="PLAY", role="playing", attended=True)

CHANGE, END = 1200.0, float("inf")
"""When the actor's taste changes, and when all is over. [s]"""

SOCIAL, ASYNCHRONOUS, SKIP = "social", "asynchronous", "skip_silence"
ANEW = "_anew"
"""Ends the names of conditions in which the actor wants from the beginning what it else
wants only after the change."""

OPPOSITE = "_opposite"
"""Ends the names of conditions in which the actor taps what it does not want."""


def _decisions(trial: pl.DataFrame, begin: float, end: float) -> pl.DataFrame:
    """What was chosen in PLAY within some time."""
    chosen = measures.decisions(trial, PLAY.find(trial))
    return chosen.filter(pl.col("time").is_between(begin, end, closed="left"))


def right(trial: pl.DataFrame, begin: float, end: float) -> float:
    """Returns the share of right choices in PLAY, in the last quarter of some time.

    Args:
        trial: The table of a trial.
        begin: When the time begins [s].
        end: When it ends [s].
    """
    last = measures.last_quarter(_decisions(trial, begin, end))
    return float(measures.appropriate(last).mean()) if len(last) else float("nan")


def wrong_at_first(trial: pl.DataFrame, begin: float, n: int = 20) -> float:
    """Returns how many of the first choices in PLAY from some moment on are wrong.

    Args:
        trial: The table of a trial.
        begin: That moment [s].
        n: How many choices; NaN if there are fewer.
    """
    first = measures.appropriate(_decisions(trial, begin, END))[:n]
    return float((~first).sum()) if len(first) == n else float("nan")


before: Measure = partial(right, begin=0.0, end=CHANGE)
"""Share of right choices in the end before the change."""

after: Measure = partial(right, begin=CHANGE, end=END)
"""Share of right choices in the end after it."""


def _cost(frame: pl.DataFrame, condition: str) -> FloatArray:
    remembers = partial(wrong_at_first, begin=CHANGE)
    begins_anew = partial(wrong_at_first, begin=0.0)
    with_memory = measures.per_seed(frame, condition, remembers)
    return with_memory - measures.per_seed(frame, condition + ANEW, begins_anew)


def cost(condition: str) -> StudyMeasure:
    """Returns how many more choices go wrong at first for who remembers than anew."""
    return StudyMeasure(
        label=f"{condition} - beginning anew",
        conditions=(condition, condition + ANEW),
        values=partial(_cost, condition=condition),
    )


CLAIMS = (
    Claim(
        id="6a",
        text="As long as tastes stay, learning from silence is no better.",
        reading=(
            "Right choices in PLAY, last quarter before the change: social minus "
            "skip_silence, seed by seed. Holds if the interval covers 0 or the value "
            "is below 5 percentage points."
        ),
        measure=measures.difference(SOCIAL, SKIP, before),
        rule="no better than",
        threshold=0.05,
        estimate=mean,
        unit="share of choices",
        compared=of_each((SOCIAL, ASYNCHRONOUS, SKIP), before),
    ),
    Claim(
        id="6b",
        text="Who learns from touches alone does not adapt.",
        reading=(
            "Right choices in PLAY, last quarter after the change, skip_silence. Holds "
            "at 50 % or less, which a random robot has."
        ),
        measure=measures.of(SKIP, after),
        rule="at most",
        threshold=0.5,
        estimate=mean,
        unit="share of choices",
        reference=on_references(after),
        compared=of_each((ASYNCHRONOUS, SKIP + OPPOSITE), after),
    ),
    Claim(
        id="6c",
        text="Who learns from silence, too, does.",
        reading=(
            "The same of the social rate minus skip_silence, seed by seed. Holds if "
            "the whole interval is above 0. Beside it (_opposite): where the actor "
            "taps what it does not want, so that touches say that tastes have changed."
        ),
        measure=measures.difference(SOCIAL, SKIP, after),
        rule="above",
        threshold=0.0,
        estimate=mean,
        unit="share of choices",
        compared=(
            *of_each((SOCIAL,), after),
            measures.difference(ASYNCHRONOUS, SKIP, after),
            measures.difference(SOCIAL + OPPOSITE, SKIP + OPPOSITE, after),
        ),
    ),
    Claim(
        id="6d",
        text="To remember costs more mistakes than to begin anew.",
        reading=(
            "Wrong choices among the first 20 in PLAY after the change, minus those "
            "among the first 20 of the same learner where the actor wants that from "
            "the beginning; seed by seed, seeds with fewer choices are left out. Holds "
            "if the whole interval is above 0."
        ),
        measure=cost(SOCIAL),
        rule="above",
        threshold=0.0,
        estimate=mean,
        unit="choices",
        is_share=False,
        compared=(cost(ASYNCHRONOUS), cost(SKIP)),
    ),
)


def _figure(name: str, condition: str, rate: str) -> PaperFigure:
    return PaperFigure(
        name=name,
        caption=(
            f"{rate}. Which behavior the robot does, the Q-values of both behaviors in "
            "PLAY, and the sum of all touches; after 20 minutes the actor wants the "
            "other."
        ),
        condition=condition,
        plots=(BehaviorSequence(), QValues(situation=PLAY), CumulativeReward()),
    )


LEARNERS = {SOCIAL: "q_social", ASYNCHRONOUS: "q_asynchronous", SKIP: "skip_silence"}


CONDITIONS = tuple(
    Condition(name=name, scenario="experiment_6", learner=learner)
    for name, learner in LEARNERS.items()
)


def _norms(play: float, sleep: float) -> dict[str, Any]:
    """Returns norms, the same whether the actor attends or not."""
    values = {"play": play, "sleep": sleep}
    return {"playing": {"attending": values, "absorbed": values}}


def _elsewhere(
    suffix: str, learners: Sequence[str], **overrides: object
) -> tuple[Condition, ...]:
    """Returns learners in a scenario that differs.

    Args:
        suffix: Added to their names.
        learners: Which.
        **overrides: Of the scenario.
    """
    return tuple(
        replace(one, name=one.name + suffix, scenario_overrides=overrides)
        for one in CONDITIONS
        if one.name in learners
    )


BEGINNING_ANEW = _elsewhere(
    ANEW,
    tuple(LEARNERS),
    norms=_norms(play=0.0, sleep=1.0),
    changes=[],
    max_cycles=round(CHANGE),
)

TAPPED = _elsewhere(
    OPPOSITE,
    (SOCIAL, SKIP),
    norms=_norms(play=1.0, sleep=-1.0),
    changes=[{"at": CHANGE, "norms": _norms(play=-1.0, sleep=1.0)}],
)


EXPERIMENT = Experiment(
    number=6,
    title="Tastes that change",
    question="What does remembering cost when people begin to want something else?",
    setup=(
        "The paper has no such experiment; what is claimed here was written down "
        "before it was run, after a probe with other scenarios.",
        "The home and the person of experiment 2. For 20 minutes the person likes the "
        "robot to play, from then on to sleep, and the robot is not told. What it does "
        "not praise, it does not tap.",
        "Q-learning with the social rate, with the asynchronous rate, and "
        "skip_silence, which does not learn from steps without feedback (asynchronous "
        "rate otherwise).",
        "Beside them: each learner where the person has wanted the robot to sleep from "
        "the beginning (_anew), and two of them where the person taps what it does not "
        "want (_opposite).",
    ),
    conditions=CONDITIONS,
    claims=CLAIMS,
    figures=(
        _figure("figure_changing", SOCIAL, "Social rate"),
        _figure("figure_changing_skip_silence", SKIP, "Control: touches alone"),
    ),
    beside=(*BEGINNING_ANEW, *TAPPED),
    target_situations=(PLAY,),
    further=(
        Method(
            name=BEYOND,
            text="right choices in PLAY, end before the change",
            measure=before,
            is_share=True,
        ),
        Method(
            name=BEYOND,
            text="right choices in PLAY, end after the change",
            measure=after,
            is_share=True,
        ),
    ),
    of_paper=False,
)
