"""Scenario families: households of one kind, drawn by seed.

A family says what a robot has to be good at and which households pose that demand:
what homes they live in, who the residents are, what is polite there. Homes, people and
who does what are drawn from seeds of their own, so that each can be held while another
changes (the splits of a generalization study). Nobody is placed by hand: people begin
in the first place of their schedule, robots in the open, away from doors and places.
"""

from collections.abc import Iterator
from functools import lru_cache
from typing import Annotated, Any, get_args

import msgspec
import numpy as np

from household.config.faults import MOST, Fault, Sound, first_faults, joined
from household.config.mending import mended
from household.config.quantities import Count, FileName, Name, Seed, Share, Text
from household.config.toml import Record, convert, load, locate, read_toml, shipped
from household.errors import HouseholdError
from household.home.floorplan import FloorPlan, RegionActivity, load_floorplan
from household.home.sources.generator import MOST_ROOMS, generate
from household.home.standing import standing_room
from household.scenario.behavior import Behavior, catalogue
from household.scenario.change_faults import norm_faults
from household.scenario.fit import behaviors_faults, first_spots, schedule_faults
from household.scenario.norms import ActivityName, Norms
from household.scenario.persona import Persona, load_persona
from household.scenario.population import Population
from household.scenario.scenario import (
    FEW,
    MOST_BEHAVIORS,
    MOST_LINES,
    PersonSpec,
    RobotSpec,
    Scenario,
    SituationModel,
    Slots,
    Stay,
)

MOST_PEOPLE, MOST_ROBOTS = 12, 4
"""In the households of a family: what one home has room for."""

Rooms = Annotated[int, msgspec.Meta(ge=1, le=MOST_ROOMS)]
Area = Annotated[float, msgspec.Meta(ge=10, le=40)]
People = Annotated[int, msgspec.Meta(ge=1, le=MOST_PEOPLE)]
Robots = Annotated[int, msgspec.Meta(ge=1, le=MOST_ROBOTS)]

SPARE = "phone"
"""The shipped family that stands in for what is missing, while the rest is checked."""

HOME, PEOPLE, ROLES, ROBOTS = range(4)
"""What is drawn; each from a stream of its own."""

NAMES = (
    *("ada", "ben", "cleo", "dan", "eva", "finn"),
    *("gita", "hugo", "ida", "jon", "kim", "lea"),
)
"""Of the people of one household; the seed that drew them follows, so that two drawn
from other seeds never share a name."""


# So that it can be a part of the names of its households.
FamilyName = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]+\Z",
        max_length=60,
        description="1 to 60 characters on one line",
    ),
]

SOME = msgspec.Meta(min_length=1, max_length=MOST_LINES)


class HomeKind(Record, frozen=True, kw_only=True):
    """The homes of a family.

    Attributes:
        shipped: Shipped homes, one of which is taken; none: they are generated.
        rooms: Fewest and most rooms.
        room_area: Smallest and largest area of a room of mean size [m2].
        clutter: Share of the furniture that nobody needs for an activity.
        loops: Chance of a door between two rooms that are joined already.
    """

    shipped: tuple[Name, ...] = ()
    rooms: tuple[Rooms, Rooms] = (4, 8)
    room_area: tuple[Area, Area] = (12.0, 18.0)
    clutter: Share = 0.8
    loops: Share = 0.3


class Resident(Record, frozen=True, kw_only=True):
    """What somebody in the households of a family does.

    Attributes:
        schedule: How long, and what then, by activity; begins with the first.
    """

    schedule: Annotated[dict[ActivityName, Stay], msgspec.Meta(min_length=1)]


