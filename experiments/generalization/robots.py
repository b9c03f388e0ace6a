"""What do robots gain from each other? One, two, four; apart, sharing, carrying over.

Robots that share have one table; those that carry over keep their own and take each
other's updates at half the rate.
"""

from __future__ import annotations

from dataclasses import replace

from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import settings, slug
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.world import World
from learners.team import Sharing

ROBOTS = (1, 2, 4)

TOUCHES = (0, 20, 50)

TEAMS: dict[str, tuple[Sharing, ...]] = {
    "canonical": ("independent", "shared", "carried"),
    "within hearing, full": ("independent", "shared"),
}
"""Learner -> what its robots can have of each other; only tables of situations can be
carried over."""


def _phases(robots: int) -> tuple[Training, Probing]:
    world = World(robots=robots)
    return (
        Training(world=world, households=2, decisions=750),
        Probing(world=world, new=("people",), households=2, touches=TOUCHES),
    )


def conditions() -> tuple[Phases, ...]:
    """Returns every team of every size, and the references."""
    known = settings(TEAMS)
    teams = tuple(
        Phases(
            name=f"{slug(name)}-{sharing}-{robots}",
            learner=known[name][0],
            learner_overrides=known[name][1],
            factors={"learner": name, "sharing": sharing, "robots": str(robots)},
            sharing=sharing,
            training=_phases(robots)[0],
            probing=_phases(robots)[1],
        )
        for robots in ROBOTS
        for name, ways in TEAMS.items()
        for sharing in (ways if robots > 1 else ways[:1])
    )
    beside = every((), {("none", str(n)): _phases(n) for n in ROBOTS}, FACTORS)
    return teams + tuple(replace(each, sharing="independent") for each in beside)


FACTORS = ("sharing", "robots")


def _contrast(text: str, learner: str, more: str, less: str, robots: int) -> Contrast:
    levels = {"learner": learner, "robots": str(robots), "touches": 0}
    return Contrast(
        text=text, more={**levels, "sharing": more}, less={**levels, "sharing": less}
    )


INQUIRY = Inquiry(
    name="robots",
    question="What do robots gain from each other's experience?",
    seeds=10,
    conditions=conditions(),
    contrasts=(
        _contrast(
            "Two robots with views gain from one table.",
            "within hearing, full",
            "shared",
            "independent",
            2,
        ),
        _contrast(
            "Four robots with views gain from one table.",
            "within hearing, full",
            "shared",
            "independent",
            4,
        ),
        _contrast(
            "Two robots with situations gain from one table.",
            "canonical",
            "shared",
            "independent",
            2,
        ),
        _contrast(
            "Two robots with situations gain from what is carried over.",
            "canonical",
            "carried",
            "independent",
            2,
        ),
    ),
    draw=lambda frame: curves(
        frame.filter(frame["sharing"] != "none", frame["learner"] != "canonical"),
        "touches",
        "robots",
        label="touches in the new household",
        series="sharing",
    ),
)
