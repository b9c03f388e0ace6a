"""Axes of maps: what is varied of a condition, level by level."""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any

from experiments.running.study import Condition
from experiments.studies.constants import plain_scenario

People = list[dict[str, Any]]
"""The people of a scenario as plain data."""


@dataclass(frozen=True, kw_only=True)
class Axis:
    """Something that is varied."""

    name: str
    """Of the factor."""

    label: str
    """What it is, with its unit."""

    levels: tuple[float, ...]
    """In order."""

    usual: float
    """The level of the experiment itself, among them."""

    vary: Callable[[Condition, float], Condition]
    """Takes a condition and a level, returns the condition at that level."""


def temperature(condition: Condition, level: float) -> Condition:
    """Returns a condition whose robots explore at some temperature [touches]."""
    exploration = {"name": "softmax", "temperature": level}
    overrides = {**condition.learner_overrides, "exploration": exploration}
    return dataclasses.replace(condition, learner_overrides=overrides)


def habituation(condition: Condition, level: float) -> Condition:
    """Returns a condition whose people get used to politeness to some degree [0, 1]."""
    people = people_of(condition)
    for person in people:
        person["persona"]["habituation"] = level
    return with_people(condition, people)


def attention(condition: Condition, share: float) -> Condition:
    """Returns a condition whose people look at the robot for a share of the time.

    Those who look there part of the time do so as long at a stretch as before; what
    changes is how long they look away.
    """
    people = people_of(condition)
    for stage in _stages(people):
        if stage.get("look_at"):
            _look_for_a_share(stage, share)
    return with_people(condition, people)


def watching(condition: Condition, share: float) -> Condition:
    """Returns a condition in which who never looked at the robot does, at times.

    Args:
        condition: Somebody in its scenario looks at the robot part of the time; whoever
            does not will look as long at a stretch.
        share: Of the time; 0 leaves it as it is.
    """
    if share == 0.0:
        return condition
    people = people_of(condition)
    stages = list(_stages(people))
    looking = next(stage for stage in stages if stage.get("look_at"))
    for stage in stages:
        if not stage.get("look_at"):
            stage |= {key: looking[key] for key in ("look_at", "look_for")}
            _look_for_a_share(stage, share)
    return with_people(condition, people)


def perception(condition: Condition, level: float, name: str) -> Condition:
    """Returns a condition with one constant of perception changed.

    Args:
        condition: What to change; stays as it is.
        level: The constant's new value.
        name: Of the constant.
    """
    before = condition.scenario_overrides.get(
        "perception", plain_scenario(condition.scenario)["perception"]
    )
    overrides = {**condition.scenario_overrides, "perception": {**before, name: level}}
    return dataclasses.replace(condition, scenario_overrides=overrides)


def people_of(condition: Condition) -> People:
    """Returns a copy of the people of a condition, with their personas written out."""
    plain = plain_scenario(condition.scenario)["people"]
    return copy.deepcopy(condition.scenario_overrides.get("people", plain))


def with_people(condition: Condition, people: People) -> Condition:
    """Returns a condition with other people."""
    overrides = {**condition.scenario_overrides, "people": people}
    return dataclasses.replace(condition, scenario_overrides=overrides)


def _stages(people: People) -> Iterable[dict[str, Any]]:
    return (stage for person in people for stage in person["script"])


def _look_for_a_share(stage: dict[str, Any], share: float) -> None:
    """Sets how long somebody looks away, half to one and a half times the mean."""
    mean = sum(stage["look_for"]) / 2 * (1.0 - share) / share
    stage["look_away"] = [0.5 * mean, 1.5 * mean]


TEMPERATURE = Axis(
    name="temperature",
    label="temperature of softmax [touches]",
    levels=(0.05, 0.1, 0.2, 0.35, 0.5, 0.8),
    usual=0.2,
    vary=temperature,
)

ATTENTION = Axis(
    name="attention",
    label="time that the actor\nattends [share]",
    levels=(0.15, 1 / 3, 0.5, 0.75),
    usual=1 / 3,
    vary=attention,
)

WATCHING = Axis(
    name="watching",
    label="time that the reading person watches [share]",
    levels=(0.0, 0.15, 1 / 3, 0.6, 0.9),
    usual=0.0,
    vary=watching,
)

HABITUATION = Axis(
    name="habituation",
    label="habituation [share of\nthe wish to praise]",
    levels=(0.0, 0.05, 0.15, 0.3),
    usual=0.15,
    vary=habituation,
)

NOTICE_DELAY = Axis(
    name="notice_delay",
    label="how late a robot notices an approach [s]",
    levels=(0.0, 0.5, 1.0, 2.0, 4.0),
    usual=0.5,
    vary=partial(perception, name="notice_delay"),
)

NOTICE_NOISE = Axis(
    name="notice_noise",
    label="error of that time,\nstandard deviation [s]",
    levels=(0.0, 0.3, 1.0, 2.0),
    usual=0.3,
    vary=partial(perception, name="notice_noise"),
)
