"""Worlds, and the households in them: what kind of home, who lives there, doing what.

A person has a number and is the same wherever it lives. A home has a seed. A role
assignment gives a day to each of two people, or nothing where everybody does
everything. So each can be held while the others change.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from experiments.phases.days import schedule
from experiments.phases.norms import BEHAVIORS, HEARD, own_norms
from household.config.toml import convert, packaged, read_toml
from household.scenario.change import Change
from household.scenario.family import NAMES, Draw, Family, draw, load_family
from household.scenario.persona import Persona, load_persona
from household.scenario.population import Population

if TYPE_CHECKING:
    from household.environment import Household
    from household.scenario.scenario import PersonSpec, Scenario

HOMES: Mapping[str, Mapping[str, Any]] = {
    "generated": {"rooms": [8, 8], "room_area": [15.0, 15.0]},
    "large": {"rooms": [12, 12], "room_area": [15.0, 15.0]},
    "villa": {"shipped": ["villa"]},
}
"""Kinds of homes that studies live in."""

CLUSTERS = 4
"""How many kinds of taste there are, as in the lists of the splits."""

OPPOSED = 3
"""By how many behaviors the wishes of people who disagree are apart."""


@dataclass(frozen=True, kw_only=True)
class World:
    """What the households of a phase have in common."""

    family: str | None = None
    """A shipped family, which then fixes home, people and norms; None: the households
    of the studies, where every role wants another behavior."""

    home: Literal["generated", "large", "villa"] = "generated"
    people: int = 4
    robots: int = 1
    heterogeneity: float = 0.3
    """How far people depart from the norms and from each other, in [0, 1]."""

    clusteredness: float = 0.0
    """Share of a taste that is its cluster's."""

    reliability: float = 1.0
    """How reliably people give feedback."""

    persona: str = "plain"
    """A shipped persona, or the usual constants."""

    traits: tuple[tuple[str, float], ...] = ()
    """Constants in which everybody departs from the persona."""

    days: bool = False
    """Whether everybody has a day of two activities; else everybody does everything."""

    opposed: bool = False
    """Whether every second person wants what the others do not, in every role; they
    then have these tastes alone."""

    turned: int = 0
    """By how many behaviors what people want has moved on, as the episode begins, from
    what they wanted in the same household otherwise: tastes that have changed."""

    hears: bool = True
    """Whether situations say who would hear the robot."""


@dataclass(frozen=True, kw_only=True)
class Residence:
    """One household of a world."""

    world: World
    home: int
    """Seed of the home."""

    people: tuple[int, ...]
    """Numbers of the people; in a family, the seed that draws them all."""

    roles: tuple[tuple[int, int], ...] = ()
    """Days of the first two people, of the next two, and so on; in a family, the first
    number is the seed of who does what."""

    def swapped(self) -> Residence:
        """The same household, in which people two by two have exchanged their days."""
        roles = tuple((other, one) for one, other in self.roles)
        return replace(self, roles=roles)

    @property
    def group(self) -> str:
        """Who lives there, as a text."""
        return " ".join(map(str, self.people))

    def words(self, n: int) -> tuple[int, ...]:
        """Returns numbers that depend on the household alone, for its random streams.

        Args:
            n: How many, at most 8.
        """
        digest = hashlib.sha256(msgspec.json.encode(self)).digest()
        return tuple(
            int.from_bytes(digest[4 * i : 4 * i + 4], "little") for i in range(n)
        )


def household(residence: Residence, steps: int) -> Household:
    """Returns the environment of a household.

    Args:
        residence: Which one.
        steps: Length of its episodes.

    Raises:
        HouseholdError: If no such household can be made.
    """
    from household import household_v0

    return household_v0.parallel_env(scenario(residence), max_cycles=steps)


