"""Policies under test, by name or as objects.

`random`, `constant:BEHAVIOR`, a learner's name in the catalog, the file of a saved
learner, or `module:function` of one's own.
"""

from __future__ import annotations

import importlib
import operator
import sys
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from experiments.errors import ExperimentError, unknown
from experiments.scoring.moments import Sight

if TYPE_CHECKING:
    from learners.learner import Learner

T = TypeVar("T")

Act = Callable[[object, str], int]
"""Anybody's own policy: observation and agent in, action out."""

Choose = Callable[[Sight], int]
"""Index of a behavior, whenever one is due."""


@dataclass(frozen=True, kw_only=True)
class Policy:
    """A policy under test."""

    greedy: Choose
    """What it holds best."""

    deployed: Choose
    """What it would really do, exploration included."""

    @classmethod
    def plain(cls, choose: Choose) -> Policy:
        """Returns a policy that does what it holds best."""
        return cls(greedy=choose, deployed=choose)


Make = Callable[[Sequence[str], np.random.Generator], Policy]
"""Makes a policy, given the names of the behaviors."""


@dataclass(frozen=True, kw_only=True)
class Specification:
    """What somebody asked for, checked as far as it can be without a household."""

    name: str
    """As it was given."""

    make: Make | None = None
    """Makes the policy; None: a learner of the catalog, to be trained first."""

    encoding: str = "features"
    """How the policy wants to observe."""


def specification(policy: str | Act | Learner) -> Specification:
    """Returns what is asked for.

    Args:
        policy: A text as above, a function of observation and agent, or a learner.

    Raises:
        ExperimentError: If there is no such policy; says what would be accepted.
        LearnerError: If a saved learner cannot be read.
    """
    if not isinstance(policy, str):
        return _of_object(policy, getattr(policy, "__name__", type(policy).__name__))
    if policy == "random":
        return Specification(name=policy, make=lambda names, rng: at_random(rng))
    if policy.startswith("constant:"):
        return Specification(name=policy, make=_constant(policy.partition(":")[2]))
    if Path(policy).suffix == ".json":
        return _of_object(_loaded(policy), policy)
    if ":" in policy:
        return _of_object(imported(policy), policy)
    from learners.catalog import CATALOG

    if policy not in CATALOG:
        others = ("random", "constant:BEHAVIOR", "module:function", "LEARNER.json")
        raise unknown("policy", policy, (*others, *CATALOG))
    if "appropriateness" in CATALOG[policy].needs:
        raise ExperimentError(
            f"policy {policy}: knows what only the simulator knows; such policies are "
            "the references that every evaluation shows."
        )
    return Specification(name=policy)


def at_random(rng: np.random.Generator) -> Policy:
    """Returns the policy that draws any behavior at any time."""
    return Policy.plain(lambda sight: int(rng.integers(sight.n_behaviors)))


def of_learner(learner: Learner, rng: np.random.Generator) -> Policy:
    """Returns what a learner that no longer learns would do.

    Args:
        learner: Not changed by being asked, if it has an exploration rule of its own;
            then it is asked for each situation only once.
        rng: Draws in its place.
    """
    values = _remembered(learner.q_values)

    def greedy(sight: Sight) -> int:
        found = values(sight.situation)
        return int(rng.choice(np.flatnonzero(found == found.max())))

    exploration = getattr(learner, "exploration", None)
    if exploration is None:
        return Policy(
            greedy=greedy, deployed=lambda sight: learner.act(sight.situation)
        )
    estimates = _remembered(learner.estimates)  # type: ignore[attr-defined]

    def deployed(sight: Sight) -> int:
        return int(exploration.choose(estimates(sight.situation), rng))

    return Policy(greedy=greedy, deployed=deployed)


def _remembered(told: Callable[[Hashable], T]) -> Callable[[Hashable], T]:
    return lru_cache(maxsize=1 << 16)(told)


def of_robots(policies: dict[str, Policy]) -> Policy:
    """Returns the policy by which each robot does what its own policy says."""
    return Policy(
        greedy=lambda sight: policies[sight.agent].greedy(sight),
        deployed=lambda sight: policies[sight.agent].deployed(sight),
    )


def _constant(name: str) -> Make:
    def make(behaviors: Sequence[str], rng: np.random.Generator) -> Policy:
        if name not in behaviors:
            raise unknown("behavior", name, behaviors)
        behavior = behaviors.index(name)
        return Policy.plain(lambda sight: behavior)

    return make


def _of_object(policy: object, name: str) -> Specification:
    if hasattr(policy, "q_values") and hasattr(policy, "act"):
        return Specification(name=name, make=_fitting(policy, name))
    if not callable(policy):
        raise ExperimentError(
            f"policy {name}: a {type(policy).__name__} is no policy; allowed: a text, "
            "a learner, or a function of observation and agent."
        )
    return Specification(
        name=name,
        make=lambda names, rng: Policy.plain(_checked(policy, name)),
        encoding=str(getattr(policy, "observation", "features")),
    )


def _fitting(learner: object, name: str) -> Make:
    def make(behaviors: Sequence[str], rng: np.random.Generator) -> Policy:
        n: int = learner.n_behaviors  # type: ignore[attr-defined]
        if n != len(behaviors):
            raise ExperimentError(
                f"policy {name}: chooses from {n} behaviors, but this household has "
                f"{len(behaviors)} ({', '.join(behaviors)})."
            )
        return of_learner(learner, rng)  # type: ignore[arg-type]

    return make


def _checked(act: Act, name: str) -> Choose:
    """Returns a foreign policy that is held to what there is to choose from."""

    def choose(sight: Sight) -> int:
        action = act(sight.observation, sight.agent)
        try:
            behavior = operator.index(action)
        except TypeError:
            behavior = -1
        if not 0 <= behavior < sight.n_behaviors:
            raise ExperimentError(
                f"policy {name}: returned {action!r:.80}, which is no behavior; "
                f"allowed: whole numbers from 0 to {sight.n_behaviors - 1}."
            )
        return behavior

    return choose


def _loaded(path: str) -> object:
    """Returns a saved learner."""
    import policies.learning  # noqa: F401 - registers the situations of a household
    from learners.saving import load

    return load(path)


def imported(path: str, what: str = "policy") -> object:
    """Returns what `module:function` names; modules of this folder are found, too."""
    module, _, function = path.partition(":")
    if "" not in sys.path:
        sys.path.insert(0, "")
    try:
        return getattr(importlib.import_module(module), function)
    except (ImportError, AttributeError, ValueError) as error:
        raise ExperimentError(f"{what} {path}: {error}.") from error
