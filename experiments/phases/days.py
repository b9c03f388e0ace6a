"""Days: what somebody does who goes back and forth between two activities.

A role assignment gives a day to each of two people. That makes assignments
combinatorial: every day can be known of each of the two, and the pair be new.
"""

from __future__ import annotations

from itertools import combinations
from typing import Any

from household.config.toml import packaged, read_toml

ACTIVITIES = ("working", "reading", "sleeping", "playing", "entering", "calling")

DAYS = tuple(combinations(ACTIVITIES, 2))
"""Every pair of activities."""

BEFORE_LEAVING = {"entering": (20.0, 60.0)}
"""How long people stay, where the shipped schedule would have them leave at once [s]:
in a day of two activities each is to be frequent (our choice)."""


def schedule(day: int) -> dict[str, Any]:
    """Returns the schedule of a day, as plain data.

    Args:
        day: Index in `DAYS`.
    """
    shipped = read_toml(packaged("scenario/schedule.toml"))
    one, other = DAYS[day]
    return {
        activity: {
            "duration": list(
                BEFORE_LEAVING.get(activity, shipped[activity]["duration"])
            ),
            "then": {then: 1.0},
        }
        for activity, then in ((one, other), (other, one))
    }
