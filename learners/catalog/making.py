"""Making a learner by name."""

import difflib
from collections.abc import Mapping
from typing import Any, cast

import numpy as np

from learners.catalog.baselines import BASELINES
from learners.catalog.paper import PAPER
from learners.catalog.recipe import Recipes
from learners.catalog.situations import SITUATIONS
from learners.errors import LONGEST, ParameterError, UnknownNameError, shown
from learners.learner import Learner

CATALOG: Recipes = {**PAPER, **SITUATIONS, **BASELINES}
"""The one list of learners by name."""


def make_learner(
    name: str, n_behaviors: int, rng: np.random.Generator, **overrides: object
) -> Learner:
    """A learner by name.

    Args:
        name: one of `CATALOG`.
        n_behaviors: number of behaviors to choose from.
        rng: its only source of randomness.
        **overrides: settings in place of the recipe's, such as `gamma=0.5` or
            `exploration=Greedy()`, and whatever the recipe needs.

    Raises:
        UnknownNameError: if there is no such learner or setting, naming the nearest.
        ParameterError: if a setting is out of range, or one that it needs is missing.
    """
    recipe = CATALOG.get(name) if isinstance(name, str) else None
    if recipe is None:
        raise UnknownNameError(_no_such("learner", name, CATALOG))
    for given in overrides:
        if given not in recipe.settings:
            raise UnknownNameError(
                _no_such(f"setting of {name}", given, recipe.settings)
            )
    missing = [need for need in recipe.needs if need not in overrides]
    if missing:
        raise ParameterError(f"learner {name!r} needs {', '.join(missing)}")
    needed = {need: overrides.pop(need) for need in recipe.needs}
    components = recipe.components(**needed) | overrides
    return cast(Learner, recipe.kind(n_behaviors, rng, **components))


def _no_such(what: str, name: object, known: Mapping[str, Any] | frozenset[str]) -> str:
    allowed = sorted(known)
    near = difflib.get_close_matches(str(name)[:LONGEST], allowed, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    return (
        f"there is no {what} called {shown(name)}{hint} (allowed: {', '.join(allowed)})"
    )
