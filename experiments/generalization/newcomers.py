"""What is carried to strangers, and does it harm to take them for acquaintances?

A robot learns in 4 households and moves to people whom it never met, to a household in
which half of the people are known, or to another home with new people. An untrained
robot does the same beside it: what is below it is harm.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import FEW
from experiments.phases.records import New, Probing, Training
from experiments.phases.world import World

TOUCHES = (0, 2, 5, 10, 20, 50)

HETEROGENEITY = (0.0, 0.3, 1.0)

NEW: dict[str, tuple[tuple[New, ...], int]] = {
    "new people": (("people",), 0),
    "half of them known": (("people",), 2),
    "new people, new home": (("people", "home"), 0),
}


def _case(new: str, h: float, decisions: int) -> tuple[Training, Probing]:
    world, (factors, known) = World(heterogeneity=h), NEW[new]
    return (
        Training(world=world, decisions=decisions),
        Probing(
            world=world, new=factors, acquaintances=known, touches=TOUCHES, households=2
        ),
    )


CASES = {
    (new, f"{h:g}", "trained"): _case(new, h, 1_500)
    for new in NEW
    for h in HETEROGENEITY
} | {
    ("new people", f"{h:g}", "untrained"): _case("new people", h, 0)
    for h in HETEROGENEITY
}


def _contrast(text: str, learner: str, h: str, touches: int, *, harm: bool) -> Contrast:
    levels = {
        "learner": learner,
        "new": "new people",
        "heterogeneity": h,
        "touches": touches,
    }
    sides = [{**levels, "training": each} for each in ("trained", "untrained")]
    more, less = reversed(sides) if harm else sides
    return Contrast(text=text, more=more, less=less)


INQUIRY = Inquiry(
    name="newcomers",
    question="What is carried over to people whom the robot never met?",
    conditions=every(FEW, CASES, ("new", "heterogeneity", "training")),
    contrasts=(
        _contrast(
            "Pooled views serve strangers at once.",
            "within hearing, full",
            "0.3",
            0,
            harm=False,
        ),
        _contrast(
            "A canonical form, which keeps names, brings nothing.",
            "canonical",
            "0.3",
            0,
            harm=False,
        ),
        _contrast(
            "What was learned of others still helps after 20 touches.",
            "within hearing, full",
            "0.3",
            20,
            harm=False,
        ),
        _contrast(
            "What was learned of others harms where everybody has a taste of its own.",
            "within hearing, full",
            "1",
            20,
            harm=True,
        ),
        _contrast(
            "Hierarchical pooling is not harmed where everybody has a taste of its "
            "own.",
            "within hearing, hierarchical",
            "1",
            20,
            harm=True,
        ),
    ),
    draw=lambda frame: curves(
        frame.filter(pl.col("training") == "trained", pl.col("heterogeneity") == "0.3"),
        "touches",
        "new",
        label="touches in the new household",
    ),
)
