"""How many touches does a robot need among 1 to 12 people, by what it represents?

It begins without any experience, in one household after the other.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis.preregistered import Contrast, Result
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.findings import score_of
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import LEARNERS
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

PEOPLE = (1, 2, 4, 8, 12)

TOUCHES = (0, 1, 2, 5, 10, 20, 50, 100)

MARKS = (0.5, 0.7, 0.9)
"""Scores of which is asked how many touches they take."""


def _world(people: int) -> World:
    return World(people=people)


CASES = {
    (str(people),): (
        Training(world=_world(people), households=2, decisions=0),
        Probing(
            world=_world(people),
            new=("people", "home"),
            households=2,
            touches=TOUCHES,
        ),
    )
    for people in PEOPLE
}


def touches_to(frame: pl.DataFrame, learner: str, people: str) -> dict[float, int]:
    """Returns after how many touches a learner reaches each mark, if it does."""
    rows = frame.filter(pl.col("learner") == learner, pl.col("n_people") == people)
    scores = {
        touches: score_of(rows.filter(pl.col("touches") == touches)).value
        for touches in TOUCHES
    }
    return {
        mark: min(touches for touches, score in scores.items() if score >= mark)
        for mark in MARKS
        if max(scores.values()) >= mark
    }


def _say(frame: pl.DataFrame, results: tuple[Result, ...]) -> tuple[str, ...]:
    del results
    return tuple(
        _sentence(frame, people, learner)
        for people in map(str, PEOPLE)
        for learner in ("canonical", "within hearing, full", "nested")
    )


def _sentence(frame: pl.DataFrame, people: str, learner: str) -> str:
    reached = touches_to(frame, learner, people)
    rows = frame.filter(
        pl.col("learner") == learner,
        pl.col("n_people") == people,
        pl.col("touches") == TOUCHES[-1],
    )
    met = rows["met_there"].mean()
    who = "With 1 person" if people == "1" else f"Among {people} people"
    marks = ", ".join(f"{mark:g} after {n} touches" for mark, n in reached.items())
    never = f"no score of {MARKS[0]:g} within {TOUCHES[-1]} touches"
    return (
        f"{who}, {learner} reaches {f'a score of {marks}' if marks else never}; "
        f"{100 * float(str(met)):.0f} % of its choices were in a situation met before."
    )


def _contrast(text: str, more: str, less: str, people: int) -> Contrast:
    levels = {"n_people": str(people), "touches": 50}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


INQUIRY = Inquiry(
    name="actors",
    question="How many touches does a robot need among many people?",
    conditions=every(LEARNERS, CASES, ("n_people",)),
    contrasts=(
        _contrast(
            "Among 12, views within hearing beat canonical situations.",
            "within hearing, full",
            "canonical",
            12,
        ),
        _contrast(
            "Among 12, hearing in the view helps.", "within hearing, full", "views", 12
        ),
        _contrast(
            "Among 12, silence that counts as no touch helps.",
            "within hearing, full",
            "within hearing, by touches",
            12,
        ),
        _contrast(
            "Among 12, nested views beat plain ones within hearing.",
            "nested",
            "within hearing, full",
            12,
        ),
        _contrast(
            "With one person, what is represented makes no difference.",
            "within hearing, full",
            "canonical",
            1,
        ),
    ),
    draw=lambda frame: curves(frame, "touches", "n_people", label="touches"),
    say=_say,
)
