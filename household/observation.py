"""Observations: one field table from which spaces and values both come.

Everything is relative to the robot that observes. Slots for people and robots that the
household does not have are padding: all their elements are 0.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from household.activity import Activity
from household.scenario import Scenario

Array = NDArray[np.float64]

REACH = 10.0
"""Distances are given in units of this [m], cut at 1: about the size of a home."""


@dataclass(frozen=True, slots=True)
class View:
    """All that robots may know of this moment; nothing that people keep to themselves.

    Attributes:
        offset: From each robot to everybody, people first and robots after them, shape
            (n_robots, n_people + n_robots, 2) [m].
        activity: Roles, shape (n_people,).
        walking: Who is on its way, shape (n_people,).
        attends: Who attends to which robot, shape (n_people, n_robots).
        attention: How much, shape (n_people, n_robots).
        facing: Cosine of the angle between a person's gaze and the direction to each
            robot, shape (n_people, n_robots).
        mood: Moods as each robot perceives them, shape (n_robots, n_people).
        behavior: Index of each robot's behavior, -1 for none, shape (n_robots,).
        left: Share of each robot's bout that is left, shape (n_robots,).
        touches: Sum of caresses and of taps that each robot felt in the last step,
            shape (n_robots, 2), both in [0, 1].
    """

    offset: Array
    activity: NDArray[np.int_]
    walking: NDArray[np.bool_]
    attends: NDArray[np.bool_]
    attention: Array
    facing: Array
    mood: Array
    behavior: NDArray[np.intp]
    left: Array
    touches: Array


@dataclass(frozen=True, slots=True)
class Field:
    """One row of the table.

    Attributes:
        name: Unique.
        slot: What it is repeated for: "self", "person" or "robot" (the others).
        size: Elements in each slot.
        low: Least value.
        high: Greatest value.
        values: From the view to what broadcasts to (n_robots, n_slots, size).
    """

    name: str
    slot: str
    size: int
    low: float
    high: float
    values: Callable[[View], NDArray[Any] | float]


@lru_cache(maxsize=16)
def _one_hots(size: int) -> Array:
    """Row i has its one at i; the last row, which -1 is the index of, has none."""
    return np.eye(size + 1, size)


@lru_cache(maxsize=16)
def _others(n_robots: int) -> NDArray[np.intp]:
    """The indices of each robot's others, shape (n_robots, n_robots - 1)."""
    rows = [[j for j in range(n_robots) if j != i] for i in range(n_robots)]
    return np.array(rows, dtype=np.intp).reshape(n_robots, n_robots - 1)


def _in_reach(offset: Array) -> Array:
    """Offsets in units of `REACH`."""
    return np.minimum(np.maximum(offset / REACH, -1.0), 1.0)


def _to_people(view: View) -> Array:
    return _in_reach(view.offset[:, : len(view.activity)])


def _to_other_robots(view: View) -> Array:
    n = len(view.behavior)
    others = len(view.activity) + _others(n)
    return _in_reach(view.offset[np.arange(n)[:, None], others])


