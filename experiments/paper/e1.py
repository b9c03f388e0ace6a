"""Experiment 1: standard Q-learning (section 5.1, figure 3)."""

from __future__ import annotations

import polars as pl

from experiments.analysis import measures
from experiments.analysis.claims import Claim
from experiments.analysis.target_situations import TargetSituation
from experiments.figures import BehaviorSequence, CumulativeReward, QValues
from experiments.paper.experiment import Experiment, PaperFigure
from experiments.running.study import Condition

PLAY = TargetSituation(name="PLAY", role="playing")
RIGHT = "play"

CONDITIONS = ("asynchronous", "synchronous")


def _converged(trial: pl.DataFrame) -> float:
    return measures.converged(trial, PLAY.find(trial))


def _masters(trial: pl.DataFrame) -> float:
    return measures.masters(trial, PLAY.find(trial))


def _alternates(trial: pl.DataFrame) -> float:
    return measures.keeps_alternating(trial, PLAY.find(trial))


def _forgets(trial: pl.DataFrame) -> float:
    situation = PLAY.find(trial)
    _, values = measures.q_curve(trial, situation, RIGHT)
    return len(values) > 0 and measures.fall_from_peak(values) >= 0.3


def _claims(condition: str) -> tuple[Claim, ...]:
    return (
        Claim(
            id="1a",
            text="Standard Q-learning does not learn what to do in PLAY.",
            reading=(
                "Share of the seeds that converge in PLAY: at least 90 % of the last "
                "quarter of the choices are right, and Q(PLAY, play) ends on top. "
                "Holds at 1/3 or less."
            ),
            measure=measures.of(condition, _converged),
            rule="at most",
            threshold=1 / 3,
            reference=measures.on_references(_masters),
        ),
        Claim(
            id="1b",
            text="The robot keeps alternating between bark and play.",
            reading=(
                "Our reading: share of the seeds in which each behavior still makes up "
                "at least 10 % of the last quarter of the choices in PLAY. Holds at "
                "2/3 or more, the complement of 1a."
            ),
            measure=measures.of(condition, _alternates),
            rule="at least",
            threshold=2 / 3,
            reference=measures.on_references(_alternates),
        ),
        Claim(
            id="1c",
            text="It forgets: without rewards the value of play falls again.",
            reading=(
                "Share of the seeds in which Q(PLAY, play) ends at least 30 % below "
                "its peak. Holds at 80 % or more."
            ),
            measure=measures.of(condition, _forgets),
            rule="at least",
            threshold=0.8,
        ),
    )


def _figure(name: str, condition: str) -> PaperFigure:
    return PaperFigure(
        name=name,
        caption=(
            f"Standard Q-learning, {condition} rate. Which behavior the robot does, "
            "the Q-values of both behaviors in PLAY, and the sum of all touches."
        ),
        condition=condition,
        plots=(BehaviorSequence(), QValues(situation=PLAY), CumulativeReward()),
    )


EXPERIMENT = Experiment(
    number=1,
    title="Standard Q-learning",
    question=(
        "Can a robot learn what is polite from the touches of a person, if it learns "
        "the way robots usually do?"
    ),
    setup=(
        "One person plays in the play corner and looks at the robot part of the time.",
        "The robot barks or plays. While the person attends to it, it is caressed for "
        "playing and tapped for barking, but play is rewarded less and less as it "
        "goes on. While the person does not attend, nothing happens.",
        "Standard Q-learning, with the asynchronous learning rate (each pair of "
        "situation and behavior has its own) and with the synchronous one.",
    ),
    conditions=tuple(
        Condition(name=name, scenario="experiment_1", learner=f"q_{name}")
        for name in CONDITIONS
    ),
    claims=tuple(claim for name in CONDITIONS for claim in _claims(name)),
    figures=(
        _figure("figure_3", "asynchronous"),
        _figure("figure_3_synchronous", "synchronous"),
    ),
    target_situations=(PLAY,),
)
