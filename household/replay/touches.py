"""Touches as exact columns of a replay file, one row each, and back again."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.feedback import Cause, Feedback
from household.replay.columns import exact, words
from household.simulation.snapshot import Touch


def touch_columns(touches: Sequence[Touch]) -> list[Any]:
    """Touches as columns; NaN where a moment is not known."""
    felt = [touch.feedback for touch in touches]
    causes = [touch.cause for touch in touches]
    began = [(f.approach_began, f.attention_began) for f in felt]
    return [
        words("robot", [touch.robot for touch in touches]),
        words("giver", [f.giver for f in felt]),
        words("kind", [f.kind for f in felt]),
        exact("numbers", np.array([(f.strength, f.time, f.mood) for f in felt])),
        exact("attending", np.array([f.attending for f in felt])),
        exact("began", np.array(began, dtype=np.float64)),
        words("cause_robot", [c.robot for c in causes]),
        exact("cause", np.array([(c.decision, c.behavior) for c in causes])),
        exact("cause_time", np.array([c.time for c in causes])),
    ]


def touches_of(columns: Mapping[str, NDArray[Any]]) -> dict[int, tuple[Touch, ...]]:
    """Touches from the columns that `touch_columns` made, by decision.

    Args:
        columns: By name, ``decision`` among them; none at all if nobody touched.
    """
    touches: dict[int, tuple[Touch, ...]] = {}
    for row, decision in enumerate(columns.get("decision", ())):
        touch = _touch({name: column[row] for name, column in columns.items()})
        touches[int(decision)] = (*touches.get(int(decision), ()), touch)
    return touches


def _touch(row: Mapping[str, Any]) -> Touch:
    strength, time, mood = row["numbers"].tolist()
    approach, attention = (_known(moment) for moment in row["began"].tolist())
    feedback = Feedback(
        giver=row["giver"],
        kind=row["kind"],
        strength=strength,
        time=time,
        mood=mood,
        attending=bool(row["attending"]),
        approach_began=approach,
        attention_began=attention,
    )
    decision, behavior = row["cause"].tolist()
    cause = Cause(row["cause_robot"], decision, behavior, float(row["cause_time"]))
    return Touch(row["robot"], feedback, cause)


def _known(moment: float) -> float | None:
    return None if math.isnan(moment) else moment
