"""The columns of a trial's table: one row per history entry.

| column | unit or range | meaning |
| --- | --- | --- |
| robot | | agent name |
| time, next_time | s | when the entry began and ended |
| decision | | environment step at which it began |
| bout | | environment step at which its behavior was chosen |
| situation | | key of the situation: equal keys, equal situations |
| roles | list | who played which role in the situation |
| attention | list | who attended to whom in the situation |
| behavior | | name of the behavior |
| chosen | | false if the behavior went on while the situation changed |
| attended | | somebody attended to the robot during the entry |
| reward | | sum of the touches felt in the entry |
| cumulative | | sum of all touches up to the end of the entry |
| opinion | 1 .. 10 | mean answer of the people at the end of the entry |
| q | per behavior | Q-values of the situation when the entry began |
| appropriateness | per behavior, -1 .. 1 | what the people want; null if not chosen |
| touches | list | who, when, what for in truth, what for in the learner's belief |
| updates | list | (situation, behavior, value): Q-values found changed at the end |

Appropriateness is for evaluation alone: no learner sees it.

A situation's key is its text. People may read it; programs read `roles` and
`attention`.

Which Q-values are looked at when an entry ends: those of its own situation, of the
situation that follows, and of all situations that the study follows; when the trial
ends, those of every situation that was met. To look at all of them after each entry
would cost the square of the trial's length.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import polars as pl

from household.perception.situation import Situation

ROLE = pl.Struct({"actor": pl.String, "role": pl.String})
"""One actor and the role that it plays."""

ATTENTION = pl.Struct({"observer": pl.String, "target": pl.String})
"""Somebody, a person or a robot, who attends to somebody."""

SITUATION: dict[str, pl.DataType | type[pl.DataType]] = {
    "situation": pl.String,
    "roles": pl.List(ROLE),
    "attention": pl.List(ATTENTION),
}
"""What a situation is, and the key that stands for it."""

TOUCH = pl.Struct(
    {
        "time": pl.Float64,
        "giver": pl.String,
        "value": pl.Float64,
        "attending": pl.Boolean,
        "cause_robot": pl.String,
        "cause_bout": pl.Int64,
        "cause_situation": pl.String,
        "cause_behavior": pl.String,
        "credited_bout": pl.Int64,
        "credited_situation": pl.String,
        "credited_behavior": pl.String,
    }
)
"""One touch: the pair that it is truly about and the pair the learner gave it to.

A bout is named by the environment step at which it was chosen. The credited pair is
the designated one, or the one with the largest share where none was designated.
"""

UPDATE = pl.Struct({"situation": pl.String, "behavior": pl.String, "value": pl.Float64})
"""A Q-value that was found changed, and its new value."""


def schema(behaviors: Sequence[str]) -> pl.Schema:
    """Returns names and types of the columns for a catalog of behaviors."""
    per_behavior = pl.Struct(dict.fromkeys(behaviors, pl.Float64))
    columns: dict[str, pl.DataType | type[pl.DataType]] = {
        "robot": pl.String,
        "time": pl.Float64,
        "next_time": pl.Float64,
        "decision": pl.Int64,
        "bout": pl.Int64,
        **SITUATION,
        "behavior": pl.String,
        "chosen": pl.Boolean,
        "attended": pl.Boolean,
        "reward": pl.Float64,
        "cumulative": pl.Float64,
        "opinion": pl.Float64,
        "q": per_behavior,
        "appropriateness": per_behavior,
        "touches": pl.List(TOUCH),
        "updates": pl.List(UPDATE),
    }
    return pl.Schema(columns)


COLUMNS = tuple(schema(()).names())
"""Names of the columns, whatever the behaviors."""


def rows_schema(behaviors: Sequence[str]) -> pl.Schema:
    """Returns the columns without what a situation's key stands for."""
    columns = schema(behaviors)
    return pl.Schema(
        {
            name: kind
            for name, kind in columns.items()
            if name == "situation" or name not in SITUATION
        }
    )


def key_of(situation: Situation) -> str:
    """Returns what stands for a situation in every table."""
    return str(situation)


def situation_columns(situation: Situation) -> dict[str, Any]:
    """Returns a situation as its columns: its key, and what the key stands for."""
    return {
        "situation": key_of(situation),
        "roles": [{"actor": actor, "role": role} for actor, role in situation.plays],
        "attention": [
            {"observer": observer, "target": target}
            for observer, target in sorted(situation.attends)
        ],
    }
