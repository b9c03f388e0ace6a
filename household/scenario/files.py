"""Files of every kind: what a TOML file is can be seen from its fields."""

from collections.abc import Callable, Iterator
from difflib import get_close_matches
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from household.config.faults import MOST, Fault, faults
from household.config.toml import Kind, locate, read_toml, shipped
from household.errors import HouseholdError, choose_from, shown_path
from household.home.check import home_faults
from household.home.floorplan import FloorPlan
from household.scenario.family import Family, family_faults
from household.scenario.persona import Persona
from household.scenario.reading import from_its_folder
from household.scenario.scenario import Scenario
from household.scenario.validation import scenario_faults


class FileKind(NamedTuple):
    """A kind of file.

    Attributes:
        record: What it is read into.
        faults: Everything that is wrong with what such a file holds.
        size: How much there is in it, in a few words.
    """

    record: type
    faults: Callable[[dict[str, Any], Path], Iterator[Fault]]
    size: Callable[[Any], str]


def _faults_of_scenario(data: dict[str, Any], path: Path) -> Iterator[Fault]:
    return scenario_faults(from_its_folder(data, path.parent))


def _faults_of_home(data: dict[str, Any], path: Path) -> Iterator[Fault]:
    del path
    return home_faults(data)


def _faults_of_persona(data: dict[str, Any], path: Path) -> Iterator[Fault]:
    """Preferences may be about behaviors that a scenario adds; nobody knows here."""
    del path
    return faults(data, Persona)


def _faults_of_family(data: dict[str, Any], path: Path) -> Iterator[Fault]:
    del path
    return family_faults(data)


def _size_of_scenario(scenario: Scenario) -> str:
    people, robots = len(scenario.people), len(scenario.robots)
    return f"{_many(people, 'person', 'people')}, {_many(robots, 'robot')}"


def _size_of_home(plan: FloorPlan) -> str:
    rooms, regions = len(plan.rooms), len(plan.regions)
    return f"a home: {_many(rooms, 'room')}, {_many(regions, 'region')}"


def _size_of_persona(persona: Persona) -> str:
    return f"a persona: {persona.name}"


def _size_of_family(family: Family) -> str:
    least, most = family.people
    people = f"{least} to {_many(most, 'person', 'people')}"
    return f"a family: {people}, up to {_many(family.robots[1], 'robot')}"


def _many(n: int, one: str, many: str = "") -> str:
    return f"{n} {one if n == 1 else many or one + 's'}"


KINDS: dict[Kind, FileKind] = {
    "scenario": FileKind(Scenario, _faults_of_scenario, _size_of_scenario),
    "home": FileKind(FloorPlan, _faults_of_home, _size_of_home),
    "family": FileKind(Family, _faults_of_family, _size_of_family),
    "persona": FileKind(Persona, _faults_of_persona, _size_of_persona),
}
"""Every kind of file that can be checked; a name that several have is the first's."""


def check_file(name: str | Path) -> tuple[str, ...]:
    """Everything that is wrong with a file, one line each; empty if it can be used.

    Args:
        name: A TOML file of whichever kind, or what a shipped one is called.
    """
    try:
        path, data, kind = _opened(str(name))
        found = list(islice(KINDS[kind].faults(data, path), MOST + 1))
    except HouseholdError as error:
        return (str(error),)
    lines = [f"{shown_path(name)}: {fault}" for fault in found[:MOST]]
    if len(found) > MOST:
        lines.append(f"{shown_path(name)}: and more; mend these first")
    return tuple(lines)


def size_of_file(name: str | Path) -> str:
    """What a faultless file is, and how much there is in it, in a few words.

    Args:
        name: As `check_file` takes it.
    """
    _, data, kind = _opened(str(name))
    return KINDS[kind].size(msgspec.convert(data, KINDS[kind].record))


def _opened(name: str) -> tuple[Path, dict[str, Any], Kind]:
    """The file of a name, what it holds and what kind it is of."""
    for kind in KINDS:
        if name in shipped(kind):
            path = locate(name, kind)
            return path, read_toml(path), kind
    if not name.endswith(".toml"):
        names = [each for kind in KINDS for each in shipped(kind)]
        raise HouseholdError(
            choose_from(name, names, "file") + " or a path that ends in .toml"
        )
    path = locate(name, "scenario")
    data = read_toml(path)
    return path, data, _kind_of(data, shown_path(name))


def _kind_of(data: dict[str, Any], origin: str) -> Kind:
    """The kind with which a file has most fields in common, and misses fewest.

    A misspelled field counts for the kinds that have a field of a similar name.
    """
    common: dict[Kind, tuple[int, int]] = {}
    for kind, (record, _, _) in KINDS.items():
        fields = msgspec.structs.fields(record)
        names = {field.encode_name for field in fields}
        needed = {field.encode_name for field in fields if field.required}
        meant = [key for key in data if get_close_matches(key, names, n=1)]
        common[kind] = len(meant), -len(needed - data.keys())
    best = max(common, key=lambda kind: common[kind])
    if not common[best][0]:
        raise HouseholdError(f"{origin}: no file of ours; allowed: {', '.join(KINDS)}")
    return best
