"""How the parts of a scenario must fit together, with the path of every fault.

Each check is given what is sound of the scenario's fields, and says nothing about the
rest: what hangs on a field that is wrong by itself cannot be told.
"""

import math
from collections.abc import Collection, Iterator, Mapping
from itertools import pairwise
from typing import Protocol

import numpy as np

from household.config.faults import Fault, Sound, joined, step_of
from household.config.toml import Point, locate
from household.errors import HouseholdError, choose_from, shown_path
from household.home.check import file_faults, plan_faults
from household.home.floorplan import FloorPlan
from household.home.navigation.routes import routes_of
from household.home.places import APART, Places
from household.scenario.behavior import Behavior, catalogue
from household.scenario.change_faults import change_faults, norm_faults
from household.scenario.norms import Norms
from household.scenario.scenario import Scenario, ScriptStep, Stay, persona_of

CLOCKS = ("decision_period", "steering_period", "physics_period")

MOST_TICKS = 1000
"""Of physics in a decision period; 10 are usual."""


def misfits(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    """Everything that is wrong with how the fields of a scenario fit together."""
    home = tuple(_home(scenario)) if sound("home") else ()
    personas = tuple(_personas(scenario, sound))
    yield from home
    yield from personas
    checks = (_periods, _thresholds, behaviors_faults, _names, _slots, change_faults)
    for check in checks:
        yield from check(scenario, sound)
    if not home and sound("home"):
        yield from _doings(scenario, sound)
        yield from _places(scenario, sound)


def _home(scenario: Scenario) -> Iterator[Fault]:
    """A home in the file itself, or in one of its own."""
    home = scenario.home
    if isinstance(home, FloorPlan):
        for fault in plan_faults(home):
            yield fault.under("home")
        return
    try:
        found = file_faults(locate(home, "home"))
    except HouseholdError as error:
        yield Fault("home", str(error))
    else:
        yield from (Fault("home", f"{shown_path(home)}: {fault}") for fault in found)


def _personas(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    """Personas can be had, and speak of behaviors that there are."""
    known = catalogue() | scenario.behavior
    for index, person in enumerate(scenario.people):
        here = f"people[{index}].persona"
        if not sound(here):
            continue
        try:
            preferences = persona_of(person).preferences
        except HouseholdError as error:
            yield Fault(here, str(error))
        else:
            if sound("behavior"):
                yield from norm_faults(preferences, known, f"{here}.preferences")


def _thresholds(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    model, here = scenario.perception, "perception.attend_below"
    if model.attend_below > model.attend_above and sound("perception"):
        yield Fault(
            here,
            f"{model.attend_below}; "
            f"allowed: at most attend_above, {model.attend_above}",
        )


def _periods(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    for longer, shorter in pairwise(CLOCKS):
        ratio = getattr(scenario, longer) / getattr(scenario, shorter)
        whole = ratio >= 1 - 1e-9 and abs(ratio - round(ratio)) <= 1e-9
        if not whole and sound(longer, shorter):
            yield Fault(longer, f"must be a whole multiple of {shorter}")
    ticks = round(scenario.decision_period / scenario.physics_period)
    if ticks > MOST_TICKS and sound(*CLOCKS):
        yield Fault(
            "decision_period",
            f"{ticks} times physics_period; allowed: at most {MOST_TICKS} times",
        )


class HasBehaviors(Protocol):
    """What says which behaviors there are, and what is thought of them."""

    @property
    def behaviors(self) -> tuple[str, ...]:
        """What robots can choose."""

    @property
    def behavior(self) -> dict[str, Behavior]:
        """Those that are not shipped."""

    @property
    def norms(self) -> Norms | None:
        """What is thought of them."""


def behaviors_faults(scenario: HasBehaviors, sound: Sound) -> Iterator[Fault]:
    """Behaviors that nobody knows, and those named twice."""
    known = catalogue() | scenario.behavior
    first: dict[str, int] = {}
    for index, name in enumerate(scenario.behaviors):
        here = f"behaviors[{index}]"
        if not sound(here):
            continue
        if name not in known and sound("behavior"):
            yield Fault(here, choose_from(name, known, "behavior"))
        if first.setdefault(name, index) != index:
            yield Fault(here, f"{name!r} stands there twice; allowed: once")
    if sound("norms", "behavior"):
        yield from norm_faults(scenario.norms or {}, known, "norms")


def _names(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    taken = set(scenario.robot_names) if sound.stands("robots") else set()
    for index, name in enumerate(scenario.person_names):
        here = f"people[{index}].name"
        if sound(here):
            if name in taken:
                yield Fault(here, f"{name!r} is taken; allowed: any other name")
            taken.add(name)


def _slots(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    for kind, has in (("people", scenario.people), ("robots", scenario.robots)):
        slots, here = getattr(scenario.slots, kind), f"slots.{kind}"
        # A list whose items are wrong still has its length.
        if (
            slots is not None
            and slots < len(has)
            and sound(here)
            and sound.stands(kind)
        ):
            yield Fault(here, f"must be at least {len(has)}, one for each")


def _doings(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    """Scripts and schedules lead only to places that the home has."""
    regions = scenario.plan.regions
    places = {r.name for r in regions} | {r.activity for r in regions}
    entities = {*scenario.robot_names, *scenario.person_names}
    names = [f"people[{index}].name" for index in range(len(scenario.people))]
    everybody = sound(*names) and sound.stands("robots", "people")
    for index, person in enumerate(scenario.people):
        here = f"people[{index}]"
        others = entities - {person.name} if everybody else None
        if person.script and person.schedule and sound(here):
            yield Fault(here, "has a script and a schedule; allowed: one of them")
        for line, step in enumerate(person.script):
            for fault in _script_step(step, places, others):
                if sound(joined(f"{here}.script[{line}]", fault.path)):
                    yield fault.under(f"{here}.script[{line}]")
        at = f"{here}.schedule"
        for fault in schedule_faults(person.schedule, places, sound.stands(at)):
            if sound(joined(at, fault.path)):
                yield fault.under(at)


def _script_step(
    step: ScriptStep, places: set[str], others: set[str] | None
) -> Iterator[Fault]:
    """One line of a script; whom there is to look at may not be known."""
    if step.place not in places:
        yield Fault("place", choose_from(step.place, places, "place"))
    if step.look_at is not None and others is not None and step.look_at not in others:
        yield Fault("look_at", choose_from(step.look_at, others, "entity"))
    if (step.duration is None) == (step.until is None):
        yield Fault("", "needs either duration or until")
    for field in ("duration", "look_for", "look_away"):
        yield from _times(getattr(step, field), field)


def schedule_faults(
    schedule: Mapping[str, Stay], places: Collection[str], whole: bool = True
) -> Iterator[Fault]:
    """What is wrong with a schedule.

    Args:
        schedule: By place.
        places: All that there are.
        whole: Whether all that were to be in it are known.
    """
    for place, stay in schedule.items():
        here = step_of(place)
        if place not in places:
            yield Fault(here, choose_from(place, places, "place"))
        for following in stay.then:
            if following not in schedule and whole:
                problem = choose_from(following, schedule, "place")
                yield Fault(f"{here}.then", problem)
        if not any(stay.then.values()):
            yield Fault(f"{here}.then", "at least one weight must be above 0")
        yield from _times(stay.duration, f"{here}.duration")


def _times(times: tuple[float, float] | None, path: str) -> Iterator[Fault]:
    if times is not None and times[0] > times[1]:
        yield Fault(path, "the shortest time comes first, then the longest")


def _places(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    """Nobody begins inside a wall, outdoors, on top of another, or shut away."""
    found: list[tuple[str, Point]] = []
    bodies = [
        (f"people[{i}].start", p.start)
        for i, p in enumerate(scenario.people)
        if p.start
    ]
    bodies += [
        (f"robots[{i}].position", r.position) for i, r in enumerate(scenario.robots)
    ]
    spots = list(first_spots(scenario)) if sound("people") else []
    for path, point in bodies:
        if not sound(path):
            continue
        if problem := _misplaced(scenario, point):
            yield Fault(path, problem)
            continue
        for other, there in (*spots, *found):
            if math.dist(point, there) < APART:
                yield Fault(
                    path, f"overlaps {other}; allowed: at least {APART} m apart"
                )
        found.append((path, point))


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
    if not (routes.is_indoors(here) and routes.has_room(point)):
        return "in a wall, in furniture or outdoors; allowed: free floor indoors"
    if not routes.connects(here, np.array(scenario.plan.regions[0].center)):
        return "no way leads there; allowed: where people can walk to"
    return ""
