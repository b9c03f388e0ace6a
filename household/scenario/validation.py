"""How the parts of a scenario must fit together, with the path of every fault."""

import math
from collections.abc import Collection, Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np

from household.config.toml import Point
from household.errors import HouseholdError, choose_from
from household.home.check import problems as home_problems
from household.home.navigation.routes import routes_of
from household.home.places import APART, Places
from household.scenario.behavior import catalogue
from household.scenario.norms import Norms
from household.scenario.persona import load_persona
from household.scenario.scenario import (
    PersonSpec,
    Scenario,
    ScriptStep,
    read_scenario,
    wrong_fields,
)


def load_scenario(scenario: str | Path | Scenario, **overrides: object) -> Scenario:
    """A scenario that is wholly checked.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario.
        **overrides: Top-level fields to replace.

    Raises:
        HouseholdError: Names the file, the path inside it and what is allowed.
    """
    made = read_scenario(scenario, **overrides)
    origin = scenario.name if isinstance(scenario, Scenario) else str(scenario)
    for problem in problems(made):
        raise HouseholdError(f"{origin}: {problem}")
    return made


def problems(scenario: Scenario) -> Iterator[str]:
    """Everything that is wrong with a scenario, one line each.

    What hangs on a home or a persona is told only if that can be used.
    """
    home, personas = tuple(_home(scenario)), tuple(_personas(scenario))
    yield from home
    yield from personas
    yield from _periods(scenario)
    yield from _thresholds(scenario)
    yield from _behaviors(scenario)
    if not personas:
        yield from _preferences(scenario)
    yield from _names(scenario)
    yield from _slots(scenario)
    if not home:
        for index, person in enumerate(scenario.people):
            yield from _doings(scenario, person, f"people[{index}]")
        yield from _places(scenario)


def _home(scenario: Scenario) -> Iterator[str]:
    home = scenario.home
    try:
        faults = home_problems(scenario.plan)
    except HouseholdError as error:
        yield f"home: {error}"
    else:
        where = f"home: {home}: " if isinstance(home, str) else "home."
        yield from (where + fault for fault in faults)


def _personas(scenario: Scenario) -> Iterator[str]:
    for index, person in enumerate(scenario.people):
        if isinstance(person.persona, str):
            try:
                load_persona(person.persona)
            except HouseholdError as error:
                yield f"people[{index}].persona: {error}"


def _thresholds(scenario: Scenario) -> Iterator[str]:
    model = scenario.perception
    if model.attend_below > model.attend_above:
        yield (
            f"perception.attend_below: {model.attend_below}; "
            f"allowed: at most attend_above, {model.attend_above}"
        )


def _periods(scenario: Scenario) -> Iterator[str]:
    clocks = ("decision_period", "steering_period", "physics_period")
    for longer, shorter in pairwise(clocks):
        ratio = getattr(scenario, longer) / getattr(scenario, shorter)
        if ratio < 1 or abs(ratio - round(ratio)) > 1e-9:
            yield f"{longer}: must be a whole multiple of {shorter}"


def _behaviors(scenario: Scenario) -> Iterator[str]:
    known = catalogue() | scenario.behavior
    for index, name in enumerate(scenario.behaviors):
        if name not in known:
            yield f"behaviors[{index}]: {choose_from(name, known, 'behavior')}"
    if len(set(scenario.behaviors)) < len(scenario.behaviors):
        yield "behaviors: every name may stand there once"
    yield from _norms(scenario.norms or {}, known, "norms")


def _preferences(scenario: Scenario) -> Iterator[str]:
    known = catalogue() | scenario.behavior
    for index, persona in enumerate(scenario.personas):
        yield from _norms(
            persona.preferences, known, f"people[{index}].persona.preferences"
        )


def _norms(norms: Norms, known: Collection[str], path: str) -> Iterator[str]:
    for activity, norm in norms.items():
        for part in ("attending", "absorbed"):
            for name in getattr(norm, part):
                if name not in known:
                    problem = choose_from(name, known, "behavior")
                    yield f"{path}.{activity}.{part}: {problem}"


def _names(scenario: Scenario) -> Iterator[str]:
    taken = set(scenario.robot_names)
    for index, name in enumerate(scenario.person_names):
        if name in taken:
            yield f"people[{index}].name: {name!r} is taken; allowed: any other name"
        taken.add(name)


