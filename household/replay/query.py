"""Query: recordings as Polars frames of touches, choices and situations.

from household.replay import read
found = read("runs/evening")  # a recording, or a folder of them
found.touches.group_by("giver", "kind").len()
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from household.errors import HouseholdError, shown_path
from household.perception.reading import SituationReader
from household.replay.probing import check_readable
from household.replay.reading import Replay, read_replay

if TYPE_CHECKING:
    import polars as pl

    from household.simulation.snapshot import Touch

ENDING = ".rrd"


@dataclass(frozen=True)
class Frames:
    """What happened in recordings, a row for each event.

    In every frame, `recording` is the file, relative to the folder that was read, and
    `decision` and `time` [s] say when. Columns of results from `household train` that
    have the same name have the same values.

    Attributes:
        touches: Each touch: the `decision` of the step in which it was felt, its
            `time`, `robot`, `giver`, `kind`, `value` in [-1, 1] (a tap is negative),
            `attending`, `mood` as the robot read it, `approach_began` and
            `attention_began` [s], if seen; what it was really about: `cause_robot`,
            `cause_bout` (the decision at which that bout began), `cause_behavior`,
            `cause_time`; what the learner believes: `credited_behavior` and
            `credited_time`, of the designated entry or else of the one with the largest
            share, and that `share`; null without a learner, or without an entry.
        choices: Each bout that a robot began: `decision`, `time`, `until` [s], `robot`,
            `behavior`, `value` that its learner expected of it (null without a
            learner), `caresses` and `taps` felt before the next one, and `reward`,
            their sum.
        situations: Each stretch of time in which a robot sees the same situation: a row
            for each person, with `decision`, `time`, `until` [s], `robot`, `person`,
            its `role`, and whether it `attends` to the robot. Who is near the robot and
            who would hear it is not recorded.
    """

    touches: pl.DataFrame
    choices: pl.DataFrame
    situations: pl.DataFrame


def read(path: Path | str) -> Frames:
    """Reads a recording, or all in a folder and its folders, in order of their names.

    Raises:
        HouseholdError: If there is none, or one cannot be read.
    """
    import polars as pl

    place = Path(path)
    files = sorted(place.rglob(f"*{ENDING}")) if place.is_dir() else [place]
    if not files:
        raise HouseholdError(f"{shown_path(path)}: no recordings in this folder")
    check_readable(*files)
    tables: dict[str, list[pl.DataFrame]] = {}
    for file in files:
        name = str(file.relative_to(place).as_posix() if place.is_dir() else file.name)
        for kind, rows, schema in _tables(read_replay(file, tried=True)):
            frame = pl.DataFrame(list(rows), schema, orient="row")
            whole = frame.select(pl.lit(name).alias("recording"), pl.all())
            tables.setdefault(kind, []).append(whole)
    return Frames(**{kind: pl.concat(parts) for kind, parts in tables.items()})


Rows = Iterator[tuple[Any, ...]]


def _tables(replay: Replay) -> tuple[tuple[str, Rows, dict[str, Any]], ...]:
    """Name, rows and columns of each frame."""
    import polars as pl

    when = {"decision": pl.Int64, "time": pl.Float64}
    about = {
        **{"robot": pl.String, "giver": pl.String, "kind": pl.String},
        **{"value": pl.Float64, "attending": pl.Boolean, "mood": pl.Float64},
        **{"approach_began": pl.Float64, "attention_began": pl.Float64},
        **{"cause_robot": pl.String, "cause_bout": pl.Int64},
        **{"cause_behavior": pl.String, "cause_time": pl.Float64},
        **{"credited_behavior": pl.String, "credited_time": pl.Float64},
        "share": pl.Float64,
    }
    bout = {
        **{"until": pl.Float64, "robot": pl.String, "behavior": pl.String},
        **{"value": pl.Float64, "caresses": pl.Int64, "taps": pl.Int64},
        "reward": pl.Float64,
    }
    view = {
        **{"until": pl.Float64, "robot": pl.String, "person": pl.String},
        **{"role": pl.String, "attends": pl.Boolean},
    }
    return (
        ("touches", _touches(replay), when | about),
        ("choices", _choices(replay), when | bout),
        ("situations", _situations(replay), when | view),
    )


def _touches(replay: Replay) -> Rows:
    credits = _credits(replay)
    behaviors, robots = replay.scenario.behaviors, replay.scenario.robot_names
    for decision, touches in sorted(replay.touches.items()):
        for touch in touches:
            felt, cause = touch.feedback, touch.cause
            key = (robots.index(touch.robot), felt.giver, felt.time)
            yield (
                *(decision, felt.time, touch.robot, felt.giver, felt.kind),
                *(felt.value, felt.attending, felt.mood),
                *(felt.approach_began, felt.attention_began),
                *(cause.robot, cause.decision, behaviors[cause.behavior], cause.time),
                *credits.get(key, (None, None, None)),
            )


def _credits(replay: Replay) -> dict[tuple[int, str, float], tuple[str, float, float]]:
    """What each touch was believed to be for, by robot, giver and time."""
    table = replay.credits
    best: dict[tuple[int, str, float], tuple[Any, tuple[str, float, float]]] = {}
    if not table:
        return {}
    names = ("robot", "giver", "touch_time", "time", "behavior", "weight", "designated")
    for row in zip(*(table[name].tolist() for name in names), strict=True):
        robot, giver, touched, time, behavior, weight, designated = row
        rank = (bool(designated), weight)
        known = best.get((robot, giver, touched))
        if known is None or rank > known[0]:
            named = replay.scenario.behaviors[behavior]
            best[robot, giver, touched] = rank, (named, time, weight)
    return {key: found for key, (_, found) in best.items()}


def _choices(replay: Replay) -> Rows:
    moments, scenario = replay.moments, replay.scenario
    for robot, name in enumerate(scenario.robot_names):
        felt = _felt(replay, name)
        expected = dict(zip(*_expected(replay, name), strict=True))
        begun = moments.begun[:, robot]
        first = np.flatnonzero(np.diff(begun, prepend=-1))
        lasts = np.append(first[1:], len(begun))
        for row, end in zip(first.tolist(), lasts.tolist(), strict=True):
            decision, behavior = int(begun[row]), int(moments.behavior[row, robot])
            touches = [
                touch.feedback
                for at in range(row, end)
                for touch in felt.get(int(moments.decision[at]), ())
            ]
            values = expected.get(decision)
            yield (
                decision,
                decision * scenario.decision_period,
                float(moments.time[end - 1]),
                name,
                scenario.behaviors[behavior],
                None if values is None else float(values[behavior]),
                sum(touch.kind == "caress" for touch in touches),
                sum(touch.kind == "tap" for touch in touches),
                float(sum(touch.value for touch in touches)),
            )


def _felt(replay: Replay, robot: str) -> dict[int, tuple[Touch, ...]]:
    """The touches of one robot, by decision."""
    return {
        decision: tuple(touch for touch in touches if touch.robot == robot)
        for decision, touches in replay.touches.items()
    }


def _expected(replay: Replay, robot: str) -> tuple[list[int], list[Any]]:
    """Decisions at which a learner told what it expects, and what."""
    decisions, values = replay.values.get(robot, (np.zeros(0, int), np.zeros((0, 0))))
    return decisions.tolist(), list(values)


def _situations(replay: Replay) -> Rows:
    moments, scenario = replay.moments, replay.scenario
    reader = SituationReader(scenario)
    seen = [
        reader.seen(activity, attends)
        for activity, attends in zip(moments.activity, moments.attends, strict=True)
    ]
    for robot, name in enumerate(scenario.robot_names):
        own = [each[robot] for each in seen]
        first = [i for i in range(len(own)) if i == 0 or own[i] != own[i - 1]]
        lasts = [*first[1:], len(own) - 1]
        for row, end in zip(first, lasts, strict=True):
            at = int(moments.decision[row]), float(moments.time[row])
            until = float(moments.time[end])
            for person, role in own[row].plays:
                attends = (person, name) in own[row].attends
                yield *at, until, name, person, role, attends