class Family(Record, frozen=True, kw_only=True):
    """Households of one kind.

    Attributes:
        demand: What it demands of a robot, in one line.
        home: What homes they live in.
        people: Fewest and most people, unless the caller wants another number.
        robots: Fewest and most robots, likewise.
        personas: Shipped personas or records, one of which is drawn for each person.
        residents: What people do; they take them in turn, beginning with a drawn one.
        behaviors: What the robots can choose.
        behavior: The family's own behaviors, by name.
        norms: What is polite there.
        heterogeneity: How far people depart from the norms, likewise.
        situation: What the robots' situations hold.
        max_cycles: Decisions in an episode.
    """

    name: FamilyName
    demand: Text
    description: Text = ""
    home: HomeKind = HomeKind()
    people: tuple[People, People] = (2, 6)
    robots: tuple[Robots, Robots] = (1, 1)
    personas: Annotated[tuple[FileName | Persona, ...], SOME]
    residents: Annotated[tuple[Resident, ...], SOME]
    behaviors: Annotated[
        tuple[Name, ...], msgspec.Meta(min_length=2, max_length=MOST_BEHAVIORS)
    ]
    behavior: Annotated[dict[Name, Behavior], FEW] = msgspec.field(default_factory=dict)
    norms: Norms
    heterogeneity: Share = 0.3
    situation: SituationModel = SituationModel()
    max_cycles: Count = 1200


class Draw(Record, frozen=True, kw_only=True):
    """Which household of a family; what is None is drawn from `seed`.

    Attributes:
        seed: Draws whatever has no seed of its own.
        home: Seed of the home.
        people: Seed of the people: their names, personas, traits and tastes.
        roles: Seed of who does what.
        n_people: How many people.
        n_robots: How many robots.
        heterogeneity: How far people depart from the norms.
    """

    seed: Seed = 0
    home: Seed | None = None
    people: Seed | None = None
    roles: Seed | None = None
    n_people: People | None = None
    n_robots: Robots | None = None
    heterogeneity: Share | None = None


def load_family(name: str) -> Family:
    """Reads a shipped family by name, or a TOML file by path, as it is now.

    Raises:
        HouseholdError: If it cannot be found or anything is wrong with it.
    """
    path = locate(name, "family")
    family = load(path, Family)
    for fault in _misfits(family, Sound()):
        raise HouseholdError(f"{name}: {fault}")
    return family


def family_faults(data: dict[str, Any]) -> Iterator[Fault]:
    """Everything that is wrong with a family as it stands in a file.

    Args:
        data: What the file holds.

    Yields:
        First what is wrong with single fields, then how the sound ones fit together.
    """
    wrong = first_faults(data, Family)
    yield from wrong
    if len(wrong) > MOST:
        return
    if wrong:
        data = mended(data, Family, read_toml(shipped("family")[SPARE]))
    yield from _misfits(msgspec.convert(data, Family), Sound(wrong))


def _misfits(family: Family, sound: Sound) -> Iterator[Fault]:
    """How the fields of a family do not fit together."""
    ranges: dict[str, tuple[float, float]] = {
        "home.rooms": family.home.rooms,
        "home.room_area": family.home.room_area,
        "people": family.people,
        "robots": family.robots,
    }
    for where, (least, most) in ranges.items():
        if least > most and sound(where):
            yield Fault(where, "the least comes first, then the most")
    yield from _personas(family, sound)
    yield from behaviors_faults(family, sound)
    every = get_args(RegionActivity)  # Drawn homes have places for all of them.
    for index, resident in enumerate(family.residents):
        at, schedule = (
            f"residents[{index}].schedule",
            {str(place): stay for place, stay in resident.schedule.items()},
        )
        for fault in schedule_faults(schedule, every, sound.stands(at)):
            if sound(joined(at, fault.path)):
                yield fault.under(at)


def _personas(family: Family, sound: Sound) -> Iterator[Fault]:
    """Personas can be had, and speak of behaviors that there are."""
    known = catalogue() | family.behavior
    for index, each in enumerate(family.personas):
        here = f"personas[{index}]"
        if not sound(here):
            continue
        try:
            persona = load_persona(each) if isinstance(each, str) else each
        except HouseholdError as error:
            yield Fault(here, str(error))
        else:
            if sound("behavior"):
                yield from norm_faults(
                    persona.preferences, known, f"{here}.preferences"
                )


