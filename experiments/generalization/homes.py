"""What does a home change? Another one, a larger one; with and without hearing.

The people stay. Nothing in a situation depends on the home unless it says who would
hear the robot: without that, the study is its own control.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import bars
from experiments.generalization.inquiry import Inquiry
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

LEARNERS = (
    "canonical",
    "views",
    "within hearing, full",
    "within hearing, hierarchical",
    "nested",
)

TOUCHES = (0, 20)


def _cases(hears: bool) -> dict[tuple[str, ...], tuple[Training, Probing]]:
    world, large = World(hears=hears), World(hears=hears, home="large")
    said = "heard" if hears else "not heard"
    training = Training(world=world)
    return {
        ("same home", said): (training, Probing(world=world, touches=TOUCHES)),
        ("new home", said): (
            training,
            Probing(world=world, new=("home",), touches=TOUCHES),
        ),
        ("larger home", said): (
            training,
            Probing(
                world=large,
                new=("home",),
                split="out_of_distribution",
                touches=TOUCHES,
            ),
        ),
    }


CASES = _cases(hears=True) | _cases(hears=False)


def _contrast(text: str, learner: str, home: str, hearing: str) -> Contrast:
    levels = {"learner": learner, "hearing": hearing, "touches": 0}
    return Contrast(
        text=text, more={**levels, "new": "same home"}, less={**levels, "new": home}
    )


INQUIRY = Inquiry(
    name="homes",
    question="What is lost in a home that the robot never saw?",
    seeds=10,
    conditions=every(LEARNERS, CASES, ("new", "hearing")),
    contrasts=(
        _contrast(
            "Views lose in a new home.", "within hearing, full", "new home", "heard"
        ),
        _contrast(
            "Views lose in a larger home.",
            "within hearing, full",
            "larger home",
            "heard",
        ),
        _contrast(
            "Without hearing in the situation, a new home takes nothing.",
            "views",
            "new home",
            "not heard",
        ),
        Contrast(
            text="Hearing in the view helps in a larger home.",
            more={
                "learner": "within hearing, full",
                "new": "larger home",
                "hearing": "heard",
                "touches": 0,
            },
            less={
                "learner": "within hearing, full",
                "new": "larger home",
                "hearing": "not heard",
                "touches": 0,
            },
        ),
    ),
    draw=lambda frame: bars(
        frame.filter(pl.col("touches") == 0, pl.col("hearing") == "heard"), "new"
    ),
)
