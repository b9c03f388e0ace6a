"""The robots of a trial: made, taught, kept as a text, brought back."""

from __future__ import annotations

import copy
import pickle
import tempfile
from collections.abc import Callable, Generator, Hashable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from experiments.errors import ExperimentError
from experiments.phases.records import Phases
from experiments.phases.seeing import SeeingHome, observes
from experiments.phases.world import Residence, household
from experiments.running.trial import describe, make_learner_of
from experiments.scoring.policies import imported
from learners.catalog import CATALOG
from learners.learner import Learner
from learners.team import Team
from policies.learning import Home, LearningRobot, Observer, run_episode

if TYPE_CHECKING:
    from household.environment import Household

Robots = dict[str, LearningRobot]

RANDOM = "random"
"""The reference; the catalog has a learner of this name, which learns nothing."""


def learns(condition: Phases) -> bool:
    """Whether a condition's learner is one; else it is a policy or a reference."""
    name = condition.learner
    if name == RANDOM:
        return False
    return name in CATALOG or (":" in name and not name.startswith(("act:", "const")))


def can_be_kept(condition: Phases) -> bool:
    """Whether what is learned can be stored; one's own learners cannot."""
    return learns(condition) and condition.learner in CATALOG


def new_team(
    condition: Phases, agents: Sequence[str], n_behaviors: int, rng: np.random.Generator
) -> Team:
    """Returns the untaught learners of some robots."""
    members: dict[Hashable, Learner] = {
        agent: _new_learner(condition, n_behaviors, stream)
        for agent, stream in zip(agents, rng.spawn(len(agents)), strict=True)
    }
    return Team(members=members, sharing=condition.sharing)


def _new_learner(
    condition: Phases, n_behaviors: int, rng: np.random.Generator
) -> Learner:
    if condition.learner in CATALOG:
        return make_learner_of(condition, n_behaviors, rng)
    made = imported(condition.learner, "learner")
    if not callable(made):
        raise ExperimentError(f"learner {condition.learner}: is no function.")
    learner: Learner = made(n_behaviors, rng, **condition.learner_overrides)
    return learner


def described_learner(condition: Phases) -> Any:  # noqa: ANN401 - plain data
    """Returns a learner with all its settings, as plain data."""
    if condition.learner in CATALOG:
        return describe(make_learner_of(condition))
    return dict(condition.learner_overrides)


def robots_of(team: Team) -> Robots:
    """Returns the robots of a team."""
    alone = len(team.members) == 1
    return {
        str(agent): LearningRobot(learner if alone else team.member(agent))
        for agent, learner in team.members.items()
    }


def kept(team: Team) -> str:
    """Returns all that some learners are as a text; their history is forgotten.

    That is what the next episode would begin with, and it is most of the text.
    """
    for learner in team.members.values():
        learner.start_episode()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "team.json"
        team.save(file)
        return file.read_text("utf-8")


def brought_back(text: str) -> Team:
    """Returns the learners that a text holds; they go on where they were."""
    from learners.saving import load

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "team.json"
        file.write_text(text, encoding="utf-8")
        team: Team = load(file)
    return team


def copies(team: Team, condition: Phases) -> Callable[[], Team]:
    """Returns what makes a copy of learners each time it is called.

    Those of the catalog are pickled, which takes less time than a text; of one's own it
    is not known what they hold.
    """
    if can_be_kept(condition):
        return partial(pickle.loads, pickle.dumps(team, pickle.HIGHEST_PROTOCOL))
    return partial(copy.deepcopy, team)


class Diary(Observer):
    """Counts what robots live through as they learn."""

    def __init__(self) -> None:
        self.touches, self.choices, self.met = 0, 0, 0
        self._known: set[Hashable] = set()

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Counts choices, and those made in a situation that was met before."""
        for robot in robots.values():
            pair = robot.pair
            if pair is not None and pair.chosen and pair.decision == env.decision:
                self.choices += 1
                self.met += pair.state in self._known
                self._known.add(pair.state)

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Counts touches."""
        self.touches += sum(len(env.feedback(agent)) for agent in robots)


def home_of(team: Team, residence: Residence, steps: int) -> Household:
    """Returns a household as these learners want to see it."""
    env = household(residence, steps)
    if any(observes(learner) for learner in team.members.values()):
        return cast("Household", SeeingHome(env))
    return env


def teach(
    team: Team, residences: Sequence[Residence], decisions: int, words: Sequence[int]
) -> Diary:
    """Lets robots learn in households, one after the other.

    Args:
        team: The learners; they change.
        residences: Where.
        decisions: Steps in each household.
        words: Seed of the episode in each household.
    """
    diary = Diary()
    for residence, word in zip(residences, words, strict=True):
        if decisions:
            env = home_of(team, residence, decisions)
            run_episode(env, robots_of(team), seed=word, observers=[diary])
    return diary


def touched(
    env: Household, robots: Robots, seed: int, diary: Diary
) -> Generator[None, None, None]:
    """Lets robots learn in a household, step by step.

    Args:
        env: The household.
        robots: They learn.
        seed: Of the episode.
        diary: Counts what they live through.

    Yields:
        Whenever they have felt another touch and all that they felt is learned.
    """
    env.reset(seed=seed)
    before = 0
    while env.agents:
        actions = {agent: robots[agent].act(env, agent) for agent in env.agents}
        diary.acted(env, robots)
        learned = all(robot.experience is not None for robot in robots.values())
        if diary.touches > before and learned:
            before = diary.touches
            yield
        env.step(actions)
        diary.stepped(env, actions, robots)
    for agent, robot in robots.items():
        robot.finish(env, agent)
    if diary.touches > before:
        yield
