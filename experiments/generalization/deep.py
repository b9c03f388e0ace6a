"""Neural baselines beside tables, with the same budget of touches, and with plenty.

Needs the extra `deep`. The network looks at the features of each person; the tables at
what situations say.
"""

from __future__ import annotations

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import bars
from experiments.generalization.inquiry import Inquiry
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.world import World

WORLD = World()

BUDGETS = {"as the others": (2, 1_500), "plenty": (8, 4_000)}
"""Households of training, and steps in each."""

NETWORK = "network per person"


def _phases(budget: str) -> tuple[Training, Probing]:
    households, decisions = BUDGETS[budget]
    return (
        Training(world=WORLD, households=households, decisions=decisions),
        Probing(world=WORLD, new=("people", "home"), households=2, touches=(0, 20)),
    )


def conditions() -> tuple[Phases, ...]:
    """Returns the networks, and tables and references beside them."""
    cases = {(budget,): _phases(budget) for budget in BUDGETS}
    tables = every(
        ("canonical", "within hearing, full", "within hearing, hierarchical", "nested"),
        cases,
        ("budget",),
    )
    networks = tuple(
        Phases(
            name=f"network-{budget.replace(' ', '_')}",
            learner="experiments.deep.per_person:network",
            factors={"learner": NETWORK, "budget": budget},
            training=training,
            probing=probing,
        )
        for (budget,), (training, probing) in cases.items()
    )
    return tables + networks


def _contrast(text: str, more: str, less: str, budget: str) -> Contrast:
    levels = {"budget": budget, "touches": 0}
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


INQUIRY = Inquiry(
    name="deep",
    question="Do networks carry over more than tables?",
    seeds=10,
    conditions=conditions(),
    contrasts=(
        _contrast(
            "With the same touches, nested views beat a network per person.",
            "nested",
            NETWORK,
            "as the others",
        ),
        _contrast(
            "A network per person beats canonical situations.",
            NETWORK,
            "canonical",
            "as the others",
        ),
        _contrast(
            "With plenty, a network per person is ahead of views within hearing.",
            NETWORK,
            "within hearing, full",
            "plenty",
        ),
    ),
    draw=lambda frame: bars(frame.filter(frame["touches"] == 0), "budget"),
)
