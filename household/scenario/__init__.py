"""Scenarios: who lives where, with which robots; the records and how they fit."""

from household.scenario.behavior import Behavior
from household.scenario.change import Change
from household.scenario.norms import Norm, Norms
from household.scenario.persona import Persona
from household.scenario.population import Population
from household.scenario.reading import read_scenario
from household.scenario.scenario import (
    PerceptionModel,
    PersonSpec,
    RobotSpec,
    Scenario,
    ScriptStep,
    SituationModel,
    Slots,
    Stay,
)
from household.scenario.validation import load_scenario

__all__ = [
    "Behavior",
    "Change",
    "Norm",
    "Norms",
    "PerceptionModel",
    "PersonSpec",
    "Persona",
    "Population",
    "RobotSpec",
    "Scenario",
    "ScriptStep",
    "SituationModel",
    "Slots",
    "Stay",
    "load_scenario",
    "read_scenario",
]
