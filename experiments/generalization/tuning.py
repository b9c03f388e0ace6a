"""Tunes learners on validation, with an equal budget for each.

Every table is tried with the same settings of exploration, and every network with as
many settings of its own, on the same seeds, in households whose people and homes are of
the split `validation`. The setting with the highest score wins: the mean of what it
holds best and of what it does, after 20 touches among strangers.

    household study tuning --out RUNS
    python -m experiments.generalization.tuning RUNS
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from experiments.generalization.inquiry import Inquiry, studies
from experiments.generalization.learners import (
    LEARNERS,
    NETWORKS,
    TUNED,
    slug,
    with_setting,
)
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.world import World
from experiments.running.files import to_json, write_text

if TYPE_CHECKING:
    import polars

DRAWS = 64
"""Settings that each learner is tried with."""

SEEDS = 3

RULES = {
    "softmax": ("temperature", 0.01, 1.0),
    "epsilon_greedy": ("epsilon", 0.02, 0.5),
    "upper_confidence": ("width", 0.1, 2.0),
}
"""Rule -> its parameter and between what it is drawn, evenly by its logarithm."""

OF_NETWORKS: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "network per person": {"epsilon": (0.02, 0.5), "learning_rate": (1e-4, 1e-2)},
    "PPO": {"learning_rate": (1e-4, 1e-2), "ent_coef": (1e-3, 1e-1)},
}
"""Network -> its parameters and between what they are drawn, likewise."""

ROLLOUTS, GAMMAS = (16, 32, 64, 128), (0.0, 0.5, 0.9)
"""Of PPO: choices between updates, of which half are a batch; discounts."""

_SEED = 20_080_312  # the date of HRI 2008


def drawn(n: int = DRAWS) -> tuple[dict[str, Any], ...]:
    """Returns settings of exploration; fewer are the first ones of more."""
    rng = np.random.default_rng(_SEED)
    found = []
    for number in range(n):
        name = tuple(RULES)[number % len(RULES)]
        parameter, low, high = RULES[name]
        value = float(np.exp(rng.uniform(np.log(low), np.log(high))))
        found.append({"name": name, parameter: float(f"{value:.3g}")})
    return tuple(found)


def drawn_for(name: str, n: int = DRAWS) -> tuple[dict[str, Any], ...]:
    """Returns the settings that a learner is tried with."""
    if name not in NETWORKS:
        return drawn(n)
    rng = np.random.default_rng((_SEED, len(name)))
    return tuple(_of_network(name, rng) for _ in range(n))


def _of_network(name: str, rng: np.random.Generator) -> dict[str, Any]:
    setting: dict[str, Any] = {
        parameter: float(f"{np.exp(rng.uniform(np.log(low), np.log(high))):.3g}")
        for parameter, (low, high) in OF_NETWORKS[name].items()
    }
    if name == "PPO":
        n_steps = int(rng.choice(ROLLOUTS))
        setting |= {"n_steps": n_steps, "batch_size": n_steps // 2}
        setting["gamma"] = float(rng.choice(GAMMAS))
    return setting


def conditions(draws: int = DRAWS) -> tuple[Phases, ...]:
    """Returns every learner with every setting."""
    world = World()
    return tuple(
        Phases(
            name=f"{slug(name)}-{number:02d}",
            learner=learner,
            learner_overrides=settings,
            factors={"learner": name, "setting": str(number)},
            training=Training(world=world, households=2),
            probing=Probing(
                world=world,
                new=("people", "home"),
                split="validation",
                households=2,
                touches=(20,),
            ),
        )
        for name in (*LEARNERS, *NETWORKS)
        for number, setting in enumerate(drawn_for(name, draws))
        for learner, settings in [with_setting(name, setting)]
    )


def winners(frame: polars.DataFrame) -> dict[str, Any]:
    """Returns the document that is published.

    Args:
        frame: The table of the study; it may hold fewer settings, but the same for all.
    """
    import polars as pl

    scored = frame.with_columns(
        ((pl.col("greedy") + pl.col("deployed")) / 2).alias("score")
    ).filter(pl.col("score").is_not_nan())
    means = scored.group_by("learner", "setting").agg(pl.col("score").mean())
    ordered = means.sort("score", "setting", descending=[True, False])
    best = ordered.unique("learner", keep="first", maintain_order=True)
    chosen = {row["learner"]: row for row in best.to_dicts()}
    names = [name for name in (*LEARNERS, *NETWORKS) if name in chosen]
    return {
        "draws": frame["setting"].n_unique(),
        "seeds": frame["seed"].n_unique(),
        "winners": {
            name: drawn_for(name)[int(chosen[name]["setting"])] for name in names
        },
        "scores": {name: round(chosen[name]["score"], 3) for name in names},
    }


INQUIRY = Inquiry(
    name="tuning",
    question="With which settings is each learner at its best?",
    conditions=conditions(),
    seeds=SEEDS,
)


def main(out: Path, draws: int = DRAWS, seeds: int = SEEDS) -> None:
    """Writes the winners of stored trials beside this file."""
    from dataclasses import replace

    from experiments.running.store import Results

    inquiry = replace(INQUIRY, conditions=conditions(draws))
    study = studies(inquiry, tuple(range(seeds)))[-1]
    frame = Results(out / INQUIRY.name).read(study)
    write_text(TUNED, to_json(winners(frame)))


if __name__ == "__main__":
    main(Path(sys.argv[1]), *map(int, sys.argv[2:]))
