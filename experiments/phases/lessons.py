"""The first phase: robots learn in many households, one after the other."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from experiments.phases.drawing import trained_in
from experiments.phases.probed import Row
from experiments.phases.records import Phases
from experiments.phases.robots import Diary, new_team, teach
from experiments.phases.world import household
from experiments.running.study import Trial
from learners.team import Team

if TYPE_CHECKING:
    from learners.learner import Learner

TRAINED = ("trained_touches", "trained_choices", "met")
"""Columns of what was lived through in training."""


def condition_of(trial: Trial) -> Phases:
    """The phases of a trial."""
    return cast(Phases, trial.condition)


def streams_of(trial: Trial) -> list[np.random.SeedSequence]:
    """Streams for: learning, living in training, adapting, choosing."""
    return np.random.SeedSequence(trial.seed, spawn_key=(6,)).spawn(4)


def taught(trial: Trial) -> tuple[Team, Row]:
    """Runs the first phase: all robots together, or each in households of its own."""
    condition = condition_of(trial)
    alone = condition.training.alone
    learning, living, _, _ = streams_of(trial)
    if not alone:
        team, diary = _lesson(condition, trial.seed, learning, living)
        return team, _trained([diary])
    lessons = [
        _lesson(condition, trial.seed, one, other)
        for one, other in zip(learning.spawn(alone), living.spawn(alone), strict=True)
    ]
    members: dict[Hashable, Learner] = {
        f"robot_{number}": next(iter(team.members.values()))
        for number, (team, _) in enumerate(lessons)
    }
    return Team(members=members), _trained([diary for _, diary in lessons])


def _lesson(
    condition: Phases,
    seed: int,
    learning: np.random.SeedSequence,
    living: np.random.SeedSequence,
) -> tuple[Team, Diary]:
    """Teaches new robots in the households of training."""
    residences = trained_in(condition.training, seed)
    env = household(residences[0], 1)
    rng = np.random.default_rng(learning)
    team = new_team(condition, env.possible_agents, len(env.behaviors), rng)
    words = [int(word) for word in living.generate_state(len(residences))]
    return team, teach(team, residences, condition.training.decisions, words)


def _trained(diaries: Sequence[Diary]) -> Row:
    choices = sum(each.choices for each in diaries)
    return {
        "trained_touches": sum(each.touches for each in diaries),
        "trained_choices": choices,
        "met": sum(each.met for each in diaries) / max(choices, 1),
    }
