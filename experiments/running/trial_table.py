"""The table of a trial: one row per history entry, touches and Q-values nested in it.

| column | unit or range | meaning |
| --- | --- | --- |
| robot | | agent name |
| time, next_time | s | when the entry began and ended |
| decision | | environment step at which it began |
| bout | | environment step at which its behavior was chosen |
| situation | | the situation, as text |
| behavior | | name of the behavior |
| chosen | | false if the behavior went on while the situation changed |
| attended | | somebody attended to the robot during the entry |
| reward | | sum of the touches felt in the entry |
| cumulative | | sum of all touches up to the end of the entry |
| opinion | 1 .. 10 | mean answer of the people at the end of the entry |
| q | per behavior | Q-values of the situation when the entry began |
| appropriateness | per behavior, -1 .. 1 | what the people want; evaluation only |
| touches | list | who, when, what for in truth, what for in the learner's belief |
| updates | list | (situation, behavior, value): Q-values that the entry's end changed |
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np
import polars as pl

from learners.learner import Credit, Learner
from policies.learning import Entry, Home, LearningRobot, Lesson, Observer

if TYPE_CHECKING:
    from household.feedback import Cause
    from household.feedback import Feedback as Touch
    from household.scenario.scenario import Scenario

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


def schema(behaviors: Sequence[str]) -> pl.Schema:
    """Returns names and types of the columns for a catalogue of behaviors."""
    per_behavior = pl.Struct(dict.fromkeys(behaviors, pl.Float64))
    columns: dict[str, pl.DataType | type[pl.DataType]] = {
        "robot": pl.String,
        "time": pl.Float64,
        "next_time": pl.Float64,
        "decision": pl.Int64,
        "bout": pl.Int64,
        "situation": pl.String,
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


_PAIR = ("bout", "situation", "behavior")


class Evaluated(Home, Protocol):
    """A home that also tells an evaluator what no robot may know."""

    possible_agents: list[str]

    @property
    def scenario(self) -> Scenario:
        """What was asked for, with every default filled in."""

    @property
    def behaviors(self) -> tuple[str, ...]:
        """Names of the behaviors."""

    def causes(self, agent: str, /) -> Sequence[Cause]:
        """What each touch of the last step was really about."""

    def appropriateness(self, agent: str, /) -> np.ndarray:
        """How much the people want each behavior, shape (n_behaviors,)."""

    def opinion(self, agent: str, /) -> Mapping[str, float]:
        """Each person's answer to the questionnaire, 1 to 10."""


@dataclass
class _Diary:
    """What one robot lived through so far."""

    rows: list[dict[str, Any]] = field(default_factory=list)
    opened: Entry | None = None
    opening: dict[str, Any] = field(default_factory=dict)
    touches: list[tuple[Touch, Cause]] = field(default_factory=list)
    states: dict[str, Hashable] = field(default_factory=dict)
    values: dict[str, list[float]] = field(default_factory=dict)
    begun: list[float] = field(default_factory=list)
    """Times of `rows` and of the opened entry, for looking up a time."""

    bouts: list[tuple[int, str, str]] = field(default_factory=list)
    """(bout, situation, behavior) of each entry in `begun`."""


