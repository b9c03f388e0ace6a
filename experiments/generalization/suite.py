"""The leaderboard: all learners on the whole suite.

In each family a robot learns in two households and moves to one with other people, in
another home, with other roles; it adapts for 20 touches and then lives there. Networks
(extra `deep`) do so, too; what they reach with plenty of training is in `deep`.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis.preregistered import Contrast, Result
from experiments.generalization.building import every
from experiments.generalization.drawing import bars
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import LEARNERS, NETWORKS
from experiments.phases.records import Probing, Training
from experiments.phases.world import World
from household.config.toml import shipped

FAMILIES = tuple(sorted(shipped("family")))

LIVED = 400
"""Steps of living there: the lookahead reference is dear."""


def _world(family: str) -> World:
    return World(family=family)


CASES = {
    (family,): (
        Training(world=_world(family), households=2),
        Probing(
            world=_world(family),
            new=("people", "home", "roles"),
            households=1,
            touches=(0, 20),
            lived=LIVED,
        ),
    )
    for family in FAMILIES
}

REFERENCES = ("random", "persona", "population", "lookahead")


def lived_share(frame: pl.DataFrame, learner: str) -> float:
    """Returns where between random (0) and lookahead (1) somebody's life is.

    Of the people's verdicts in a minute, the mean over families of the share there.
    """
    shares = []
    for family in FAMILIES:
        floor, ceiling, own = (
            _verdicts(frame, name, family) for name in ("random", "lookahead", learner)
        )
        shares.append((own - floor) / (ceiling - floor))
    return sum(shares) / len(shares)


def _verdicts(frame: pl.DataFrame, learner: str, family: str) -> float:
    rows = frame.filter(
        pl.col("learner") == learner,
        pl.col("family") == family,
        pl.col("verdicts_per_minute").is_not_null(),
    )
    return float(str(rows["verdicts_per_minute"].mean()))


def _say(frame: pl.DataFrame, results: tuple[Result, ...]) -> tuple[str, ...]:
    del results
    ends = ("random", "lookahead")
    known = frame["learner"].unique(maintain_order=True)
    named = [name for name in known if name not in ends]
    ordered = sorted(named, key=lambda name: lived_share(frame, name), reverse=True)
    said = ", ".join(f"{name} {lived_share(frame, name):z.2f}" for name in ordered)
    return (f"Lived scores, random 0 and lookahead 1, mean over families: {said}.",)


def _contrast(text: str, more: str, less: str) -> Contrast:
    return Contrast(
        text=text,
        more={"learner": more, "touches": 20},
        less={"learner": less, "touches": 20},
    )


INQUIRY = Inquiry(
    name="suite",
    question="Which learner is best over the whole suite?",
    conditions=every((*LEARNERS, *NETWORKS), CASES, ("family",), REFERENCES),
    contrasts=(
        _contrast(
            "Views within hearing beat canonical situations.",
            "within hearing, full",
            "canonical",
        ),
        _contrast(
            "Hierarchical pooling beats full pooling.",
            "within hearing, hierarchical",
            "within hearing, full",
        ),
        _contrast(
            "Nested views beat plain ones within hearing.",
            "nested",
            "within hearing, full",
        ),
        _contrast(
            "Learning from exposures beats learning from touches alone.",
            "within hearing, full",
            "within hearing, by touches",
        ),
        _contrast(
            "Nested views beat a network per person.",
            "nested",
            "network per person",
        ),
        _contrast(
            "A network per person beats PPO.",
            "network per person",
            "PPO",
        ),
    ),
    draw=lambda frame: bars(frame.filter(frame["touches"] == 20), "family"),
    say=_say,
)
