"""Changes: from when on people want something else, while the robot lives there."""

from collections.abc import Sequence
from typing import Annotated

import msgspec

from household.config.quantities import Name, Seed
from household.config.toml import Record
from household.scenario.norms import Norms, merged
from household.scenario.persona import Persona
from household.scenario.population import Population

Moment = Annotated[float, msgspec.Meta(ge=0, le=1e8)]
"""[s] since the episode began."""


class Change(Record, frozen=True, kw_only=True):
    """What some people want from some time on, at once or little by little.

    What is not named stays as it was. As always, preferences are norms as far as the
    scenario's heterogeneity is from 1, and tastes as far as it is from 0.

    Attributes:
        at: When it begins, in time since the episode began [s].
        over: How long it takes until they want wholly what is new, growing evenly [s];
            0: they do from one moment to the next.
        people: Names of whom it concerns; none: everybody.
        norms: What they then hold the household's norms to be.
        preferences: What then is their own taste.
        population_seed: Draws anew what their tastes leave open.
    """

    at: Moment
    over: Moment = 0.0
    people: Annotated[tuple[Name, ...], msgspec.Meta(max_length=64)] = ()
    norms: Norms = msgspec.field(default_factory=dict)
    preferences: Norms = msgspec.field(default_factory=dict)
    population_seed: Seed | None = None

    @property
    def ends(self) -> float:
        """When they want wholly what is new [s]."""
        return self.at + self.over

    def concerns(self, name: str) -> bool:
        """Whether it is about the person of that name."""
        return not self.people or name in self.people


class Wants(msgspec.Struct, frozen=True, kw_only=True):
    """What a person's preferences follow from.

    Attributes:
        norms: Of the household.
        persona: Its own taste.
        population: Draws the rest of it.
    """

    norms: Norms
    persona: Persona
    population: Population

    def after(self, change: Change) -> "Wants":
        """What they follow from when a change is over."""
        seed = change.population_seed
        if seed is None:
            seed = self.population.seed
        tastes = merged(self.persona.preferences, change.preferences)
        return Wants(
            norms=merged(self.norms, change.norms),
            persona=msgspec.structs.replace(self.persona, preferences=tastes),
            population=msgspec.structs.replace(self.population, seed=seed),
        )


def in_order(changes: Sequence[Change]) -> list[Change]:
    """Changes in the order in which they begin."""
    return sorted(changes, key=lambda change: change.at)