@lru_cache(maxsize=64)
def scenario(residence: Residence) -> Scenario:
    """Returns a household as a scenario."""
    world = residence.world
    if world.family is not None:
        return _of_family(residence, load_family(world.family))
    family = convert(_family(residence), Family, "family")
    choice = Draw(
        home=residence.home,
        people=0,
        roles=0,
        n_people=world.people,
        n_robots=world.robots,
        heterogeneity=1.0 if world.opposed else world.heterogeneity,
    )
    drawn = draw(family, choice)
    people = tuple(_person(residence, place) for place in range(world.people))
    return msgspec.structs.replace(
        drawn,
        people=people,
        changes=_changes(world, [person.name for person in people]),
        population=Population(
            clusters=CLUSTERS,
            clusteredness=world.clusteredness,
            reliability=world.reliability,
        ),
    )


def described(world: World) -> dict[str, Any]:
    """Returns a world as plain data, with the constants behind what it names."""
    plain = asdict(world)
    if world.family is not None:
        return plain | {"family": msgspec.to_builtins(load_family(world.family))}
    everybody = read_toml(packaged("scenario/schedule.toml"))
    return plain | {
        "home": HOMES[world.home],
        "norms": own_norms(world.turned),
        "persona": msgspec.to_builtins(_persona(world, 0)),
        "schedule": schedule(0) if world.days else everybody,
    }


def _of_family(residence: Residence, family: Family) -> Scenario:
    """A household of a shipped family."""
    (people,), ((roles, _),) = residence.people, residence.roles
    choice = Draw(
        seed=people,
        home=residence.home,
        people=people,
        roles=roles,
        n_robots=residence.world.robots,
    )
    return draw(family, choice)


def _family(residence: Residence) -> dict[str, Any]:
    """The family that this household is of, as plain data."""
    world = residence.world
    days = [
        _schedule(residence, place)
        for place in range(world.people if world.days else 1)
    ]
    hears = {"hears": HEARD} if world.hears else {}
    return {
        "name": "study",
        "demand": "Do what the people who perceive it want in their roles",
        "home": HOMES[world.home],
        "people": [1, len(NAMES)],
        "personas": [msgspec.to_builtins(_persona(world, 0))],
        "residents": [{"schedule": day} for day in days],
        "behaviors": list(BEHAVIORS),
        "norms": own_norms(),
        "situation": {"attention": "robot", **hears},
    }


def _person(residence: Residence, place: int) -> PersonSpec:
    from household.scenario.scenario import PersonSpec

    number = residence.people[place]
    plain = {
        "name": f"{NAMES[number % len(NAMES)]}_{number}",
        "persona": msgspec.to_builtins(_persona(residence.world, place)),
        "schedule": _schedule(residence, place),
        "number": number,
    }
    return convert(plain, PersonSpec, "person")


def _schedule(residence: Residence, place: int) -> dict[str, Any]:
    if not residence.world.days:
        return read_toml(packaged("scenario/schedule.toml"))
    return schedule(residence.roles[place // 2][place % 2])


def _persona(world: World, place: int) -> Persona:
    """What kind of person somebody is, before its individual traits."""
    plain = world.persona == "plain"
    known = Persona(name="plain") if plain else load_persona(world.persona)
    persona = msgspec.structs.replace(known, **dict(world.traits))
    if not world.opposed:
        return persona
    wishes = own_norms(OPPOSED * (place % 2))
    return convert(
        msgspec.to_builtins(persona) | {"preferences": wishes}, Persona, "persona"
    )


def _changes(world: World, names: Sequence[str]) -> tuple[Change, ...]:
    """Tastes that have changed: people want something else from the beginning on."""
    if not world.turned:
        return ()
    if not world.opposed:
        return (
            convert({"at": 0.0, "norms": own_norms(world.turned)}, Change, "norms"),
        )
    wishes = [own_norms(world.turned + OPPOSED * (k % 2)) for k in range(len(names))]
    changes = [
        {"at": 0.0, "people": [name], "preferences": wish}
        for name, wish in zip(names, wishes, strict=True)
    ]
    return convert(changes, tuple[Change, ...], "changes")
