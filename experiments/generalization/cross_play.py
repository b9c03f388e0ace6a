"""Trained with one kind of person, probed with another; trained apart, put together.

Kinds are shipped personas, which differ in how they praise, sanction and look: what a
robot learned from one must serve with the other. And two robots that learned alone are
put into one household beside two that learned together.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import polars as pl

from experiments.analysis.preregistered import Contrast, Result
from experiments.analysis.statistics import Estimate
from experiments.generalization.building import every
from experiments.generalization.drawing import matrix
from experiments.generalization.findings import interval_of, score_of
from experiments.generalization.inquiry import Inquiry
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.world import World

KINDS = ("warm", "strict", "child", "absorbed", "punisher")

LEARNERS = ("canonical without names", "within hearing, full")

TWO = World(robots=2)

FACTORS = ("trained with", "probed with")


def _pairs() -> dict[tuple[str, ...], tuple[Training, Probing]]:
    return {
        (one, other): (
            Training(world=World(persona=one)),
            Probing(world=World(persona=other), new=("people",), households=2),
        )
        for one in KINDS
        for other in KINDS
    }


def _robots() -> Iterator[Phases]:
    """Two robots that learned together, and two that learned alone."""
    together = Training(world=TWO, households=2)
    alone = Training(world=replace(TWO, robots=1), households=2, alone=2)
    for training, name in ((together, "each other"), (alone, "nobody")):
        probing = Probing(world=TWO, new=("people",), households=2)
        yield from every(
            LEARNERS, {(name, "each other"): (training, probing)}, FACTORS, ()
        )


def _say(frame: pl.DataFrame, results: tuple[Result, ...]) -> tuple[str, ...]:
    del results
    return tuple(
        f"{learner[0].upper()}{learner[1:]}: {interval_of(same)} with the kind that "
        f"it was trained with, {interval_of(other)} with others."
        for learner in LEARNERS
        for same, other in [_diagonal(frame.filter(pl.col("learner") == learner))]
    )


def _diagonal(rows: pl.DataFrame) -> tuple[Estimate, Estimate]:
    """Scores with the kind of training, and with others."""
    pairs = rows.filter(pl.col("trained with").is_in(KINDS))
    same = pl.col("trained with") == pl.col("probed with")
    return score_of(pairs.filter(same)), score_of(pairs.filter(~same))


def _contrast(text: str, learner: str, one: str, other: str) -> Contrast:
    levels = {"learner": learner, "probed with": other}
    return Contrast(
        text=text,
        more={**levels, "trained with": other},
        less={**levels, "trained with": one},
    )


INQUIRY = Inquiry(
    name="cross_play",
    question="Does what was learned from one kind of person serve with another?",
    seeds=10,
    conditions=every(LEARNERS, _pairs(), FACTORS, ("random",)) + tuple(_robots()),
    contrasts=(
        _contrast(
            "Who learned from people who only punish is worse among warm ones.",
            "within hearing, full",
            "punisher",
            "warm",
        ),
        _contrast(
            "Who learned from warm people is worse among strict ones.",
            "within hearing, full",
            "warm",
            "strict",
        ),
        Contrast(
            text="Robots that learned together do better together.",
            more={"learner": "within hearing, full", "trained with": "each other"},
            less={"learner": "within hearing, full", "trained with": "nobody"},
        ),
    ),
    draw=lambda frame: matrix(
        frame.filter(
            pl.col("trained with").is_in(KINDS), pl.col("learner").is_in(LEARNERS)
        ),
        "trained with",
        "probed with",
        "learner",
    ),
    say=_say,
)
