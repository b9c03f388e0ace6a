"""Observations in words, for people who want to see what a robot was told."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES
from household.compiled.arrays import Singles
from household.observation.kernel import DISTANCE_SCALE

RELATIONS = {"near": "near it", "hears": "would hear it"}
"""What people are to the robot, where situations hold it."""


def features_in_words(
    row: Singles,
    layout: Mapping[str, slice],
    people: Sequence[str],
    behaviors: Sequence[str],
) -> str:
    """What a feature observation says, a line for the robot and each other.

    Args:
        row: The observation, shape (length,).
        layout: Name of each field to its slice.
        people: Their names, in order.
        behaviors: What robots can choose, in order.
    """
    table = {name: row[place] for name, place in layout.items()}
    lines = [_self(table, behaviors)]
    for i, name in enumerate(people):
        lines.append(f"{name}: {_person(_slot(table, 'person', i))}")
    for i in np.flatnonzero(table["robot_here"]).tolist():
        lines.append(f"another robot: {_robot(_slot(table, 'robot', i), behaviors)}")
    return "\n".join(lines)


def situation_in_words(parts: Mapping[str, NDArray[Any]], people: Sequence[str]) -> str:
    """What an observation of the situation says, a line for each person.

    Args:
        parts: The observation.
        people: Their names, in order.
    """
    lines = []
    for i, name in enumerate(people):
        held = [ACTIVITY_NAMES[parts["activities"][i]]]
        held += ["attends to it"] if parts["attention"][i] else []
        held += [
            how for key, how in RELATIONS.items() if key in parts and parts[key][i]
        ]
        lines.append(f"{name}: {', '.join(held)}")
    return "\n".join(lines)


def _slot(table: Mapping[str, Singles], kind: str, i: int) -> dict[str, Singles]:
    """The fields of one slot, without the slot's name."""
    n = len(table[f"{kind}_here"])
    return {
        name.removeprefix(f"{kind}_"): values.reshape(n, -1)[i]
        for name, values in table.items()
        if name.startswith(f"{kind}_")
    }


def _self(table: Mapping[str, Singles], behaviors: Sequence[str]) -> str:
    left, (caressed, tapped) = table["own_time_left"][0], table["own_touches"]
    doing = _doing(table["own_behavior"], behaviors)
    parts = [f"the robot: {doing}"]
    if table["own_behavior"].any():
        parts.append(f"{left:.0%} of it left" if left else "which is over")
    parts += [f"caressed ({caressed:.2f})"] if caressed else []
    parts += [f"tapped ({tapped:.2f})"] if tapped else []
    return ", ".join(parts)


def _person(fields: Mapping[str, Singles]) -> str:
    here = {name: values[0] for name, values in fields.items()}
    attends = "attends to it" if here["attends"] else "does not attend to it"
    parts = [
        ACTIVITY_NAMES[int(fields["activity"].argmax())],
        *(["walking"] if here["walks"] else []),
        _away(fields["offset"]),
        f"{attends} (attention {here['attention']:.2f}, gaze {here['faces']:+.2f})",
        f"mood {here['mood']:+.2f}",
        *(how for name, how in RELATIONS.items() if here.get(name)),
    ]
    return ", ".join(parts)


def _robot(fields: Mapping[str, Singles], behaviors: Sequence[str]) -> str:
    return f"{_doing(fields['behavior'], behaviors)}, {_away(fields['offset'])}"


def _doing(chosen: Singles, behaviors: Sequence[str]) -> str:
    return behaviors[int(chosen.argmax())] if chosen.any() else "nothing yet"


def _away(offset: Singles) -> str:
    """How far away somebody is; offsets are cut at `DISTANCE_SCALE`."""
    x, y = (offset.astype(float) * DISTANCE_SCALE).tolist()
    more = " or more" if np.abs(offset).max() >= 1.0 else ""
    return f"{np.hypot(x, y):.1f} m away{more} (x {x:+.1f}, y {y:+.1f})"
