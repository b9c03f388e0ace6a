"""A person of the household: who it is and what it finds polite."""

from dataclasses import dataclass

from household.compiled.arrays import Floats
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
    """The people of a scenario, in order."""
    norms = norm_table(scenario.household_norms, scenario.behaviors)
    return [
        Person(
            name=spec.name,
            persona=persona,
            preferences=preferences(
                norms,
                persona,
                scenario.behaviors,
                scenario.population,
                scenario.heterogeneity,
                number,
            ),
        )
        for spec, persona, number in zip(
            scenario.people, scenario.personas, scenario.numbers, strict=True
        )
    ]
