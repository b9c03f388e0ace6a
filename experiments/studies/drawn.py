"""Studies on households drawn by seed: learn in one, freeze, probe in it or in another.

A trial draws a household, lets a robot learn in it, freezes what it learned and takes
its probe score, there or in a household of which something is drawn anew.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from experiments.phases.robots import Diary
from experiments.running.study import Condition, Trial
from experiments.running.trial import describe, make_learner_of
from experiments.scoring.moments import ProbeSet, probe_set
from experiments.scoring.policies import of_learner
from experiments.scoring.scores import probe_score
from policies.learning import LearningRobot, run_episode

if TYPE_CHECKING:
    import polars

    from household.environment import Household
    from learners.learner import Learner

WALKS, STEPS = 2, 900
"""Reference walks that a probe set is drawn from, and their length [steps]."""

DRAWS = 4
"""How often a learner that explores chooses at each moment of a probe set."""

Factor = Literal["home", "people", "roles"]


@dataclass(frozen=True, kw_only=True)
class Households:
    """Which households a study draws, and for how long a robot learns in one."""

    family: Mapping[str, Any]
    """The family, as plain data."""

    draw: Mapping[str, Any] = field(default_factory=dict)
    """Fields of `Draw` that all seeds share, such as the number of people."""

    decisions: int
    """Environment steps that the robot learns for."""

    anew: tuple[Factor, ...] = ()
    """What is drawn anew for the household that it is probed in; none: the same one."""


def describe_learner(condition: Condition) -> dict[str, Any]:
    """Returns a condition with every setting of its learner, as plain data."""
    return {
        "factors": dict(condition.factors),
        "learner": condition.learner,
        "settings": describe(make_learner_of(condition)),
    }


def score(trial: Trial, households: Households) -> polars.DataFrame:
    """Runs one trial.

    Args:
        trial: The learner, and the seed that draws the household.
        households: What is drawn.

    Returns:
        One row: `greedy` and `deployed` (probe scores), `best_constant` (that of the
        best constant behavior, in hindsight), `touches`, `choices`, `met` (share of the
        choices made in a situation that was met before), `moments` and `share` (of the
        probe set).
    """
    import polars as pl

    seeds = np.random.SeedSequence(trial.seed, spawn_key=(3,)).spawn(4)
    learning, living, probing, choosing = seeds
    env = _household(households, trial.seed, max(households.decisions, 1))
    learner = make_learner_of(
        trial.condition, len(env.behaviors), np.random.default_rng(learning)
    )
    diary = _learned(learner, env, households.decisions, living)
    other = _household(households, trial.seed, STEPS, households.anew)
    words = probing.generate_state(WALKS)
    probes = probe_set(other, [int(word) for word in words], STEPS)
    policy = of_learner(learner, np.random.default_rng(choosing))
    sights = [moment.sight() for moment in probes.moments]
    drawn = [policy.deployed(sight) for _ in range(DRAWS) for sight in sights]
    return pl.DataFrame(
        {
            "greedy": probe_score([policy.greedy(s) for s in sights], probes.moments),
            "deployed": probe_score(drawn, probes.moments * DRAWS),
            "best_constant": _best_constant(probes, len(env.behaviors)),
            **diary,
            "moments": len(probes.moments),
            "share": probes.share,
        }
    )


def _household(
    households: Households, seed: int, steps: int, anew: tuple[Factor, ...] = ()
) -> Household:
    """The household that a seed draws, or one of which something is drawn anew."""
    from household import household_v0
    from household.config.toml import convert
    from household.scenario.family import Draw, Family, draw

    family = convert(dict(households.family), Family, "family")
    own = _drawn(seed)
    others = _drawn(seed, again=True)
    drawn = own | {each: others[each] for each in anew}
    choice = convert({"seed": seed, **drawn, **households.draw}, Draw, "draw")
    return household_v0.parallel_env(draw(family, choice), max_cycles=steps)


def _drawn(seed: int, *, again: bool = False) -> dict[str, int]:
    """Seeds of what is drawn; drawn again, each is another one."""
    words = np.random.SeedSequence(seed, spawn_key=(4, int(again))).generate_state(3)
    return {
        name: int(word)
        for name, word in zip(("home", "people", "roles"), words, strict=True)
    }


def _learned(
    learner: Learner,
    env: Household,
    decisions: int,
    seed: np.random.SeedSequence,
) -> dict[str, float]:
    """Lets one robot learn for an episode; what it lived through, in numbers."""
    watch = Diary()
    if decisions:
        robots = {agent: LearningRobot(learner) for agent in env.possible_agents}
        episode = int(seed.generate_state(1)[0])
        run_episode(env, robots, seed=episode, observers=[watch])
    return {
        "touches": watch.touches,
        "choices": watch.choices,
        "met": watch.met / max(watch.choices, 1),
    }


def _best_constant(probes: ProbeSet, n_behaviors: int) -> float:
    """The probe score of the constant behavior that comes off best."""
    moments = probes.moments
    return max(
        probe_score([behavior] * len(moments), moments)
        for behavior in range(n_behaviors)
    )
