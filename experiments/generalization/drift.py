"""Remembering against adapting: the people stay, and what they want has changed.

A robot learns in 2 households. Then everybody there wants another behavior in every
role (a change of the scenario, `household/scenario/change.py`), and the robot, which is
not told, goes on. Beside it one that begins anew.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import slug, tuned
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.world import World

BEFORE, AFTER = World(people=2), World(people=2, turned=2)

TOUCHES = (0, 5, 10, 20, 50, 100)

HOW = {
    "changed": (Training(world=BEFORE, households=2), AFTER),
    "unchanged": (Training(world=BEFORE, households=2), BEFORE),
    "begins anew": (Training(world=BEFORE, households=2, decisions=0), AFTER),
}

SILENCE = {
    "touches alone teach": ("skip_silence", {"representation": "canonical"}),
    "silence teaches 0": ("designated", {"representation": "canonical"}),
    "views: touches alone": (
        "full_sharing",
        {"representation": "audible_views", "counts": "touches"},
    ),
    "views: silence is no touch": (
        "full_sharing",
        {"representation": "audible_views", "counts": "exposures"},
    ),
}
"""What silence teaches -> learner and settings; all credit designated pairs but the
first, which has none to share."""

LIKE = {
    "touches alone teach": "canonical",
    "silence teaches 0": "canonical",
    "views: touches alone": "within hearing, by touches",
    "views: silence is no touch": "within hearing, full",
}
"""As whom each explores."""


def conditions() -> tuple[Phases, ...]:
    """Returns every learner in every case, and the references."""
    own = tuple(
        Phases(
            name=f"{slug(name).replace(':', '')}-{slug(case)}",
            learner=learner,
            learner_overrides={**settings, "exploration": dict(tuned()[LIKE[name]])},
            factors={"learner": name, "tastes": case},
            training=training,
            probing=Probing(world=world, households=2, touches=TOUCHES),
        )
        for case, (training, world) in HOW.items()
        for name, (learner, settings) in SILENCE.items()
    )
    cases = {
        ("changed",): (HOW["changed"][0], Probing(world=AFTER, households=2)),
    }
    return own + every((), cases, ("tastes",))


def _contrast(text: str, more: str, less: str, tastes: str) -> Contrast:
    levels = {"touches": 20, "tastes": tastes}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


def _harm(text: str, learner: str, touches: int) -> Contrast:
    levels = {"learner": learner, "touches": touches}
    return Contrast(
        text=text,
        more={**levels, "tastes": "begins anew"},
        less={**levels, "tastes": "changed"},
    )


INQUIRY = Inquiry(
    name="drift",
    question="What does remembering cost when tastes change?",
    conditions=conditions(),
    contrasts=(
        _contrast(
            "Where tastes have changed, who learns from silence adapts sooner.",
            "silence teaches 0",
            "touches alone teach",
            "changed",
        ),
        _contrast(
            "Where they have not, learning from silence costs.",
            "touches alone teach",
            "silence teaches 0",
            "unchanged",
        ),
        _contrast(
            "With views, counting silence as no touch helps to adapt.",
            "views: silence is no touch",
            "views: touches alone",
            "changed",
        ),
        _harm(
            "After 20 touches a robot that begins anew is ahead of one with views "
            "that remembers.",
            "views: silence is no touch",
            20,
        ),
        _harm(
            "After 100 touches a robot that begins anew still is ahead.",
            "views: silence is no touch",
            100,
        ),
    ),
    draw=lambda frame: curves(
        frame.filter(pl.col("learner").is_in(tuple(SILENCE))),
        "touches",
        "tastes",
        label="touches since",
    ),
)
