"""Under which teachers does each method work?

The people of training teach as usual; those that are probed have other habits of
feedback, and the robot adapts to them: people who praise more than they sanction, as
most do, or who tire of it, and the kinds of B-Pref (Lee et al., 2021: mistaken,
skipping, noisy, myopic).
"""

from __future__ import annotations

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import FEW
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

TEACHERS = {
    "as usual": World(),
    **{
        kind: World(persona=kind)
        for kind in (
            *("praising", "fading", "silent"),
            *("mistaken", "skipping", "noisy", "myopic"),
        )
    },
    "punishing": World(persona="punisher"),
}
"""Kind -> the world in which everybody is so; each is a shipped persona
(`docs/people.md`)."""

TOUCHES = (0, 10, 20, 50)

CASES = {
    (name,): (
        Training(world=World(), households=2),
        Probing(
            world=world,
            new=("people",),
            split="out_of_distribution",
            households=2,
            touches=TOUCHES,
        ),
    )
    for name, world in TEACHERS.items()
}


def _contrast(text: str, more: str, less: str, teacher: str) -> Contrast:
    levels = {"teacher": teacher, "touches": 50}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


def _harm(text: str, teacher: str) -> Contrast:
    levels = {"learner": "within hearing, full", "touches": 50}
    return Contrast(
        text=text,
        more={**levels, "teacher": "as usual"},
        less={**levels, "teacher": teacher},
    )


INQUIRY = Inquiry(
    name="teachers",
    question="Under which teachers does each method work?",
    seeds=10,
    conditions=every(FEW, CASES, ("teacher",)),
    contrasts=(
        _contrast(
            "Under mistaken teachers, views still beat canonical situations.",
            "within hearing, full",
            "canonical",
            "mistaken",
        ),
        _contrast(
            "Under silent teachers, views still beat canonical situations.",
            "within hearing, full",
            "canonical",
            "silent",
        ),
        _harm("A tenth of wrong touches harms views.", "mistaken"),
        _harm("Faint feelings told the wrong way round harm views.", "noisy"),
        _harm("Touches for what was done last harm views.", "myopic"),
        _harm("Praise without sanction teaches views less.", "praising"),
    ),
    draw=lambda frame: curves(
        frame, "touches", "teacher", label="touches from these teachers"
    ),
)
