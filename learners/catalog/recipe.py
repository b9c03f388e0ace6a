"""Recipes: how a named learner is put together."""

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

Components = Callable[..., dict[str, Any]]
"""Makes settings from what a recipe needs; `dict` passes that on as it is."""


@dataclasses.dataclass(frozen=True, kw_only=True)
class Recipe:
    """How a named learner is put together.

    Attributes:
        summary: one line for people who choose.
        kind: the learner's class, a dataclass.
        components: makes its settings anew for each learner, from what it `needs`.
        needs: names of callables into the world that the caller must give.
    """

    summary: str
    kind: type
    components: Components = dict
    needs: tuple[str, ...] = ()

    @property
    def settings(self) -> frozenset[str]:
        """Names that may be overridden."""
        fields = dataclasses.fields(self.kind)
        names = {f.name for f in fields if f.init} - {"n_behaviors", "rng"}
        return frozenset(names | set(self.needs))


Recipes = Mapping[str, Recipe]
"""By name."""
