"""Neural baselines beside tables, with the same budget of touches, and with plenty.

Needs the extra `deep`. The networks look at the features of each person; the tables at
what situations say.
"""

from __future__ import annotations

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every, with_plenty
from experiments.generalization.drawing import bars
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import NETWORKS
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

WORLD = World()

SAME = Training(world=WORLD, households=2)

BUDGETS = {"as the others": SAME, "plenty": with_plenty(SAME)}

PROBING = Probing(world=WORLD, new=("people", "home"), households=2, touches=(0, 20))

TABLES = (
    "canonical",
    "within hearing, full",
    "within hearing, hierarchical",
    "nested",
)


def _contrast(text: str, more: str, less: str, budget: str) -> Contrast:
    levels = {"budget": budget, "touches": 0}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


INQUIRY = Inquiry(
    name="deep",
    question="Do networks carry over more than tables?",
    seeds=10,
    conditions=every(
        (*TABLES, *NETWORKS),
        {(budget,): (training, PROBING) for budget, training in BUDGETS.items()},
        ("budget",),
    ),
    contrasts=(
        _contrast(
            "With the same touches, nested views beat a network per person.",
            "nested",
            "network per person",
            "as the others",
        ),
        _contrast(
            "A network per person beats canonical situations.",
            "network per person",
            "canonical",
            "as the others",
        ),
        _contrast(
            "With plenty, a network per person is ahead of views within hearing.",
            "network per person",
            "within hearing, full",
            "plenty",
        ),
        _contrast(
            "With the same touches, a network per person beats PPO.",
            "network per person",
            "PPO",
            "as the others",
        ),
    ),
    draw=lambda frame: bars(frame.filter(frame["touches"] == 0), "budget"),
)
