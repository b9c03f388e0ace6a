"""Golden runs: every learner of the catalog lives through the same evening."""

import numpy as np

from experiments.running.study import Condition, Trial
from experiments.running.trial import play
from household import household_v0
from learners import CATALOG, make_team
from policies.learning import LearningRobot, Observer, run_episode

from .digest import Digests
from .records import of_credit, of_situation

SEED = 7
SCENARIO = "evening"
"""Two robots and four people with tastes of their own; some hundred decisions each."""

SHARINGS = {"team_shared": "shared", "team_carried": "carried"}
RUNS = (*CATALOG, *SHARINGS)
"""The catalog, and teams whose robots have something of each other's experience."""


class Notes(Observer):
    """Takes in what robots choose and credit, and remembers the situations met."""

    def __init__(self) -> None:
        self.digests = Digests()
        self.met = {}

    def acted(self, env, robots) -> None:
        for agent, robot in robots.items():
            self.digests.add("actions", robot.pair.action)
            self.met.setdefault((agent, robot.pair.state))
            self._note_credits(robot)

    def finished(self, env, robots) -> None:
        for robot in robots.values():
            self._note_credits(robot)
        for agent, state in self.met:
            # Some analogies learn of situations that are never met like this.
            smaller = [state.without(entity) for entity in state.entities]
            for each in (state, *smaller):
                values = robots[agent].learner.q_values(each)
                self.digests.add("values", (agent, of_situation(each), values))

    def _note_credits(self, robot) -> None:
        if robot.experience is not None:
            credits = [of_credit(credit) for credit in robot.credits]
            self.digests.add("credits", credits)


def run(name: str) -> dict[str, str]:
    """The digests of a learner's golden run, by what they are of."""
    notes = Notes()
    if name in SHARINGS:
        live_as_team(SHARINGS[name], notes)
    else:
        condition = Condition(name="golden", scenario=SCENARIO, learner=name)
        play(Trial(condition=condition, seed=SEED), [notes])
    return notes.digests.told()


def live_as_team(sharing: str, notes: Notes) -> None:
    """The same evening for a team of learners that draw analogies."""
    env = household_v0.parallel_env(SCENARIO)
    team = make_team(
        "designated_swap",
        env.possible_agents,
        len(env.behaviors),
        np.random.default_rng(SEED),
        sharing=sharing,
    )
    robots = {name: LearningRobot(team.member(name)) for name in env.possible_agents}
    run_episode(env, robots, seed=SEED, observers=[notes])