def fields(n_behaviors: int) -> tuple[Field, ...]:
    """The field table.

    Args:
        n_behaviors: How many behaviors the robots can choose.
    """
    n_roles = len(Activity)
    roles, behaviors = _one_hots(n_roles), _one_hots(n_behaviors)

    def own(name: str, size: int, values: Callable[[View], NDArray[Any]]) -> Field:
        return Field(name, "self", size, 0, 1, lambda v: values(v)[:, None])

    def of_people(
        name: str, low: float, values: Callable[[View], NDArray[Any] | float]
    ) -> Field:
        return Field(name, "person", 1, low, 1, values)

    return (
        own("own_behavior", n_behaviors, lambda v: behaviors[v.behavior]),
        own("own_time_left", 1, lambda v: v.left[:, None]),
        own("own_touches", 2, lambda v: v.touches),
        of_people("person_here", 0, lambda _: 1.0),
        Field("person_offset", "person", 2, -1, 1, _to_people),
        Field("person_activity", "person", n_roles, 0, 1, lambda v: roles[v.activity]),
        of_people("person_walks", 0, lambda v: v.walking[:, None]),
        of_people("person_attends", 0, lambda v: v.attends.T[..., None]),
        of_people("person_attention", 0, lambda v: v.attention.T[..., None]),
        of_people("person_faces", -1, lambda v: v.facing.T[..., None]),
        of_people("person_mood", -1, lambda v: v.mood[..., None]),
        Field("robot_here", "robot", 1, 0, 1, lambda _: 1.0),
        Field("robot_offset", "robot", 2, -1, 1, _to_other_robots),
        Field(
            "robot_behavior",
            "robot",
            n_behaviors,
            0,
            1,
            lambda v: behaviors[v.behavior[_others(len(v.behavior))]],
        ),
    )


class Features:
    """The feature encoding of a scenario.

    Attributes:
        layout: Name of each field to its slice of the observation.
        space: The same for every robot.
    """

    def __init__(self, scenario: Scenario) -> None:
        slots = {
            "self": 1,
            "person": scenario.slots.people or len(scenario.people),
            "robot": (scenario.slots.robots or len(scenario.robots)) - 1,
        }
        self._fields = fields(len(scenario.behaviors))
        lengths = [slots[f.slot] * f.size for f in self._fields]
        ends = np.cumsum(lengths).tolist()
        self.layout = {
            f.name: slice(end - length, end)
            for f, length, end in zip(self._fields, lengths, ends, strict=True)
        }
        low = np.repeat([f.low for f in self._fields], lengths)
        high = np.repeat([f.high for f in self._fields], lengths)
        self.space = spaces.Box(low.astype(np.float32), high.astype(np.float32))
        # The place of every field in all rows at once, without the padding.
        n_robots = len(scenario.robots)
        here = {"self": 1, "person": len(scenario.people), "robot": n_robots - 1}
        self._rows = np.zeros((n_robots, sum(lengths)), dtype=np.float32)
        places = [
            self._rows[:, self.layout[f.name]].reshape(n_robots, slots[f.slot], f.size)
            for f in self._fields
        ]
        self._places = [
            place[:, : here[f.slot]]
            for f, place in zip(self._fields, places, strict=True)
        ]

    def encode(self, view: View) -> NDArray[np.float32]:
        """Every robot's observation, a new array of shape (n_robots, length)."""
        for field, place in zip(self._fields, self._places, strict=True):
            place[...] = field.values(view)
        return self._rows.copy()


class Situations:
    """The situation encoding: roles and who attends to the robot.

    Attributes:
        space: The same for every robot.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._slots = scenario.slots.people or len(scenario.people)
        self.space = spaces.Dict(
            {
                "activities": spaces.MultiDiscrete([len(Activity)] * self._slots),
                "attention": spaces.MultiBinary(self._slots),
            }
        )

    def encode(self, view: View) -> list[dict[str, NDArray[Any]]]:
        """Every robot's observation; padding is `UNKNOWN` and unattending."""
        n = len(view.activity)
        encoded: list[dict[str, NDArray[Any]]] = []
        for robot in range(len(view.behavior)):
            activities = np.full(self._slots, int(Activity.UNKNOWN), dtype=np.int64)
            attention = np.zeros(self._slots, dtype=np.int8)
            activities[:n] = view.activity
            attention[:n] = view.attends[:, robot]
            encoded.append({"activities": activities, "attention": attention})
        return encoded


ENCODINGS: dict[str, type[Features] | type[Situations]] = {
    "features": Features,
    "situation": Situations,
}


def layout(scenario: Scenario) -> dict[str, slice]:
    """Where each field of the feature encoding stands, by name."""
    return Features(scenario).layout