def _slots(scenario: Scenario) -> Iterator[str]:
    for kind, has in (("people", scenario.people), ("robots", scenario.robots)):
        slots = getattr(scenario.slots, kind)
        if slots is not None and slots < len(has):
            yield f"slots.{kind}: must be at least {len(has)}, one for each"


def _doings(scenario: Scenario, person: PersonSpec, path: str) -> Iterator[str]:
    """Scripts and schedules lead only to places that the home has."""
    regions = scenario.plan.regions
    places = {r.name for r in regions} | {r.activity for r in regions}
    if person.script and person.schedule:
        yield f"{path}: has a script and a schedule; allowed: one of them"
    for index, step in enumerate(person.script):
        others = {*scenario.robot_names, *scenario.person_names} - {person.name}
        yield from _script_step(step, places, others, f"{path}.script[{index}]")
    for place, stay in person.schedule.items():
        here = f"{path}.schedule.{place}"
        if place not in places:
            yield f"{here}: {choose_from(place, places, 'place')}"
        for following in stay.then:
            if following not in person.schedule:
                problem = choose_from(following, person.schedule, "place")
                yield f"{here}.then: {problem}"
        if not any(stay.then.values()):
            yield f"{here}.then: at least one weight must be above 0"
        yield from _times(stay.duration, f"{here}.duration")


def _script_step(
    step: ScriptStep, places: set[str], others: set[str], here: str
) -> Iterator[str]:
    if step.place not in places:
        yield f"{here}.place: {choose_from(step.place, places, 'place')}"
    if step.look_at is not None and step.look_at not in others:
        yield f"{here}.look_at: {choose_from(step.look_at, others, 'entity')}"
    if (step.duration is None) == (step.until is None):
        yield f"{here}: needs either duration or until"
    for field in ("duration", "look_for", "look_away"):
        yield from _times(getattr(step, field), f"{here}.{field}")


def _times(times: tuple[float, float] | None, path: str) -> Iterator[str]:
    if times is not None and times[0] > times[1]:
        yield f"{path}: the shortest time comes first, then the longest"


def _places(scenario: Scenario) -> Iterator[str]:
    """Nobody begins inside a wall, outdoors, on top of another, or shut away."""
    bodies = [
        (f"people[{i}].start", p.start)
        for i, p in enumerate(scenario.people)
        if p.start
    ]
    bodies += [
        (f"robots[{i}].position", r.position) for i, r in enumerate(scenario.robots)
    ]
    spots = list(first_spots(scenario))
    for index, (path, point) in enumerate(bodies):
        if problem := _misplaced(scenario, point):
            yield f"{path}: {problem}"
        for other, there in (*spots, *bodies[:index]):
            if math.dist(point, there) < APART:
                yield f"{path}: overlaps {other}; allowed: at least {APART} m apart"


def first_spots(scenario: Scenario) -> Iterator[tuple[str, Point]]:
    """Where people begin who are not put anywhere, but have something to do."""
    places = Places(scenario.plan)
    for index, person in enumerate(scenario.people):
        names = [step.place for step in person.script] or list(person.schedule)
        if names and places.has(names[0]):
            name = names[0]
            place = places.index(name) if person.script else places.own(name, index)
            spot = places.claim(index, place)
            if not person.start:
                yield f"people[{index}] in its first place", spot


def _misplaced(scenario: Scenario, point: Point) -> str:
    """Why a body cannot begin at a point, or an empty text."""
    routes, here = routes_of(scenario.plan), np.array(point)
    if not routes.is_indoors(here):
        return "in a wall, in furniture or outdoors; allowed: free floor indoors"
    if not routes.connects(here, np.array(scenario.plan.regions[0].center)):
        return "no way leads there; allowed: where people can walk to"
    return ""


def check_file(path: str | Path) -> tuple[str, ...]:
    """Every problem of a scenario, one line each; empty if it can be used.

    How the parts fit together can be told only when each of them is right.
    """
    try:
        found = wrong_fields(path) or problems(read_scenario(path))
        return tuple(f"{path}: {problem}" for problem in found)
    except HouseholdError as error:
        return (str(error),)
