"""What robots may know of a moment, and the loops that write it into observations.

Compiled with Numba, as it happens at every step, and NumPy, field by field, takes
many times as long.
"""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Floats, Indices, Integers, Mask, Singles
from household.compiled.jit import compiled

DISTANCE_SCALE = 10.0
"""Offsets are given in units of this [m], cut at 1: about the size of a home."""

N_ROLES = len(Activity)
NO_ROLE = int(Activity.UNKNOWN)
"""The role in a slot for a person that the household does not have."""

LEFT_OUT = -1
"""In place of where a field begins: observations do not hold it."""


class View(NamedTuple):
    """All that robots may know of this moment; nothing that people keep to themselves.

    The arrays are those that are there already, with new values at every step. In those
    over n entities people come first and robots after them.

    Attributes:
        position: Where everybody is, shape (n, 2) [m].
        facing: Cosine of the angle between the gaze of i and the direction to j,
            shape (n, n).
        attends: Who attends to whom, shape (n, n).
        attention: Share of its attention that i gives to j, shape (n, n).
        walking: Who is on its way, shape (n,).
        activity: Roles, shape (n_people,).
        mood: Moods as each robot perceives them, shape (n_robots, n_people).
        behavior: Index of each robot's behavior, -1 for none, shape (n_robots,).
        left: Share of each robot's bout that is left, shape (n_robots,).
        touches: Sum of caresses and of taps that each robot felt in the last step,
            shape (n_robots, 2), both in [0, 1].
        near: Who is near each robot, shape (n_people, n_robots).
        hears: Who would hear each robot, shape (n_people, n_robots).
    """

    position: Annotated[Floats, "n", 2]
    facing: Annotated[Floats, "n", "n"]
    attends: Annotated[Mask, "n", "n"]
    attention: Annotated[Floats, "n", "n"]
    walking: Annotated[Mask, "n"]
    activity: Annotated[Indices, "n_people"]
    mood: Annotated[Floats, "n_robots", "n_people"]
    behavior: Annotated[Indices, "n_robots"]
    left: Annotated[Floats, "n_robots"]
    touches: Annotated[Floats, "n_robots", 2]
    near: Annotated[Mask, "n_people", "n_robots"]
    hears: Annotated[Mask, "n_people", "n_robots"]


class Numbering(NamedTuple):
    """How observations number behaviors, which may be those of several households.

    Attributes:
        code: The number of each of the household's own behaviors, (n_behaviors,).
        size: How many have a number.
    """

    code: Annotated[Indices, "n_behaviors"]
    size: int


@compiled
def write_features(
    places: NDArray[np.void],
    numbering: Numbering,
    view: View,
    rows: Annotated[Singles, "n_robots", "length"],
) -> None:
    """Writes every robot's observation into its row.

    Args:
        places: Where each field begins, by its name, shape (1,).
        numbering: How behaviors are numbered.
        view: What robots may know.
        rows: Shape (n_robots, length); what they held is overwritten.
    """
    n_robots = len(rows)
    rows[:] = 0.0
    for robot in range(n_robots):
        row, at = rows[robot], places[0]
        _write_self(row, at, view, robot, numbering)
        for i in range(len(view.activity)):
            _write_person(row, at, view, robot, i)
        _write_close(row, at, view, robot)
        for slot in range(n_robots - 1):
            _write_other_robot(row, at, view, robot, slot, numbering)


@compiled
def _write_self(
    row: Singles, at: np.void, view: View, robot: int, numbering: Numbering
) -> None:
    """Writes the fields of the slot "self"."""
    if view.behavior[robot] >= 0:
        row[at["own_behavior"] + numbering.code[view.behavior[robot]]] = 1.0
    row[at["own_time_left"]] = view.left[robot]
    row[at["own_touches"]] = view.touches[robot, 0]
    row[at["own_touches"] + 1] = view.touches[robot, 1]


@compiled
def _write_person(row: Singles, at: np.void, view: View, robot: int, i: int) -> None:
    """Writes the fields of the slot of a person."""
    me = len(view.activity) + robot
    row[at["person_here"] + i] = 1.0
    row[at["person_offset"] + 2 * i] = _offset(view.position, me, i, 0)
    row[at["person_offset"] + 2 * i + 1] = _offset(view.position, me, i, 1)
    row[at["person_activity"] + N_ROLES * i + view.activity[i]] = 1.0
    row[at["person_walks"] + i] = view.walking[i]
    row[at["person_attends"] + i] = view.attends[i, me]
    row[at["person_attention"] + i] = view.attention[i, me]
    row[at["person_faces"] + i] = view.facing[i, me]
    row[at["person_mood"] + i] = view.mood[robot, i]


@compiled
def _write_close(row: Singles, at: np.void, view: View, robot: int) -> None:
    """Writes who is near and who would hear, where situations hold that.

    Apart from the rest: asked for each person, it takes as long as all other fields.
    """
    near, hears = at["person_near"], at["person_hears"]
    if near != LEFT_OUT:
        for i in range(len(view.activity)):
            row[near + i] = view.near[i, robot]
    if hears != LEFT_OUT:
        for i in range(len(view.activity)):
            row[hears + i] = view.hears[i, robot]


@compiled
def _write_other_robot(
    row: Singles, at: np.void, view: View, robot: int, slot: int, numbering: Numbering
) -> None:
    """Writes the fields of the slot of another robot."""
    other = slot if slot < robot else slot + 1
    me, it = len(view.activity) + robot, len(view.activity) + other
    row[at["robot_here"] + slot] = 1.0
    row[at["robot_offset"] + 2 * slot] = _offset(view.position, me, it, 0)
    row[at["robot_offset"] + 2 * slot + 1] = _offset(view.position, me, it, 1)
    if view.behavior[other] >= 0:
        first = at["robot_behavior"] + numbering.size * slot
        row[first + numbering.code[view.behavior[other]]] = 1.0


@compiled
def _offset(position: Floats, viewer: int, j: int, axis: int) -> float:
    """How far j is from a viewer along an axis, in units of `DISTANCE_SCALE`."""
    offset = (position[j, axis] - position[viewer, axis]) / DISTANCE_SCALE
    return min(max(offset, -1.0), 1.0)


@compiled
def write_situations(
    activities: Integers, relations: NDArray[np.int8], view: View
) -> None:
    """Writes every robot's situation into its rows; padding is `NO_ROLE` and 0.

    Args:
        activities: Shape (n_robots, n_slots).
        relations: Who attends to the robot, is near it, would hear it, in this order,
            shape (3, n_robots, n_slots).
        view: What robots may know.
    """
    n_people = len(view.activity)
    activities[:] = NO_ROLE
    relations[:] = 0
    for robot in range(len(activities)):
        for i in range(n_people):
            activities[robot, i] = view.activity[i]
            relations[0, robot, i] = view.attends[i, n_people + robot]
            relations[1, robot, i] = view.near[i, robot]
            relations[2, robot, i] = view.hears[i, robot]
