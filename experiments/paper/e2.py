"""Experiment 2: a learning rate that depends on social factors (5.2, figure 4)."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.claims import Claim
from experiments.analysis.measures import Measure, StudyMeasure
from experiments.analysis.statistics import FloatArray, mean, proportion
from experiments.analysis.target_situations import TargetSituation
from experiments.figures import BehaviorSequence, CumulativeReward, QValues
from experiments.paper.experiment import Experiment, PaperFigure
from experiments.running.study import Condition

PLAY = TargetSituation(name="PLAY", role="playing", attended=True)
IGNORE = TargetSituation(name="IGNORE", role="playing", attended=False)
RIGHT = "play"

SOCIAL, ASYNCHRONOUS, SKIP = "social", "asynchronous", "skip_silence"
CONTROLS = (ASYNCHRONOUS, SKIP)


def _converged(trial: pl.DataFrame) -> float:
    return measures.converged(trial, PLAY.find(trial))


def _masters(trial: pl.DataFrame) -> float:
    return measures.masters(trial, PLAY.find(trial))


def _settled(trial: pl.DataFrame) -> float:
    return social.settled_after(trial, PLAY.find(trial))


def _converged_ignored(trial: pl.DataFrame) -> float:
    return measures.converged(trial, IGNORE.find(trial))


def _wrong_at_first(trial: pl.DataFrame) -> float:
    return social.wrong_among_first(trial, PLAY.find(trial))


def _first_run(trial: pl.DataFrame) -> float:
    return social.first_run(trial, PLAY.find(trial))


def _ahead(less: str, measure: Measure, what: str) -> StudyMeasure:
    """By how much a condition has less of something than the asynchronous rate."""
    found = measures.difference(ASYNCHRONOUS, less, measure)
    return replace(found, label=f"{found.label}, {what}")


AMONG_TEN = "wrong of the first 10"


def _silent_loss(trial: pl.DataFrame) -> float:
    return social.silent_loss(trial, PLAY.find(trial), RIGHT)


def _ends_positive(trial: pl.DataFrame) -> float:
    return measures.final_reward(trial) > 0


def lowest_mean(frame: pl.DataFrame, condition: str) -> FloatArray:
    """Returns each seed's cumulative reward when the mean of all is at its lowest.

    Args:
        frame: The study's table.
        condition: Which condition.

    Returns:
        Shape (n_seeds,), at the second at which their mean is lowest.
    """
    grid = np.arange(0.0, float(frame["next_time"].to_numpy().max()) + 1.0)
    trials = frame.filter(pl.col("condition") == condition)
    sums = []
    for trial in trials.sort("seed", maintain_order=True).partition_by("seed"):
        felt = measures.touches(trial).sort("time")
        total = np.insert(felt["value"].to_numpy().cumsum(), 0, 0.0)
        at = np.searchsorted(felt["time"].to_numpy(), grid, side="right")
        sums.append(total[at])
    curves = np.array(sums)
    lowest: FloatArray = curves[:, curves.mean(axis=0).argmin()]
    return lowest


def _lowest(condition: str, *, label: str) -> StudyMeasure:
    return StudyMeasure(
        label=label,
        conditions=(condition,),
        values=partial(lowest_mean, condition=condition),
    )


CLAIMS = (
    Claim(
        id="2a",
        text="With the social rate the robot learns what to do in PLAY.",
        reading=(
            "Share of the seeds that converge in PLAY (the actor plays and attends to "
            "the robot): at least 90 % of the last quarter of the choices are right, "
            "and Q(PLAY, play) ends on top. Holds at 90 % or more. IGNORE, in which "
            "nobody ever touches the robot, is shown beside it."
        ),
        measure=measures.of(SOCIAL, _converged),
        rule="at least",
        threshold=0.9,
        reference=measures.on_references(_masters),
        compared=(
            *measures.of_each(CONTROLS, _converged),
            measures.of(SOCIAL, _converged_ignored, label=f"{SOCIAL}, in IGNORE"),
        ),
    ),
    Claim(
        id="2b",
        text="It learns earlier than with the asynchronous rate.",
        reading=(
            "Our reading: wrong choices among the first ten in PLAY, asynchronous "
            "minus social, seed by seed; seeds with fewer choices are left out. Holds "
            "if the whole interval is above 0. Beside it: decisions until five are "
            "right in a row, and decisions after which at least 90 % of all those that "
            "follow are right (the reading of before, 0 in nearly all seeds)."
        ),
        measure=_ahead(SOCIAL, _wrong_at_first, AMONG_TEN),
        rule="above",
        threshold=0.0,
        estimate=mean,
        unit="choices",
        is_share=False,
        reference=partial(_ahead, measure=_wrong_at_first, what=AMONG_TEN),
        compared=(
            _ahead(SOCIAL, _first_run, "until 5 right in a row"),
            _ahead(SOCIAL, _settled, "until 90 % right"),
            _ahead(SKIP, _wrong_at_first, AMONG_TEN),
        ),
    ),
    *(
        Claim(
            id="2c",
            text="The cumulative reward does not become negative.",
            reading=(
                "Two parts. At the end: share of the seeds whose final cumulative "
                "reward is positive, holds at 80 % or more. Lowest: the mean of all "
                "seeds' cumulative rewards at the second when it is lowest, holds at "
                "-1 touch or more."
            ),
            measure=measure,
            rule="at least",
            threshold=threshold,
            estimate=estimate,
            unit=unit,
            is_share=is_share,
            compared=compared,
            reference=reference,
        )
        for measure, threshold, estimate, unit, is_share, compared, reference in (
            (
                measures.of(SOCIAL, _ends_positive, label=f"{SOCIAL}, at the end"),
                0.8,
                proportion,
                "share of seeds",
                True,
                measures.of_each(CONTROLS, _ends_positive),
                measures.on_references(_ends_positive),
            ),
            (
                _lowest(SOCIAL, label=f"{SOCIAL}, lowest"),
                -1.0,
                mean,
                "touches",
                False,
                tuple(_lowest(name, label=name) for name in CONTROLS),
                lambda name: _lowest(name, label=name),
            ),
        )
    ),
    *(
        Claim(
            id="2d",
            text="Without feedback it still forgets, but more slowly.",
            reading=(
                "Our reading: which share of Q(PLAY, play) is lost by one choice of "
                "play in PLAY during which nobody touches the robot (all such choices "
                "at a positive value: sum of the losses by sum of the values). Holds "
                "if it is above 0 with the social rate, and less than with the "
                "asynchronous one seed by seed (whole intervals)."
            ),
            measure=measure,
            rule="above",
            threshold=0.0,
            estimate=mean,
            unit="share of the value",
            compared=compared,
        )
        for measure, compared in (
            (
                measures.of(SOCIAL, _silent_loss),
                measures.of_each(CONTROLS, _silent_loss),
            ),
            (measures.difference(ASYNCHRONOUS, SOCIAL, _silent_loss), ()),
        )
    ),
    Claim(
        id="2e",
        text="The influence of the reward grows weaker with time.",
        reading=(
            "Our reading: the mean size of the change of a pair's Q-value by a touch, "
            "first half of the entries with a touch minus second half, seed by seed. "
            "Holds if the whole interval is above 0."
        ),
        measure=measures.of(SOCIAL, social.pull_fades),
        rule="above",
        threshold=0.0,
        estimate=mean,
        unit="touches",
        is_share=False,
        compared=measures.of_each(CONTROLS, social.pull_fades),
    ),
)


def _figure(name: str, condition: str, rate: str) -> PaperFigure:
    return PaperFigure(
        name=name,
        caption=(
            f"{rate}. Which behavior the robot does, the Q-values of both behaviors in "
            "PLAY and in IGNORE, and the sum of all touches."
        ),
        condition=condition,
        plots=(
            BehaviorSequence(),
            QValues(situation=PLAY),
            QValues(situation=IGNORE),
            CumulativeReward(),
        ),
    )


EXPERIMENT = Experiment(
    number=2,
    title="A social learning rate",
    question=(
        "Does the robot learn better if touches and attention, not silence, decide how "
        "much it learns?"
    ),
    setup=(
        "The home and the person of experiment 1. The robot now tells PLAY, in which "
        "the person attends to it, from IGNORE, in which the person does not.",
        "Q-learning with the social rate: what happens under attention and with a "
        "touch moves values far, what happens unnoticed hardly at all.",
        "Controls: the asynchronous rate, and skip_silence, which does not learn from "
        "steps without feedback at all (asynchronous rate otherwise).",
    ),
    conditions=(
        Condition(name=SOCIAL, scenario="experiment_2", learner="q_social"),
        Condition(name=ASYNCHRONOUS, scenario="experiment_2", learner="q_asynchronous"),
        Condition(name=SKIP, scenario="experiment_2", learner="skip_silence"),
    ),
    claims=CLAIMS,
    figures=(
        _figure("figure_4", SOCIAL, "Social rate"),
        _figure("figure_4_asynchronous", ASYNCHRONOUS, "Control: asynchronous rate"),
    ),
    target_situations=(PLAY, IGNORE),
)
