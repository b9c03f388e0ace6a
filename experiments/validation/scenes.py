"""Scenes: what is simulated, seed by seed, and the published figures it answers to."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from experiments.analysis.statistics import mean
from experiments.running.engine import Engine, run_trials
from experiments.validation.figures import Finding, Published, finding

Measured = Mapping[str, float]
"""What one seed gives, by the name of the published figure; NaN where there was nothing
to be seen."""


@dataclass(frozen=True, kw_only=True)
class Scene:
    """Something to watch, and what to hold it against."""

    name: str
    """What goes on there, for the table."""

    watch: Callable[[int], Measured]
    """Watches it once, with a seed."""

    published: tuple[Published, ...]
    """What it answers to."""

    seeds: int
    """How often it is watched."""


@dataclass(frozen=True, kw_only=True)
class Watching:
    """One scene, watched once."""

    scene: Scene
    seed: int


def watchings(scenes: Sequence[Scene]) -> list[Watching]:
    """Returns everything that is to be watched, seed by seed."""
    return [
        Watching(scene=scene, seed=seed)
        for scene in scenes
        for seed in range(scene.seeds)
    ]


def watch(
    scenes: Sequence[Scene], engine: Engine, advance: Callable[[], None]
) -> list[Finding]:
    """Watches scenes and holds what is seen against what was published.

    Args:
        scenes: With names of their own.
        engine: Where to run.
        advance: Called after each seed of each scene.

    Returns:
        The findings, scene by scene.
    """
    seen: dict[str, dict[int, Measured]] = defaultdict(dict)
    for outcome in run_trials(_watch, watchings(scenes), engine):
        if outcome.error is not None:
            raise outcome.error
        if outcome.value is not None:
            seen[outcome.trial.scene.name][outcome.trial.seed] = outcome.value
        advance()
    return [
        found
        for scene in scenes
        for found in together(scene, [seen[scene.name][s] for s in range(scene.seeds)])
    ]


def together(scene: Scene, seen: Sequence[Measured]) -> list[Finding]:
    """Returns a scene's findings, the mean over its seeds with an interval.

    Args:
        scene: What was watched.
        seen: What each seed gave; seeds in which there was nothing to see are left out.
    """
    return [
        finding(
            published,
            scene.name,
            mean([n for one in seen if not math.isnan(n := one[published.name])]),
        )
        for published in scene.published
    ]


def _watch(one: Watching) -> Measured:
    return one.scene.watch(one.seed)
