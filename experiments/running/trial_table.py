"""Watches a trial and keeps its table; the columns are in `trial_columns`."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from operator import itemgetter
from statistics import fmean
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np
import polars as pl

from experiments.running.frames import frame_of
from experiments.running.trial_columns import (
    SITUATION,
    key_of,
    rows_schema,
    schema,
    situation_columns,
)
from experiments.running.value_log import Predicate, ValueLog
from household.perception.situation import Situation
from learners.experience import Reward
from learners.learner import Credit, Learner
from policies.learning import Home, LearningRobot, Observer, Pair

if TYPE_CHECKING:
    from household.feedback import Cause, Feedback
    from household.scenario.scenario import Scenario

_PAIR = ("bout", "situation", "behavior")


class Evaluated(Home, Protocol):
    """A home that also answers an evaluator what no robot may know."""

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
    """What one robot has lived through so far."""

    log: ValueLog
    rows: list[dict[str, Any]] = field(default_factory=list)
    opened: Pair | None = None
    opening: dict[str, Any] = field(default_factory=dict)
    touches: list[tuple[Feedback, Cause]] = field(default_factory=list)
    begun: list[float] = field(default_factory=list)
    """Times of `rows` and of the opened entry, for looking up a time."""

    bouts: list[tuple[int, str, str]] = field(default_factory=list)
    """(bout, situation, behavior) of each entry in `begun`."""


class TrialTable(Observer):
    """Watches an episode and keeps its table.

    Args:
        followed: Situations whose Q-values are looked at after every entry.
    """

    def __init__(self, followed: Sequence[Predicate] = ()) -> None:
        self._followed = followed
        self._behaviors: tuple[str, ...] = ()
        self._diaries: dict[str, _Diary] = {}
        self._keys: dict[Situation, str] = {}

    def frame(self) -> pl.DataFrame:
        """Returns the table so far, robot by robot, in the order of time."""
        rows = [row for diary in self._diaries.values() for row in diary.rows]
        table = frame_of(rows, rows_schema(self._behaviors))
        situations = frame_of(list(map(situation_columns, self._keys)), SITUATION)
        whole = table.join(situations, "situation", "left", maintain_order="left")
        return whole.select(schema(self._behaviors).names())

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Begins a new table."""
        self._behaviors = _evaluated(env).behaviors
        self._diaries = {agent: _Diary(ValueLog(self._followed)) for agent in robots}

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Notes the entries that are over and those that began."""
        for agent, robot in robots.items():
            self._close(_evaluated(env), agent, robot)
            pair = robot.pair
            if pair is not None and pair is not self._diaries[agent].opened:
                self._open(_evaluated(env), agent, robot.learner, pair)

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Notes the touches of the step with their true causes."""
        for agent, diary in self._diaries.items():
            felt = env.feedback(agent)
            if felt:
                diary.touches += zip(felt, _evaluated(env).causes(agent), strict=True)

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Notes the last entries, and the Q-values that were learned."""
        for agent, robot in robots.items():
            self._close(_evaluated(env), agent, robot)
            diary = self._diaries[agent]
            if diary.rows:
                learned = diary.log.all_changes(robot.learner)
                diary.rows[-1]["updates"] += self._updates(learned)

    def _open(self, env: Evaluated, agent: str, learner: Learner, pair: Pair) -> None:
        diary, situation = self._diaries[agent], cast(Situation, pair.state)
        key, behavior = self._key(situation), self._behaviors[pair.action]
        bout = pair.decision if pair.chosen else diary.bouts[-1][0]
        diary.opened = pair
        diary.begun.append(pair.time)
        diary.bouts.append((bout, key, behavior))
        diary.opening = {
            "robot": agent,
            "time": pair.time,
            "decision": pair.decision,
            "bout": bout,
            "situation": key,
            "behavior": behavior,
            "chosen": pair.chosen,
            "q": self._named(diary.log.values(learner, situation)),
            "appropriateness": self._named(env.appropriateness(agent).tolist())
            if pair.chosen
            else None,
        }

    def _close(self, env: Evaluated, agent: str, robot: LearningRobot) -> None:
        diary, experience = self._diaries[agent], robot.experience
        if experience is None:
            return
        reward = sum(touch.value for touch, _ in diary.touches)
        before = diary.rows[-1]["cumulative"] if diary.rows else 0.0
        opinions = list(env.opinion(agent).values())
        seen = (experience.state, experience.next_state)
        changes = diary.log.changes(robot.learner, cast(Sequence[Situation], seen))
        diary.rows.append(
            diary.opening
            | {
                "next_time": experience.next_time,
                "attended": experience.attended,
                "reward": reward,
                "cumulative": before + reward,
                "opinion": fmean(opinions) if opinions else None,
                "touches": self._touches(diary, experience.rewards, robot.credits),
                "updates": self._updates(changes),
            }
        )
        diary.touches = []

    def _touches(
        self, diary: _Diary, rewards: Sequence[Reward], credits: Sequence[Credit]
    ) -> list[dict[str, Any]]:
        credited = [
            self._credited(diary, next((c for c in credits if c.reward == r), None))
            for r in rewards
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
        heaviest, _ = max(credit.shares, key=itemgetter(1), default=(None, 0.0))
        entry = credit.designated or heaviest
        if entry is None:
            return dict.fromkeys(_PAIR)
        return {
            "bout": _at(diary, entry.time)["bout"],
            "situation": self._key(cast(Situation, entry.state)),
            "behavior": self._behaviors[entry.action],
        }

    def _updates(
        self, changes: Iterable[tuple[Situation, int, float]]
    ) -> list[dict[str, Any]]:
        return [
            {
                "situation": self._key(situation),
                "behavior": self._behaviors[behavior],
                "value": value,
            }
            for situation, behavior, value in changes
        ]

    def _key(self, situation: Situation) -> str:
        key = self._keys.get(situation)
        if key is None:
            key = self._keys[situation] = key_of(situation)
        return key

    def _named(self, values: Iterable[float]) -> dict[str, float]:
        return dict(zip(self._behaviors, values, strict=True))


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
