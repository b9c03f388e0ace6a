"""`experiments.evaluate`: scores anybody's policy on the suite, beside references."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from experiments.analysis.statistics import Estimate, mean
from experiments.errors import ExperimentError, unknown
from experiments.running.engine import Engine, run_trials
from experiments.scoring.households import Scored, Scores, Task, score
from experiments.scoring.policies import Act, specification

if TYPE_CHECKING:
    from learners.learner import Learner

TRAINING = 1_800
"""Decisions that a learner of the catalog learns for in each household; 30 minutes."""

ALL = "all"
"""Every family that is shipped."""


@dataclass(frozen=True, kw_only=True)
class Summary:
    """What one policy came to over the households of a family.

    Shares put lived scores between random (0) and the lookahead reference (1).
    """

    probe_greedy: Estimate
    probe_deployed: Estimate
    verdicts_per_minute: Estimate
    verdicts_per_bout: Estimate
    share_per_minute: float
    share_per_bout: float
    caresses_per_minute: Estimate
    taps_per_minute: Estimate
    reward_per_minute: Estimate
    opinion: Estimate


@dataclass(frozen=True, kw_only=True)
class FamilyEvaluation:
    """The scores in one family."""

    family: str
    demand: str
    """What it demands of a robot."""

    best_constant: str
    """The constant behavior with the highest probe score over all households."""

    moments: float
    """Share of the moments in which it makes a difference what a robot does."""

    deviation: float
    """Mean difference of foretold verdicts and those that followed, NaN if unknown."""

    deviation_loss: float
    """What the foretold best is short of the real best, NaN if unknown."""

    scores: Mapping[str, Summary]
    """By policy; the one under test is called `policy`."""


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """What a policy came to on the suite."""

    policy: str
    seeds: tuple[int, ...]
    training: int
    """Decisions a learner of the catalog learned for in each household."""

    families: tuple[FamilyEvaluation, ...]


def evaluate(
    policy: str | Act | Learner,
    suite: str | Sequence[str] = ALL,
    seeds: int | Sequence[int] = 30,
    *,
    training: int = TRAINING,
    steps: int | None = None,
    engine: Engine | None = None,
    advance: Callable[[], None] | None = None,
) -> Evaluation:
    """Scores a policy in households drawn by seed.

    Args:
        policy: `random`, `constant:BEHAVIOR`, a learner's name in the catalog, the file
            of a saved learner, `module:function`, a function of observation and agent,
            or a learner. It is asked whenever a behavior is due.
        suite: `all`, or names or TOML paths of scenario families.
        seeds: How many households of each family, or their seeds.
        training: Decisions that a learner of the catalog learns for in each household.
        steps: Steps of the lived episodes at most; None: as many as the family's have.
        engine: Where to run; None: here, one household after the other.
        advance: Called after each household.

    Raises:
        ExperimentError: If an argument cannot be used, or the policy returns what is
            none of the behaviors.
        HouseholdError: If a family cannot be read or drawn.
    """
    asked, names = specification(policy).name, families_of(suite)
    drawn = tuple(range(seeds)) if isinstance(seeds, int) else tuple(seeds)
    if not drawn or min(drawn) < 0:
        raise ExperimentError("seeds: at least one is needed, all 0 or larger.")
    tasks = [
        Task(family=name, seed=seed, policy=policy, training=training, steps=steps)
        for name in names
        for seed in drawn
    ]
    scored = _scored(tasks, engine, advance or (lambda: None))
    return Evaluation(
        policy=asked,
        seeds=drawn,
        training=training,
        families=tuple(
            _family(name, [each for each in scored if each.family == name])
            for name in names
        ),
    )


def families_of(suite: str | Sequence[str]) -> tuple[str, ...]:
    """Returns the families that are asked for, each of them readable.

    Raises:
        ExperimentError: If there is no such family.
    """
    from household.config.toml import shipped
    from household.scenario.family import load_family

    if suite == ALL:
        return tuple(shipped("family"))
    names = (suite,) if isinstance(suite, str) else tuple(suite)
    for name in names:
        if name not in shipped("family") and not name.endswith(".toml"):
            raise unknown("family", name, (ALL, *shipped("family")))
        load_family(name)
    return names


def _scored(
    tasks: Sequence[Task], engine: Engine | None, advance: Callable[[], None]
) -> list[Scored]:
    """Scores every household, in the order of the tasks."""
    scored = []
    for task in tasks if engine is None else ():
        scored.append(score(task))
        advance()
    for outcome in run_trials(score, tasks, engine) if engine is not None else ():
        if outcome.value is None:
            raise outcome.error or RuntimeError(f"{outcome.trial}: no result")
        scored.append(outcome.value)
        advance()
    return sorted(scored, key=lambda one: (one.family, one.seed))


def _family(name: str, scored: Sequence[Scored]) -> FamilyEvaluation:
    from household.scenario.family import load_family

    names = list(scored[0].scores)
    constants = {f"constant:{each}": each for each in load_family(name).behaviors}
    greedy = {
        each: np.mean([one.scores[each].probe_greedy for one in scored])
        for each in constants
    }
    best = max(constants, key=lambda each: float(greedy[each]))
    floor, ceiling = _lived(scored, "random"), _lived(scored, "lookahead")
    summaries = {
        each: _summary([one.scores[each] for one in scored], floor, ceiling)
        for each in names
    }
    played = [each.deviation for each in scored if each.deviation is not None]
    return FamilyEvaluation(
        family=name,
        demand=load_family(name).demand,
        best_constant=constants[best],
        moments=float(np.mean([each.share for each in scored])),
        deviation=_mean([each.error for each in played]),
        deviation_loss=_mean([each.loss for each in played]),
        scores=summaries | {"best constant": summaries[best]},
    )


def _lived(scored: Sequence[Scored], name: str) -> tuple[float, float]:
    """Mean verdicts in a minute and on a bout, over households."""
    lived = [each.scores[name].lived for each in scored]
    return (
        _mean([each.per_minute for each in lived]),
        _mean([each.per_bout for each in lived]),
    )


def _summary(
    scores: Sequence[Scores], floor: tuple[float, float], ceiling: tuple[float, float]
) -> Summary:
    lived = [each.lived for each in scores]
    minute = mean([each.per_minute for each in lived])
    bout = mean([each.per_bout for each in lived])
    return Summary(
        probe_greedy=_over_households([each.probe_greedy for each in scores]),
        probe_deployed=_over_households([each.probe_deployed for each in scores]),
        verdicts_per_minute=minute,
        verdicts_per_bout=bout,
        share_per_minute=_share(minute.value, floor[0], ceiling[0]),
        share_per_bout=_share(bout.value, floor[1], ceiling[1]),
        caresses_per_minute=mean([each.caresses / each.minutes for each in lived]),
        taps_per_minute=mean([each.taps / each.minutes for each in lived]),
        reward_per_minute=mean([each.reward / each.minutes for each in lived]),
        opinion=mean([each.opinion for each in lived]),
    )


def _over_households(values: Sequence[float]) -> Estimate:
    """The mean over households that have a probe set."""
    return mean([value for value in values if not np.isnan(value)])


def _mean(values: Sequence[float]) -> float:
    return float(np.mean(values)) if values else float("nan")


def _share(value: float, floor: float, ceiling: float) -> float:
    return (value - floor) / (ceiling - floor) if ceiling > floor else float("nan")
