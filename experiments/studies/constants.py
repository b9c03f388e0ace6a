"""Every constant of scenario and learner, and how to change one of them alone."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import msgspec

from experiments.running.study import Condition
from experiments.running.trial import make_learner_of
from household.scenario.behavior import Behavior
from household.scenario.persona import Persona, load_persona
from household.scenario.reading import read_scenario
from household.scenario.scenario import PerceptionModel
from learners.components import COMPONENTS, name_of

Keys = tuple[str, ...]
"""Where something stands in nested data; `*` stands for every key or index."""

_OTHERS: Mapping[str, Keys] = {
    "scenario: max_cycles": ("max_cycles",),
    "script: duration": ("people", "*", "script", "*", "duration"),
    "script: look_for": ("people", "*", "script", "*", "look_for"),
    "script: look_away": ("people", "*", "script", "*", "look_away"),
    "norms: size": ("norms",),
}
"""Constants of a scenario beside those of its personas, of perception and of behaviors.
Places, the periods of the simulation and times of day (`until`) are left out: scaled,
they make another home, another resolution, another script."""


@dataclass(frozen=True, kw_only=True)
class Constant:
    """One constant of a scenario or of a learner."""

    name: str
    """Where it belongs and what it is, in words that people read."""

    keys: Keys
    """In a scenario: its place. In a learner: (setting,) or (setting, name)."""

    kind: str = ""
    """Type of the learner, or of its part, that has it; empty: the scenario has it."""

    @property
    def slug(self) -> str:
        """The name as it can be part of a folder's name."""
        return re.sub(r"[^a-z0-9]+", "_", self.name.lower()).strip("_")

    def scaled(self, condition: Condition, factor: float) -> Condition | None:
        """Returns a condition with this constant changed, None if nothing changes.

        A constant with a largest value, as a chance has, is not changed beyond it.

        Args:
            condition: What to change; stays as it is.
            factor: What to multiply the constant by.
        """
        changed = self._in_learner if self.kind else self._in_scenario
        return changed(condition, factor)

    def _in_learner(self, condition: Condition, factor: float) -> Condition | None:
        learner = make_learner_of(condition)
        setting, *inner = self.keys
        part = getattr(learner, setting) if inner else learner
        if inner and type(part).__name__ != self.kind:
            return None
        value = getattr(part, self.keys[-1]) * factor
        if inner:
            value = {"name": name_of(setting, part), inner[0]: value}
        overrides = {**condition.learner_overrides, setting: value}
        return dataclasses.replace(condition, learner_overrides=overrides)

    def _in_scenario(self, condition: Condition, factor: float) -> Condition | None:
        before = plain_scenario(condition.scenario)
        after = _changed(before, self.keys, factor)
        if after == before:
            return None
        top = self.keys[0]
        overrides = {**condition.scenario_overrides, top: after[top]}
        return dataclasses.replace(condition, scenario_overrides=overrides)


def constants(conditions: Iterable[Condition]) -> tuple[Constant, ...]:
    """Returns every constant that any of some conditions has, each once.

    Constants that are 0 are left out: they cannot be scaled.
    """
    found: dict[str, Constant] = {}
    for condition in conditions:
        for constant in (*_of_scenario(condition), *_of_learner(condition)):
            found.setdefault(constant.name, constant)
    return tuple(found.values())


@cache
def plain_scenario(name: str) -> dict[str, Any]:
    """Returns a scenario as plain data, what it names written out."""
    scenario = read_scenario(name)
    # Through JSON, so that all sequences are lists, whose copies compare equal.
    plain: dict[str, Any] = msgspec.json.decode(msgspec.json.encode(scenario))
    for person in plain["people"]:
        person["persona"] = msgspec.to_builtins(load_persona(person["persona"]))
    repertoire = zip(scenario.behaviors, scenario.repertoire, strict=True)
    plain["behavior"] = {name: msgspec.to_builtins(one) for name, one in repertoire}
    plain["norms"] = msgspec.to_builtins(scenario.household_norms)
    return plain


def _of_scenario(condition: Condition) -> list[Constant]:
    plain = plain_scenario(condition.scenario)
    places = {
        **_OTHERS,
        **{
            f"persona: {name}": ("people", "*", "persona", name)
            for name in plain["people"][0]["persona"]
            if name != "preferences"
        },
        **{f"perception: {name}": ("perception", name) for name in plain["perception"]},
        **{
            f"{behavior}: {name}": ("behavior", behavior, name)
            for behavior, own in plain["behavior"].items()
            for name in own
        },
    }
    return [
        Constant(name=name, keys=keys)
        for name, keys in places.items()
        if _changed(plain, keys, 0.75) != plain
    ]


def _of_learner(condition: Condition) -> list[Constant]:
    learner = make_learner_of(condition)
    places: list[tuple[object, Keys]] = [
        (learner, (name,)) for name in ("gamma", "horizon")
    ]
    for setting in COMPONENTS:
        part = getattr(learner, setting)
        places += [(part, (setting, field.name)) for field in dataclasses.fields(part)]
    return [
        Constant(
            name=f"{type(owner).__name__ if len(keys) > 1 else 'learner'}: {keys[-1]}",
            keys=keys,
            kind=type(owner).__name__,
        )
        for owner, keys in places
        if isinstance(getattr(owner, keys[-1]), float) and getattr(owner, keys[-1])
    ]


def _limits() -> dict[str, float]:
    """Largest values by name, where there are any."""
    found = {}
    for record in (Persona, PerceptionModel, Behavior):
        info = msgspec.inspect.type_info(record)
        assert isinstance(info, msgspec.inspect.StructType)  # as all records are
        for field in info.fields:
            if isinstance(field.type, msgspec.inspect.FloatType) and field.type.le:
                found[field.name] = field.type.le
    return found


_LARGEST = _limits() | {"norms": 1.0}


def _changed(data: Any, keys: Keys, factor: float, name: str = "") -> Any:  # noqa: ANN401 - nested plain data
    """Returns nested data with every number under some keys multiplied."""
    if not keys:
        return _multiplied(data, factor, _LARGEST.get(name, float("inf")))
    key, *rest = keys
    inner = name if key == "*" else key
    if isinstance(data, dict):
        touched = data if key == "*" else {key} & set(data)
        return data | {
            k: _changed(data[k], tuple(rest), factor, inner) for k in touched
        }
    if isinstance(data, list | tuple):
        return [_changed(value, tuple(rest), factor, inner) for value in data]
    return data


def _multiplied(data: Any, factor: float, largest: float) -> Any:  # noqa: ANN401 - nested plain data
    if isinstance(data, dict):
        return {k: _multiplied(v, factor, largest) for k, v in data.items()}
    if isinstance(data, list | tuple):
        return [_multiplied(value, factor, largest) for value in data]
    if isinstance(data, bool) or not isinstance(data, int | float):
        return data
    scaled = max(min(data * factor, largest), -largest)
    return round(scaled) if isinstance(data, int) else scaled
