"""From a scenario's scripts and schedules, by name, to routines, by index."""

import math
from collections.abc import Callable, Mapping
from functools import lru_cache, partial

import numpy as np

from household.config.toml import convert, packaged, read_toml
from household.home.places import Places
from household.people.mind import OWN_ACTIVITY
from household.scenario.scenario import PersonSpec, Scenario, Stay
from policies.people.schedule import Schedule, Stop
from policies.people.script import Line, Script

FOREVER = (math.inf, math.inf)

MakeRoutine = Callable[[np.random.Generator], Script | Schedule]


def routine_of(scenario: Scenario, index: int) -> MakeRoutine:
    """Begins what one person of a scenario does, given a random stream."""
    spec, places = scenario.people[index], Places(scenario.plan)
    if spec.script:
        names = (*scenario.person_names, *scenario.robot_names)
        return partial(Script, _lines(spec, places, names))
    schedule = spec.schedule or _everyday(places)
    own = {name: places.own(name, index) for name in schedule}
    return partial(Schedule, _stops(schedule, own))


def _lines(spec: PersonSpec, places: Places, names: tuple[str, ...]) -> list[Line]:
    return [
        Line(
            place=places.index(step.place),
            duration=step.duration or FOREVER,
            until=step.until or math.inf,
            look=OWN_ACTIVITY if step.look_at is None else names.index(step.look_at),
            look_for=step.look_for or FOREVER,
            look_away=step.look_away,
        )
        for step in spec.script
    ]


def _stops(schedule: Mapping[str, Stay], place: Mapping[str, int]) -> list[Stop]:
    names = list(schedule)
    weights = [[s.then.get(n, 0.0) for n in names] for s in schedule.values()]
    ends = np.cumsum(weights, axis=1)
    return [
        Stop(place[name], stay.duration, (row / row[-1]).tolist())
        for (name, stay), row in zip(schedule.items(), ends, strict=True)
    ]


@lru_cache(maxsize=1)
def _shipped_schedule() -> dict[str, Stay]:
    path = packaged("scenario/schedule.toml")
    return convert(read_toml(path), dict[str, Stay], str(path))


def _everyday(places: Places) -> dict[str, Stay]:
    """The shipped schedule, without the activities that a home has no place for.

    From where nothing that is left follows, people go anywhere.
    """
    activities = {region.activity for region in places.regions}
    here = {name: s for name, s in _shipped_schedule().items() if name in activities}
    return {
        name: stay
        if here.keys() & stay.then.keys()
        else Stay(duration=stay.duration, then=dict.fromkeys(here, 1.0))
        for name, stay in here.items()
    }
