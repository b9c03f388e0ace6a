"""What is carried over to new roles, and what a swap is worth with its control.

Two people, each with a day of two activities. A robot learns in 4 households and is
probed in the same ones: as they were, after the two exchanged their days, with days of
which the pair is new, and after an exchange between people who agree in nothing.
"""

from __future__ import annotations

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import bars
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import LEARNERS
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

AGREE = World(people=2, days=True, heterogeneity=0.0)
DISAGREE = World(people=2, days=True, opposed=True)

TOUCHES = (0, 5, 20)

CASES = {
    ("nothing new",): (
        Training(world=AGREE),
        Probing(world=AGREE, touches=TOUCHES),
    ),
    ("new roles",): (
        Training(world=AGREE),
        Probing(world=AGREE, new=("roles",), touches=TOUCHES),
    ),
    ("swap",): (
        Training(world=AGREE),
        Probing(world=AGREE, new=("swap",), touches=TOUCHES),
    ),
    ("swap, opposed people",): (
        Training(world=DISAGREE),
        Probing(world=DISAGREE, new=("swap",), touches=TOUCHES),
    ),
}


def contrast(text: str, more: str, less: str, new: str) -> Contrast:
    """Returns that one learner is better than another, frozen, in one case."""
    levels = {"new": new, "touches": 0}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


INQUIRY = Inquiry(
    name="transfer",
    question="What is carried over when people exchange their roles?",
    conditions=every(LEARNERS, CASES, ("new",)),
    contrasts=(
        contrast(
            "A canonical form gains from an exact swap.",
            "canonical",
            "whole situation",
            "swap",
        ),
        contrast(
            "A canonical form harms where the swapped people want different things.",
            "whole situation",
            "canonical",
            "swap, opposed people",
        ),
        contrast(
            "Adaptive analogy gains from an exact swap.",
            "adaptive analogy",
            "whole situation",
            "swap",
        ),
        contrast(
            "Adaptive analogy does less harm than a canonical form where people "
            "disagree.",
            "adaptive analogy",
            "canonical",
            "swap, opposed people",
        ),
        contrast(
            "Views within hearing carry over more of a swap than a canonical form.",
            "within hearing, full",
            "canonical",
            "swap",
        ),
        contrast(
            "Views within hearing carry over to pairs of roles that are new.",
            "within hearing, full",
            "canonical",
            "new roles",
        ),
    ),
    draw=lambda frame: bars(frame.filter(frame["touches"] == 0), "new"),
)
