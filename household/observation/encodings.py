"""Observations: one field table and the two encodings.

Everything is relative to the robot that observes. Slots for people and robots that the
household does not have are padding: all their elements are 0.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Singles
from household.compiled.jit import bind
from household.observation.frame import CLOSE, Frame, close_of, frame_of
from household.observation.kernel import (
    LEFT_OUT,
    Numbering,
    View,
    write_features,
    write_situations,
)
from household.scenario.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Field:
    """One row of the table.

    Attributes:
        name: Unique; the loops find the field's place by it.
        slot: What it is repeated for: "self", "person" or "robot" (the others).
        size: Elements in each slot.
        low: Least value.
        high: Greatest value.
    """

    name: str
    slot: str
    size: int = 1
    low: float = 0.0
    high: float = 1.0


def fields(n_behaviors: int) -> tuple[Field, ...]:
    """The field table; the last two of a person only where situations hold them.

    Args:
        n_behaviors: How many behaviors the robots can choose.
    """
    return (
        Field("own_behavior", "self", n_behaviors),
        Field("own_time_left", "self"),
        Field("own_touches", "self", 2),
        Field("person_here", "person"),
        Field("person_offset", "person", 2, low=-1.0),
        Field("person_activity", "person", len(Activity)),
        Field("person_walks", "person"),
        Field("person_attends", "person"),
        Field("person_attention", "person"),
        Field("person_faces", "person", low=-1.0),
        Field("person_mood", "person", low=-1.0),
        Field("person_near", "person"),
        Field("person_hears", "person"),
        Field("robot_here", "robot"),
        Field("robot_offset", "robot", 2, low=-1.0),
        Field("robot_behavior", "robot", n_behaviors),
    )


PLACES = np.dtype([(field.name, np.int64) for field in fields(1)])
"""Where each field begins."""


class Features:
    """The feature encoding of a scenario.

    Args:
        scenario: The household.
        frame: What observations have room for; None: what the scenario needs.

    Attributes:
        layout: Name of each field to its slice of the observation.
        space: The same for every robot.
    """

    def __init__(self, scenario: Scenario, frame: Frame | None = None) -> None:
        frame = frame or frame_of(scenario)
        slots = {"self": 1, "person": frame.people, "robot": frame.robots - 1}
        left_out = {f"person_{name}" for name in CLOSE if name not in frame.close}
        table = [f for f in fields(len(frame.behaviors)) if f.name not in left_out]
        lengths = [slots[f.slot] * f.size for f in table]
        ends = np.cumsum(lengths).tolist()
        self.layout = {
            f.name: slice(end - length, end)
            for f, length, end in zip(table, lengths, ends, strict=True)
        }
        low = np.repeat([f.low for f in table], lengths)
        high = np.repeat([f.high for f in table], lengths)
        self.space = spaces.Box(low.astype(np.float32), high.astype(np.float32))
        self._shape = (len(scenario.robots), ends[-1])
        starts = {name: place.start for name, place in self.layout.items()}
        places = tuple(starts.get(name, LEFT_OUT) for name in PLACES.names or ())
        self._of_scenario = (
            np.array([places], dtype=PLACES),
            Numbering(frame.codes(scenario.behaviors), len(frame.behaviors)),
        )
        self._view: View | None = None

    def encode(self, view: View) -> Singles:
        """Every robot's observation, a new array of shape (n_robots, length)."""
        rows = np.empty(self._shape, np.float32)
        self.write(rows, view)
        return rows

    def write(self, rows: Singles, view: View) -> None:
        """Writes every robot's observation into rows that are there already.

        Args:
            rows: Shape (n_robots, length); what they held is overwritten.
            view: What robots may know; a household has one, that is bound once.
        """
        if view is not self._view:
            self._view = view
            self._write = bind(write_features, *self._of_scenario, view)
        self._write(rows)


class Situations:
    """The situation encoding: roles, who attends to the robot, and what else is chosen.

    Attributes:
        space: The same for every robot.
    """

    def __init__(self, scenario: Scenario) -> None:
        slots = scenario.slots.people or len(scenario.people)
        self.space = spaces.Dict(
            {
                "activities": spaces.MultiDiscrete([len(Activity)] * slots),
                "attention": spaces.MultiBinary(slots),
                **{name: spaces.MultiBinary(slots) for name in close_of(scenario)},
            }
        )
        self._names = list(self.space.spaces)
        self._shape = (len(scenario.robots), slots)

    def encode(self, view: View) -> list[dict[str, NDArray[Any]]]:
        """Every robot's observation; padding is `UNKNOWN` and unattending."""
        activities = np.empty(self._shape, np.int64)
        relations = np.empty((1 + len(CLOSE), *self._shape), np.int8)
        write_situations(activities, relations, view)
        arrays: dict[str, NDArray[Any]] = {"activities": activities}
        arrays |= zip(("attention", *CLOSE), relations, strict=True)
        return [
            {name: arrays[name][robot] for name in self._names}
            for robot in range(len(activities))
        ]


ENCODINGS: dict[str, type[Features] | type[Situations]] = {
    "features": Features,
    "situation": Situations,
}


def layout(scenario: Scenario) -> dict[str, slice]:
    """Where each field of the feature encoding stands, by name."""
    return Features(scenario).layout