def draw(family: Family | str, choice: Draw | int = 0) -> Scenario:
    """Draws a household of a family.

    Args:
        family: The family, its shipped name, or a TOML path.
        choice: Which household; a number stands for ``Draw(seed=number)``.

    Raises:
        HouseholdError: If no such household can be made; says why.
    """
    if isinstance(family, str):
        family = load_family(family)
    if not isinstance(choice, Draw):
        choice = convert({"seed": choice}, Draw, family.name)
    seeds = _seeds(choice)
    plan = _home(family.home, seeds[HOME])
    rng = np.random.default_rng(seeds[ROBOTS])
    n_people = choice.n_people or _between(rng, family.people)
    n_robots = choice.n_robots or _between(rng, family.robots)
    h = choice.heterogeneity
    scenario = Scenario(
        name=f"{family.name}_{choice.seed}",
        description=family.demand,
        home=plan,
        max_cycles=family.max_cycles,
        behaviors=family.behaviors,
        behavior=family.behavior,
        people=_people(family, n_people, seeds[PEOPLE], seeds[ROLES]),
        robots=(RobotSpec(position=plan.regions[0].center),),
        norms=family.norms,
        heterogeneity=family.heterogeneity if h is None else h,
        population=Population(seed=seeds[PEOPLE]),
        situation=family.situation,
        slots=Slots(people=max(n_people, family.people[1]), robots=MOST_ROBOTS),
    )
    # Only now it shows where people begin.
    return msgspec.structs.replace(scenario, robots=_robots(scenario, n_robots, rng))


def _seeds(choice: Draw) -> tuple[int, int, int, int]:
    """A seed for each thing that is drawn: its own, else one that `seed` gives."""
    given = (choice.home, choice.people, choice.roles, None)
    state = np.random.SeedSequence(choice.seed).generate_state(len(given))
    return tuple(
        int(drawn) if own is None else own
        for own, drawn in zip(given, state, strict=True)
    )  # type: ignore[return-value]


def _stream(seed: int, what: int) -> np.random.Generator:
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(what,)))


def _between(rng: np.random.Generator, bounds: tuple[int, int]) -> int:
    return int(rng.integers(bounds[0], bounds[1] + 1))


@lru_cache(maxsize=256)
def _home(kind: HomeKind, seed: int) -> FloorPlan:
    """The home that a seed draws; named after it, if it is generated."""
    rng = _stream(seed, HOME)
    if kind.shipped:
        return load_floorplan(kind.shipped[int(rng.integers(len(kind.shipped)))])
    plan = generate(
        rng,
        rooms=_between(rng, kind.rooms),
        room_area=float(rng.uniform(*kind.room_area)),
        clutter=kind.clutter,
        loops=kind.loops,
    )
    return msgspec.structs.replace(plan, name=f"{plan.name}_{seed}")


def _people(
    family: Family, n: int, people_seed: int, roles_seed: int
) -> tuple[PersonSpec, ...]:
    """So many people; who they are and what they do come from different seeds."""
    if n > len(NAMES):
        raise HouseholdError(f"{family.name}: {n} people; allowed: 1 to {len(NAMES)}")
    who, what = _stream(people_seed, PEOPLE), _stream(roles_seed, ROLES)
    first = int(what.integers(len(family.residents)))
    turn = [(first + i) % len(family.residents) for i in range(n)]
    names, tastes = who.permutation(NAMES).tolist(), who.random(len(NAMES)).tolist()
    return tuple(
        PersonSpec(
            name=f"{names[i]}_{people_seed}",
            persona=family.personas[int(tastes[i] * len(family.personas))],
            schedule=dict(family.residents[kind].schedule),
        )
        for i, kind in enumerate(what.permutation(turn).tolist())
    )


def _robots(
    scenario: Scenario, n: int, rng: np.random.Generator
) -> tuple[RobotSpec, ...]:
    """Robots stand in the open, away from people, each facing somewhere."""
    people = [spot for _, spot in first_spots(scenario)]
    spots = standing_room(scenario.plan, n, rng, people)
    headings = rng.integers(0, 360, len(spots)).tolist()
    return tuple(
        RobotSpec(position=spot, heading=float(heading))
        for spot, heading in zip(spots, headings, strict=True)
    )
