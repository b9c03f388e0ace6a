"""Scoring one policy, and the references beside it, in one household drawn by seed.

A household is one trial: it is drawn from a family, a learner of the catalog is trained
in it, then everything is frozen and scored. Whatever policy is under test, a seed gives
the same household, the same probe set and the same episodes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from experiments.scoring.lookahead import Deviation, deviation
from experiments.scoring.moments import ProbeSet, probe_set
from experiments.scoring.policies import (
    Act,
    Policy,
    Specification,
    of_learner,
    of_robots,
    specification,
)
from experiments.scoring.references import Reference, references
from experiments.scoring.scores import Lived, live, probe_score

if TYPE_CHECKING:
    from household.environment import Household
    from learners.learner import Learner

PROBE_WALKS, PROBE_STEPS = 2, 900
"""Walks that a household's probe set is drawn from, and their length [steps]."""

PLAYED_OUT = 12
"""Moments of each household at which every behavior is played out."""

DRAWS = 4
"""How often a policy that explores chooses at each moment of a probe set."""

LOOKAHEAD_STEPS = 400
"""Steps that the lookahead reference lives for: it is dear, and rates do not need
more."""

POLICY = "policy"
"""What the policy under test is called beside its references."""


@dataclass(frozen=True, kw_only=True)
class Task:
    """One household to score a policy in."""

    family: str
    """A shipped family's name or a TOML path."""

    seed: int
    """Draws the household and its episodes."""

    policy: str | Act | Learner
    """What is scored, as `specification` takes it."""

    training: int
    """Decisions that a learner of the catalog learns for in this household first."""

    steps: int | None
    """Steps of the lived episodes at most; None: as many as the family's have."""

    def __str__(self) -> str:
        """Returns e.g. `party, seed 7`."""
        return f"{self.family}, seed {self.seed}"


@dataclass(frozen=True, kw_only=True)
class Scores:
    """What one policy came to in one household; NaN where it cannot be measured."""

    probe_greedy: float
    probe_deployed: float
    lived: Lived


@dataclass(frozen=True, kw_only=True)
class Scored:
    """What came of one task."""

    family: str
    seed: int
    people: int
    robots: int
    moments: int
    """Size of the probe set."""

    share: float
    """What share that is of all moments of its walks."""

    deviation: Deviation | None
    """How far foretold verdicts were from those that followed."""

    scores: Mapping[str, Scores]
    """By name: `policy`, then the references."""


def score(task: Task) -> Scored:
    """Scores a policy and its references in one household.

    Args:
        task: All that the result depends on.

    Raises:
        ExperimentError: If the policy returns no behavior or does not fit.
        HouseholdError: If the household cannot be drawn.
    """
    from household import household_v0
    from household.scenario.family import draw

    scenario, asked = draw(task.family, task.seed), specification(task.policy)
    env = household_v0.parallel_env(scenario, observation=asked.encoding)
    training, choosing, drawing, probing, living, playing = _streams(task.seed)
    policy = _policy(
        asked, env, task.training, training, np.random.default_rng(choosing)
    )
    probes = probe_set(env, _seeds(probing, PROBE_WALKS), PROBE_STEPS)
    (life,) = _seeds(living, 1)
    scores = {POLICY: _of_policy(policy, probes, env, life, task.steps)}
    scores |= _of_references(env, probes, drawing, life, task.steps)
    return Scored(
        family=task.family,
        seed=task.seed,
        people=len(scenario.people),
        robots=len(scenario.robots),
        moments=len(probes.moments),
        share=probes.share,
        deviation=deviation(env, life, PLAYED_OUT, np.random.default_rng(playing)),
        scores=scores,
    )


def score_references(
    env: Household, seed: int, steps: int | None = None
) -> Mapping[str, Scores]:
    """Scores the reference policies alone, in any household.

    Args:
        env: The household.
        seed: Of the probe set, the episodes and what is drawn in them.
        steps: Of the lived episodes at most; None: as many as the household's have.

    Returns:
        Scores by the name of the reference.
    """
    _, _, drawing, probing, living, _ = _streams(seed)
    probes = probe_set(env, _seeds(probing, PROBE_WALKS), PROBE_STEPS)
    (life,) = _seeds(living, 1)
    return _of_references(env, probes, drawing, life, steps)


def _streams(seed: int) -> list[np.random.SeedSequence]:
    """Streams of their own, so that one more draw in one shifts nothing in another."""
    return np.random.SeedSequence(seed, spawn_key=(1,)).spawn(6)


def _seeds(sequence: np.random.SeedSequence, n: int) -> tuple[int, ...]:
    return tuple(int(word) for word in sequence.generate_state(n))


def _policy(
    asked: Specification,
    env: Household,
    decisions: int,
    seed: np.random.SeedSequence,
    rng: np.random.Generator,
) -> Policy:
    """The policy under test; a learner of the catalog is trained first."""
    if asked.make is not None:
        return asked.make(env.behaviors, rng)
    learners = trained(asked.name, env, decisions, seed)
    return of_robots({agent: of_learner(each, rng) for agent, each in learners.items()})


def trained(
    name: str, env: Household, decisions: int, seed: np.random.SeedSequence
) -> dict[str, Learner]:
    """Lets a learner of the catalog learn in a household, one for each robot.

    Args:
        name: In the catalog.
        env: The household.
        decisions: Steps to learn for at least, in whole episodes.
        seed: Of the learners and of the episodes.
    """
    from experiments.running.study import Condition
    from experiments.running.trial import make_robots
    from policies.learning import run_episode

    learning, living = seed.spawn(2)
    condition = Condition(name="policy", scenario=env.scenario.name, learner=name)
    robots, watching = make_robots(condition, env, learning)
    for life in _seeds(living, -(-decisions // env.max_cycles)):
        run_episode(env, robots, seed=life, observers=watching)
    return {agent: robot.learner for agent, robot in robots.items()}


def _of_policy(
    policy: Policy, probes: ProbeSet, env: Household, life: int, steps: int | None
) -> Scores:
    """The scores of a policy that sees what a robot may know."""
    sights = [moment.sight() for moment in probes.moments]
    draws = [policy.deployed(sight) for _ in range(DRAWS) for sight in sights]
    return Scores(
        probe_greedy=probe_score([policy.greedy(s) for s in sights], probes.moments),
        probe_deployed=probe_score(draws, probes.moments * DRAWS),
        lived=live(env, lambda now: policy.deployed(now.sight()), life, steps),
    )


def _of_references(
    env: Household,
    probes: ProbeSet,
    drawing: np.random.SeedSequence,
    life: int,
    steps: int | None,
) -> dict[str, Scores]:
    """The scores of all references."""
    return {
        name: _of_reference(each, probes, env, life, steps)
        for name, each in references(env, np.random.default_rng(drawing)).items()
    }


def _of_reference(
    reference: Reference, probes: ProbeSet, env: Household, life: int, steps: int | None
) -> Scores:
    """The scores of a reference, which does what it holds best."""
    moments = probes.moments if reference.on_probes else ()
    score = probe_score([reference.choose(each) for each in moments], moments)
    if not reference.on_probes:
        steps = min(steps or LOOKAHEAD_STEPS, LOOKAHEAD_STEPS)
    return Scores(
        probe_greedy=score,
        probe_deployed=score,
        lived=live(env, reference.choose, life, steps),
    )
