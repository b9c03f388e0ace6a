"""Observations: one field table from which spaces and values both come.

Everything is relative to the robot that observes. Slots for people and robots that the
household does not have are padding: all their elements are 0.
"""

from collections.abc import Callable
from dataclasses import dataclass
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
        people: Positions, shape (n_people, 2) [m].
        robots: Positions, shape (n_robots, 2) [m].
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

    people: Array
    robots: Array
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
        values: From the view to an array (n_robots, n_slots, size).
    """

    name: str
    slot: str
    size: int
    low: float
    high: float
    values: Callable[[View], Array]


def _one_hot(index: NDArray[np.intp] | NDArray[np.int_], size: int) -> Array:
    """Rows of zeros with a one at the index; no one where the index is negative."""
    return (index[..., None] == np.arange(size)).astype(np.float64)


def _offsets(of: Array, to: Array) -> Array:
    """Offsets from each robot, in units of `REACH`, shape (n_robots, n, 2)."""
    return np.clip((of[None, :, :] - to[:, None, :]) / REACH, -1.0, 1.0)


def _others(values: Array) -> Array:
    """Drops each robot's own row from an array (n_robots, n_robots, size)."""
    n = len(values)
    rows = [[j for j in range(n) if j != i] for i in range(n)]
    kept = values[np.arange(n)[:, None], np.array(rows, dtype=np.intp).reshape(n, -1)]
    return kept.reshape(n, n - 1, values.shape[-1])


def _for_each_robot(values: Array, view: View) -> Array:
    """The same rows for every robot: (n, size) to (n_robots, n, size)."""
    return np.broadcast_to(values, (len(view.robots), *values.shape))


def fields(n_behaviors: int) -> tuple[Field, ...]:
    """The field table.

    Args:
        n_behaviors: How many behaviors the robots can choose.
    """

    def behavior(view: View) -> Array:
        return _one_hot(view.behavior, n_behaviors)

    return (
        Field(
            "own_behavior", "self", n_behaviors, 0, 1, lambda v: behavior(v)[:, None]
        ),
        Field("own_time_left", "self", 1, 0, 1, lambda v: v.left[:, None, None]),
        Field("own_touches", "self", 2, 0, 1, lambda v: v.touches[:, None]),
        Field("person_here", "person", 1, 0, 1, lambda v: np.ones((*v.mood.shape, 1))),
        Field(
            "person_offset", "person", 2, -1, 1, lambda v: _offsets(v.people, v.robots)
        ),
        Field(
            "person_activity",
            "person",
            len(Activity),
            0,
            1,
            lambda v: _for_each_robot(_one_hot(v.activity, len(Activity)), v),
        ),
        Field(
            "person_walks",
            "person",
            1,
            0,
            1,
            lambda v: _for_each_robot(v.walking[:, None].astype(np.float64), v),
        ),
        Field(
            "person_attends",
            "person",
            1,
            0,
            1,
            lambda v: v.attends.T[..., None].astype(np.float64),
        ),
        Field(
            "person_attention", "person", 1, 0, 1, lambda v: v.attention.T[..., None]
        ),
        Field("person_faces", "person", 1, -1, 1, lambda v: v.facing.T[..., None]),
        Field("person_mood", "person", 1, -1, 1, lambda v: v.mood[..., None]),
        Field(
            "robot_here",
            "robot",
            1,
            0,
            1,
            lambda v: np.ones((len(v.robots), len(v.robots) - 1, 1)),
        ),
        Field(
            "robot_offset",
            "robot",
            2,
            -1,
            1,
            lambda v: _others(_offsets(v.robots, v.robots)),
        ),
        Field(
            "robot_behavior",
            "robot",
            n_behaviors,
            0,
            1,
            lambda v: _others(_for_each_robot(behavior(v), v)),
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
        self._lengths = [slots[field.slot] * field.size for field in self._fields]
        ends = np.cumsum(self._lengths)
        self.layout = {
            field.name: slice(int(end) - length, int(end))
            for field, length, end in zip(
                self._fields, self._lengths, ends, strict=True
            )
        }
        low = np.repeat([f.low for f in self._fields], self._lengths)
        high = np.repeat([f.high for f in self._fields], self._lengths)
        self.space = spaces.Box(low.astype(np.float32), high.astype(np.float32))

    def encode(self, view: View) -> NDArray[np.float32]:
        """Every robot's observation, a new array of shape (n_robots, length)."""
        n = len(view.robots)
        rows = np.zeros((n, self.space.shape[0]), dtype=np.float32)
        for field, place in zip(self._fields, self.layout.values(), strict=True):
            values = field.values(view).reshape(n, -1)
            rows[:, place.start : place.start + values.shape[1]] = values
        return rows


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
        for robot in range(len(view.robots)):
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
