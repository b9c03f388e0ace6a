"""At which heterogeneity does taking people for alike turn from gain to harm?

Two cases: two people exchange their days; two people move in whom the robot never met.
Gain and harm are against the same representation without any pooling over people.
"""

from __future__ import annotations

import math

import numpy as np
import polars as pl

from experiments.analysis.crossings import crossing_of_seeds
from experiments.analysis.preregistered import Contrast, Result
from experiments.analysis.statistics import Estimate
from experiments.generalization.building import every
from experiments.generalization.drawing import curves
from experiments.generalization.inquiry import Inquiry
from experiments.generalization.learners import FEW
from experiments.phases.records import New, Probing, Training
from experiments.phases.world import World

LEVELS = (0.0, 0.25, 0.5, 0.75, 1.0)

NEW: dict[str, tuple[New, ...]] = {"swap": ("swap",), "new people": ("people",)}

TOUCHES = (0, 20)

COMPARED = {
    "canonical": "whole situation",
    "adaptive analogy": "whole situation",
    "within hearing, full": "within hearing, none",
    "within hearing, hierarchical": "within hearing, none",
    "within hearing, adaptive": "within hearing, none",
    "nested": "within hearing, none",
}
"""Who takes people for alike -> the same without."""


def _world(h: float) -> World:
    return World(people=2, days=True, heterogeneity=h)


CASES = {
    (case, f"{h:g}"): (
        Training(world=_world(h)),
        Probing(world=_world(h), new=new, touches=TOUCHES),
    )
    for case, new in NEW.items()
    for h in LEVELS
}


def crossings(frame: pl.DataFrame, touches: int) -> dict[tuple[str, str], Estimate]:
    """Returns, by case and learner, the heterogeneity at which gain turns to harm."""
    found = {}
    for case in NEW:
        for learner, without in COMPARED.items():
            rows = frame.filter(pl.col("new") == case, pl.col("touches") == touches)
            gain = _by_seed(rows, learner) - _by_seed(rows, without)
            known = gain[~np.isnan(gain).any(axis=1)]
            if len(known):
                found[case, learner] = crossing_of_seeds(LEVELS, known)
    return found


def _by_seed(rows: pl.DataFrame, learner: str) -> np.ndarray:
    """Mean score of each seed at each heterogeneity, shape (n_seeds, n_levels)."""
    means = (
        rows.filter(pl.col("learner") == learner, pl.col("greedy").is_not_nan())
        .group_by("seed", "heterogeneity")
        .agg(pl.col("greedy").mean())
        .pivot(on="heterogeneity", index="seed", values="greedy")
        .sort("seed")
    )
    return means.select([f"{h:g}" for h in LEVELS]).to_numpy()


def _say(frame: pl.DataFrame, results: tuple[Result, ...]) -> tuple[str, ...]:
    del results
    sentences = []
    for touches in TOUCHES:
        for (case, learner), at in crossings(frame, touches).items():
            sentences.append(
                f"After {touches} touches, {case}: {learner} against "
                f"{COMPARED[learner]} {in_words(at)}."
            )
    return tuple(sentences)


def in_words(at: Estimate) -> str:
    """Returns where gain turns to harm, in words."""
    if math.isinf(at.value):
        low = "never" if math.isinf(at.low) else f"{at.low:.2f}"
        return f"never turns from gain to harm (interval from {low})"
    if at.value == 0.0:
        high = "without an end" if math.isinf(at.high) else f"up to {at.high:.2f}"
        return f"gains nothing even among equals (interval {high})"
    return (
        f"turns from gain to harm at h = {at.value:.2f} "
        f"[{_end(at.low)}, {_end(at.high)}]"
    )


def _end(value: float) -> str:
    return "never" if math.isinf(value) else f"{value:.2f}"


def _contrast(text: str, more: str, less: str, **levels: object) -> Contrast:
    return Contrast(
        text=text, more={"learner": more, **levels}, less={"learner": less, **levels}
    )


INQUIRY = Inquiry(
    name="heterogeneity",
    question="At which heterogeneity does analogy turn from gain to harm?",
    conditions=every(FEW, CASES, ("new", "heterogeneity")),
    contrasts=(
        _contrast(
            "Among equals a canonical form gains from a swap.",
            "canonical",
            "whole situation",
            new="swap",
            heterogeneity="0",
            touches=0,
        ),
        _contrast(
            "Where everybody has a taste of its own, a canonical form harms.",
            "whole situation",
            "canonical",
            new="swap",
            heterogeneity="1",
            touches=0,
        ),
        _contrast(
            "Among equals, pooled views within hearing serve strangers.",
            "within hearing, full",
            "within hearing, none",
            new="new people",
            heterogeneity="0",
            touches=0,
        ),
        _contrast(
            "Where everybody has a taste of its own, pooled views harm after 20 "
            "touches.",
            "within hearing, none",
            "within hearing, full",
            new="new people",
            heterogeneity="1",
            touches=20,
        ),
        _contrast(
            "Hierarchical pooling does less harm than full pooling where everybody "
            "has a taste of its own.",
            "within hearing, hierarchical",
            "within hearing, full",
            new="new people",
            heterogeneity="1",
            touches=20,
        ),
        _contrast(
            "Among equals, full pooling is better than hierarchical pooling.",
            "within hearing, full",
            "within hearing, hierarchical",
            new="new people",
            heterogeneity="0",
            touches=0,
        ),
    ),
    draw=lambda frame: curves(
        frame.filter(pl.col("touches") == 0), "heterogeneity", "new", label="h"
    ),
    say=_say,
)
