"""Telling robots of a moment: what they may know of it, and the loops that write it.

Compiled with Numba, as it happens at every step, and NumPy, field by field, takes
many times as long.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.compiled.arrays import Floats, Indices, Integers, Mask, Singles
from household.compiled.jit import (
    FLOATS,
    FLOATS_2D,
    INDICES,
    MASK,
    MASK_2D,
    compiled,
)

REACH = 10.0
"""Distances are given in units of this [m], cut at 1: about the size of a home."""

N_ROLES = len(Activity)
NO_ROLE = int(Activity.UNKNOWN)
"""The role in a slot for a person that the household does not have."""


class View(NamedTuple):
    """All that robots may know of this moment; nothing that people keep to themselves.

    The arrays are those that are there already, with new values at every step. In those
    over n entities people come first and robots after them.

    Attributes:
        position: Where everybody is, shape (n, 2) [m].
        facing: Cosine of the angle between the gaze of i and the direction to j,
            shape (n, n).
        attends: Who attends to whom, shape (n, n).
        attention: How much, shape (n, n).
        walking: Who is on its way, shape (n,).
        activity: Roles, shape (n_people,).
        mood: Moods as each robot perceives them, shape (n_robots, n_people).
        behavior: Index of each robot's behavior, -1 for none, shape (n_robots,).
        left: Share of each robot's bout that is left, shape (n_robots,).
        touches: Sum of caresses and of taps that each robot felt in the last step,
            shape (n_robots, 2), both in [0, 1].
    """

    position: Floats
    facing: Floats
    attends: Mask
    attention: Floats
    walking: Mask
    activity: NDArray[np.int_]
    mood: Floats
    behavior: Indices
    left: Floats
    touches: Floats


VIEW = (
    *(FLOATS_2D, FLOATS_2D, MASK_2D, FLOATS_2D),
    *(MASK, INDICES, FLOATS_2D, INDICES, FLOATS, FLOATS_2D),
)
"""What `View` holds, for `bind`."""


@compiled
def _in_reach(position: Floats, viewer: int, j: int, axis: int) -> float:
    """How far j is from a viewer along an axis, in units of `REACH`."""
    offset = (position[j, axis] - position[viewer, axis]) / REACH
    return min(max(offset, -1.0), 1.0)


@compiled
def _tell_of_itself(row: Singles, at: np.void, view: View, robot: int) -> None:
    """Writes the fields of the slot "self"."""
    if view.behavior[robot] >= 0:
        row[at["own_behavior"] + view.behavior[robot]] = 1.0
    row[at["own_time_left"]] = view.left[robot]
    row[at["own_touches"]] = view.touches[robot, 0]
    row[at["own_touches"] + 1] = view.touches[robot, 1]


@compiled
def _tell_of_person(row: Singles, at: np.void, view: View, robot: int, i: int) -> None:
    """Writes the fields of the slot of a person."""
    me = len(view.activity) + robot
    row[at["person_here"] + i] = 1.0
    row[at["person_offset"] + 2 * i] = _in_reach(view.position, me, i, 0)
    row[at["person_offset"] + 2 * i + 1] = _in_reach(view.position, me, i, 1)
    row[at["person_activity"] + N_ROLES * i + view.activity[i]] = 1.0
    row[at["person_walks"] + i] = view.walking[i]
    row[at["person_attends"] + i] = view.attends[i, me]
    row[at["person_attention"] + i] = view.attention[i, me]
    row[at["person_faces"] + i] = view.facing[i, me]
    row[at["person_mood"] + i] = view.mood[robot, i]


@compiled
def _tell_of_robot(
    row: Singles, at: np.void, view: View, robot: int, slot: int, n_behaviors: int
) -> None:
    """Writes the fields of the slot of another robot."""
    other = slot if slot < robot else slot + 1
    me, it = len(view.activity) + robot, len(view.activity) + other
    row[at["robot_here"] + slot] = 1.0
    row[at["robot_offset"] + 2 * slot] = _in_reach(view.position, me, it, 0)
    row[at["robot_offset"] + 2 * slot + 1] = _in_reach(view.position, me, it, 1)
    if view.behavior[other] >= 0:
        row[at["robot_behavior"] + n_behaviors * slot + view.behavior[other]] = 1.0


@compiled
def tell_features(
    places: NDArray[np.void],
    n_behaviors: int,
    rows: Singles,
    position: Floats,
    facing: Floats,
    attends: Mask,
    attention: Floats,
    walking: Mask,
    activity: NDArray[np.int_],
    mood: Floats,
    behavior: Indices,
    left: Floats,
    touches: Floats,
) -> None:
    """Writes every robot's observation into its row.

    Args:
        places: Where each field begins, by its name, shape (1,).
        n_behaviors: How many behaviors the robots can choose.
        rows: Shape (n_robots, length), holding zeros.
        position: As in `View`, like all that follow.
        facing: Shape (n, n).
        attends: Shape (n, n).
        attention: Shape (n, n).
        walking: Shape (n,).
        activity: Shape (n_people,).
        mood: Shape (n_robots, n_people).
        behavior: Shape (n_robots,).
        left: Shape (n_robots,).
        touches: Shape (n_robots, 2).
    """
    view = View(
        position,
        facing,
        attends,
        attention,
        walking,
        activity,
        mood,
        behavior,
        left,
        touches,
    )
    for robot in range(len(rows)):
        row, at = rows[robot], places[0]
        _tell_of_itself(row, at, view, robot)
        for i in range(len(view.activity)):
            _tell_of_person(row, at, view, robot, i)
        for slot in range(len(rows) - 1):
            _tell_of_robot(row, at, view, robot, slot, n_behaviors)


@compiled
def tell_situations(
    activities: Integers,
    attention: NDArray[np.int8],
    activity: NDArray[np.int_],
    attends: Mask,
) -> None:
    """Writes every robot's situation into its rows.

    Args:
        activities: Shape (n_robots, n_slots).
        attention: Shape (n_robots, n_slots).
        activity: As in `View`.
        attends: As in `View`.
    """
    n_people = len(activity)
    activities[:] = NO_ROLE
    attention[:] = 0
    for robot in range(len(activities)):
        for i in range(n_people):
            activities[robot, i] = activity[i]
            attention[robot, i] = attends[i, n_people + robot]
