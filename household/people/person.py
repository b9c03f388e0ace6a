"""A person of the household: who it is and what it finds polite."""

from dataclasses import dataclass

from household.arrays import Floats
from household.people.norms import norm_table
from household.people.persona import Persona
from household.people.population import preferences
from household.scenario import Scenario


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
                index,
            ),
        )
        for index, (spec, persona) in enumerate(
            zip(scenario.people, scenario.personas, strict=True)
        )
    ]
