"""Runs one trial: a home, its robots and their learners, from reset to the end."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from functools import partial
from types import FunctionType, MethodType
from typing import TYPE_CHECKING, Any

import numpy as np

from experiments.running.study import Condition, Study, Trial

if TYPE_CHECKING:
    import polars

    from experiments.running.value_log import Predicate
    from household.environment import Household
    from learners.learner import Learner
    from policies.learning import LearningRobot, Observer
    from policies.oracle import OracleObserver


def run_trial(trial: Trial, followed: Sequence[Predicate] = ()) -> polars.DataFrame:
    """Runs a trial to its end and returns its table.

    Args:
        trial: What to run. Trials with the same seed share their random streams
            whatever their condition, so conditions are paired by seed.
        followed: Situations whose Q-values are looked at after every entry, for curves
            of them over time.

    Returns:
        One row per history entry; columns as in `experiments.running.trial_columns`.
    """
    from experiments.running.trial_table import TrialTable

    table = TrialTable(followed)
    play(trial, [table])
    return table.frame()


def play(trial: Trial, observers: Sequence[Observer] = ()) -> dict[str, LearningRobot]:
    """Runs a trial while observers watch.

    Args:
        trial: What to run.
        observers: For example the table of the trial, or a replay file.

    Returns:
        The robots, with what they learned.
    """
    from policies.learning import run_episode

    home_seed, learner_seed = np.random.SeedSequence(trial.seed).spawn(2)
    env = make_home(trial.condition)
    robots, oracles = make_robots(trial.condition, env, learner_seed)
    run_episode(
        env,
        robots,
        seed=int(home_seed.generate_state(1)[0]),
        observers=(*oracles, *observers),
    )
    return robots


def make_home(condition: Condition) -> Household:
    """Returns the condition's environment."""
    from household import household_v0

    return household_v0.parallel_env(
        scenario=condition.scenario, **condition.scenario_overrides
    )


def make_robots(
    condition: Condition, env: Household, seed: np.random.SeedSequence
) -> tuple[dict[str, LearningRobot], tuple[Observer, ...]]:
    """Returns a learning robot for each agent, each with a random stream of its own.

    Returns:
        The robots, and who must watch so that oracles among them are told the truth.
    """
    from policies.learning import LearningRobot
    from policies.oracle import OracleObserver

    robots, oracles = {}, []
    children = seed.spawn(len(env.possible_agents))
    for agent, child in zip(env.possible_agents, children, strict=True):
        oracles.append(OracleObserver(env, agent))
        learner = make_learner_of(
            condition, len(env.behaviors), np.random.default_rng(child), oracles[-1]
        )
        robots[agent] = LearningRobot(learner)
    return robots, tuple(oracles)


def make_learner_of(
    condition: Condition,
    n_behaviors: int = 2,
    rng: np.random.Generator | None = None,
    oracle: OracleObserver | None = None,
) -> Learner:
    """Returns a new learner of a condition.

    Args:
        condition: What it is to be.
        n_behaviors: How many behaviors it chooses from.
        rng: Its random stream; None for a learner that is only looked at.
        oracle: What a bound may know; None for learners that are none.
    """
    from learners.catalog import CATALOG, make_learner
    from learners.components import made

    name = condition.learner
    needs = CATALOG[name].needs if name in CATALOG and oracle is not None else ()
    known = oracle.provides(name, needs) if oracle is not None else {}
    return make_learner(
        name,
        n_behaviors,
        np.random.default_rng(0) if rng is None else rng,
        **made(condition.learner_overrides),
        **known,
    )


def configuration(study: Study) -> dict[str, Any]:
    """Returns everything that fixes a study's results but the seeds, as plain data.

    Names of shipped data (a home, a persona) are followed to the numbers behind them,
    so that a changed constant is a changed configuration.
    """
    return {
        "run": describe(study.run),
        "conditions": {
            c.name: (study.describe or describe_condition)(c) for c in study.conditions
        },
    }


def describe_condition(condition: Condition) -> dict[str, Any]:
    """Returns a condition with every constant of its home and its learner."""
    import msgspec

    env = make_home(condition)
    scenario = env.scenario
    robots, _ = make_robots(condition, env, np.random.SeedSequence(0))
    parts = {
        "scenario": scenario,
        "home": scenario.plan,
        "personas": scenario.personas,
        "behaviors": scenario.repertoire,
        "norms": scenario.household_norms,
    }
    return {
        "factors": dict(condition.factors),
        "learner": condition.learner,
        "settings": describe(next(iter(robots.values())).learner),
        **{name: msgspec.to_builtins(part) for name, part in parts.items()},
    }


def describe(record: object) -> object:
    """Returns a settings record as plain data: its type and what it was made with.

    A function is described by its name, and by the arguments that it is bound to; a
    method by its name alone.
    """
    if isinstance(record, (partial, FunctionType, MethodType)):
        return _describe_function(record)
    if dataclasses.is_dataclass(record) and not isinstance(record, type):
        settings = {
            field.name: describe(getattr(record, field.name))
            for field in dataclasses.fields(record)
            if field.init and field.repr and field.name != "rng"
            if not _is_as_before(field, getattr(record, field.name))
        }
        return {"type": type(record).__name__} | settings
    if isinstance(record, Mapping):
        return {str(key): describe(value) for key, value in record.items()}
    if isinstance(record, (list, tuple)):
        return [describe(value) for value in record]
    if record is None or isinstance(record, (bool, int, float, str)):
        return record
    return repr(record)


def _is_as_before(field: dataclasses.Field[Any], value: object) -> bool:
    """Whether a setting says nothing new.

    Those that came later are described only where they differ from what was done before
    them, so that results stored by then stay those of the same configuration.
    """
    if not field.metadata.get("later") or not callable(field.default_factory):
        return False
    return bool(value == field.default_factory())


def _describe_function(
    function: partial[Any] | FunctionType | MethodType,
) -> dict[str, object]:
    if isinstance(function, MethodType):  # What it belongs to is made anew each time.
        return {"method": function.__qualname__}
    if isinstance(function, FunctionType):
        return {"function": function.__name__}
    bound = {name: describe(value) for name, value in function.keywords.items()}
    return {"function": function.func.__name__} | bound