class Rows(Observer):
    """Watches an episode and keeps its table."""

    def __init__(self) -> None:
        self._behaviors: tuple[str, ...] = ()
        self._diaries: dict[str, _Diary] = {}

    def frame(self) -> pl.DataFrame:
        """Returns the table so far, robot by robot, in the order of time."""
        rows = [row for diary in self._diaries.values() for row in diary.rows]
        return pl.DataFrame(rows, schema=schema(self._behaviors), orient="row")

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Begins a new table."""
        self._behaviors = _evaluated(env).behaviors
        self._diaries = {agent: _Diary() for agent in robots}

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Notes the entries that are over and those that began."""
        for agent, robot in robots.items():
            self._close(_evaluated(env), agent, robot)
            entry = robot.entry
            if entry is not None and entry is not self._diaries[agent].opened:
                self._open(_evaluated(env), agent, robot.learner, entry)

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Notes the touches of the step with their true causes."""
        for agent, diary in self._diaries.items():
            felt = env.feedback(agent)
            causes = _evaluated(env).causes(agent)
            diary.touches += zip(felt, causes, strict=True)

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Notes the last entries."""
        for agent, robot in robots.items():
            self._close(_evaluated(env), agent, robot)

    def _open(self, env: Evaluated, agent: str, learner: Learner, entry: Entry) -> None:
        diary = self._diaries[agent]
        text, behavior = str(entry.state), self._behaviors[entry.action]
        bout = entry.decision if entry.chosen else diary.bouts[-1][0]
        q = learner.q_values(entry.state)
        diary.opened = entry
        diary.states[text] = entry.state
        diary.values.setdefault(text, q.tolist())
        diary.begun.append(entry.time)
        diary.bouts.append((bout, text, behavior))
        diary.opening = {
            "robot": agent,
            "time": entry.time,
            "decision": entry.decision,
            "bout": bout,
            "situation": text,
            "behavior": behavior,
            "chosen": entry.chosen,
            "q": self._named(q),
            "appropriateness": self._named(env.appropriateness(agent)),
        }

    def _close(self, env: Evaluated, agent: str, robot: LearningRobot) -> None:
        diary, lesson = self._diaries[agent], robot.lesson
        if lesson is None or lesson.entry is not diary.opened:
            return
        reward = sum(touch.value for touch, _ in diary.touches)
        before = diary.rows[-1]["cumulative"] if diary.rows else 0.0
        opinions = list(env.opinion(agent).values())
        diary.rows.append(
            diary.opening
            | {
                "next_time": lesson.experience.next_time,
                "attended": lesson.experience.attended,
                "reward": reward,
                "cumulative": before + reward,
                "opinion": float(np.mean(opinions)) if opinions else None,
                "touches": self._touches(diary, lesson),
                "updates": self._updates(diary, robot.learner),
            }
        )
        diary.touches = []

    def _touches(self, diary: _Diary, lesson: Lesson) -> list[dict[str, Any]]:
        credited = [
            self._credited(
                diary, next((c for c in lesson.credits if c.feedback == f), None)
            )
            for f in lesson.experience.feedback
        ]
        return [
            {
                "time": touch.time,
                "giver": touch.giver,
                "value": touch.value,
                "attending": touch.attending,
                "cause_robot": cause.robot,
                **_prefixed("cause", self._truth(cause)),
                **_prefixed("credited", belief),
            }
            for (touch, cause), belief in zip(diary.touches, credited, strict=True)
        ]

    def _truth(self, cause: Cause) -> dict[str, Any]:
        """The pair that was in force when the giver judged the bout that it meant."""
        diary = self._diaries.get(cause.robot)
        return _at(diary, cause.time, cause.decision) | {
            "behavior": self._behaviors[cause.behavior]
        }

    def _credited(self, diary: _Diary, credit: Credit | None) -> dict[str, Any]:
        if credit is None:
            return dict.fromkeys(_PAIR)
        heaviest = max(credit.shares, key=lambda share: share.weight, default=None)
        share = credit.designated or heaviest
        if share is None:
            return dict.fromkeys(_PAIR)
        return {
            "bout": _at(diary, share.time)["bout"],
            "situation": str(share.state),
            "behavior": self._behaviors[share.action],
        }

    def _updates(self, diary: _Diary, learner: Learner) -> list[dict[str, Any]]:
        """The Q-values of the situations met so far that are not what they were."""
        found = []
        for text, state in diary.states.items():
            values, before = learner.q_values(state).tolist(), diary.values[text]
            if values == before:
                continue
            diary.values[text] = values
            for name, value, old in zip(self._behaviors, values, before, strict=True):
                if value != old:
                    found.append({"situation": text, "behavior": name, "value": value})
        return found

    def _named(self, values: np.ndarray) -> dict[str, float]:
        return dict(zip(self._behaviors, map(float, values), strict=True))


def _at(diary: _Diary | None, time: float, latest_bout: float = inf) -> dict[str, Any]:
    """Bout, situation and behavior that were in force at a time; None if unknown.

    Args:
        diary: Of the robot; None if it keeps none.
        time: [s].
        latest_bout: Entries of later bouts are passed over: a bout that is judged as it
            ends is followed by the next one at the same moment.
    """
    index = bisect_right(diary.begun, time + 1e-9) - 1 if diary else -1
    while diary and index >= 0 and diary.bouts[index][0] > latest_bout:
        index -= 1
    if diary is None or index < 0:
        return dict.fromkeys(_PAIR)
    return dict(zip(_PAIR, diary.bouts[index], strict=True))


def _prefixed(prefix: str, values: Mapping[str, Any]) -> dict[str, Any]:
    return {f"{prefix}_{key}": value for key, value in values.items()}


def _evaluated(env: Home) -> Evaluated:
    return cast(Evaluated, env)
