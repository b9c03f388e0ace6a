"""A person of the household: who it is and what it finds polite."""

from dataclasses import dataclass

from household.compiled.arrays import Floats
from household.scenario.change import Wants
from household.scenario.norms import norm_table
from household.scenario.persona import Persona
from household.scenario.population import preferences
from household.scenario.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Person:
    """One simulated person.

    Attributes:
        name: Unique in the household.
        persona: What kind of person it is.
        preferences: What it finds polite, shape (n_activities, 2, n_behaviors), in
            [-1, 1]; private.
    """

    name: str
    persona: Persona
    preferences: Floats


def everyone_of(scenario: Scenario) -> list[Person]:
    """The people of a scenario, in order, as they are when an episode begins."""
    norms, population = scenario.household_norms, scenario.population
    return [
        Person(
            name=spec.name,
            persona=persona,
            preferences=preferences_of(
                scenario,
                index,
                Wants(norms=norms, persona=persona, population=population),
            ),
        )
        for index, (spec, persona) in enumerate(
            zip(scenario.people, scenario.personas, strict=True)
        )
    ]


def preferences_of(scenario: Scenario, index: int, wants: Wants) -> Floats:
    """What one person finds polite.

    Args:
        scenario: Where it lives.
        index: Which person it is there.
        wants: What that follows from.

    Returns:
        Shape (n_activities, 2, n_behaviors), in [-1, 1].
    """
    return preferences(
        norm_table(wants.norms, scenario.behaviors),
        wants.persona,
        scenario.behaviors,
        wants.population,
        scenario.heterogeneity,
        scenario.numbers[index],
    )
