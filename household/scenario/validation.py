"""Scenarios that are wholly checked: each field, and how they fit together."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec

from household.config.faults import MOST, Fault, Sound, first_faults
from household.config.mending import mended
from household.config.toml import read_toml, shipped
from household.errors import HouseholdError
from household.home.check import home_misfits
from household.home.floorplan import FloorPlan
from household.scenario.fit import misfits
from household.scenario.reading import described, with_its_files
from household.scenario.scenario import Scenario

SPARE = "experiment_1"
"""The shipped scenario that stands in for what is missing, while the rest is checked.
"""


def load_scenario(scenario: str | Path | Scenario, **overrides: object) -> Scenario:
    """A scenario that is wholly checked.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario.
        **overrides: Top-level fields to replace.

    Raises:
        HouseholdError: Names the file, the path inside it and what is allowed.
    """
    origin, fields = described(scenario, **overrides)
    for fault in scenario_faults(fields):
        raise HouseholdError(f"{origin}: {fault}")
    return with_its_files(msgspec.convert(fields, Scenario), origin)


def problems(scenario: Scenario) -> Iterator[str]:
    """Everything that is wrong with a scenario, one line each."""
    _, fields = described(scenario)
    return map(str, scenario_faults(fields))


def scenario_faults(fields: dict[str, Any]) -> Iterator[Fault]:
    """Everything that is wrong with a scenario.

    Args:
        fields: As they stand in its file, other files sought from this one's folder.

    Yields:
        First what is wrong with single fields, then how the sound ones fit together.
    """
    wrong, home = first_faults(fields, Scenario), fields.get("home")
    yield from wrong
    if len(wrong) > MOST:
        return
    if wrong:
        fields = mended(fields, Scenario, read_toml(shipped("scenario")[SPARE]))
    yield from _misfits_of_faulty(home)
    yield from misfits(msgspec.convert(fields, Scenario), Sound(wrong))


def _misfits_of_faulty(home: object) -> Iterator[Fault]:
    """What else is wrong with a home in the file, some of whose fields are."""
    if isinstance(home, dict) and (wrong := first_faults(home, FloorPlan)):
        yield from (fault.under("home") for fault in home_misfits(home, wrong))
