"""The household as a PettingZoo environment."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from gymnasium import spaces
from gymnasium.utils import EzPickle
from numpy.typing import NDArray
from pettingzoo import ParallelEnv

from household.arguments import check_name, checked_choices, checked_seed, robot_index
from household.compiled.arrays import Floats, Singles
from household.errors import HouseholdError, shown
from household.feedback import Cause, Feedback
from household.observation.encodings import ENCODINGS, Features
from household.observation.notices import Notifier
from household.observation.words import features_in_words, situation_in_words
from household.people.people import MakeMinds
from household.perception.approach import faces
from household.perception.reading import SituationReader
from household.perception.situation import Situation
from household.robots.actions import Actions
from household.robots.bout import Bout
from household.scenario.scenario import Scenario
from household.scenario.validation import load_scenario
from household.simulation.checkpoint import Checkpoint, restore, take
from household.simulation.simulation import Simulation
from household.simulation.snapshot import snapshot
from household.view.painter import Screen

Observation = Any
Results = tuple[
    dict[str, Observation],
    dict[str, float],
    dict[str, bool],
    dict[str, bool],
    dict[str, dict[str, Any]],
]
"""Observations, rewards, terminations, truncations and infos, by agent."""


class Household(ParallelEnv[str, Observation, int], EzPickle):
    """People of a household, and robots that they caress and tap.

    Agents are the robots ``robot_0``, ``robot_1``, ...; an action is the index of a
    behavior; the reward is the sum of the touches felt in this step, caresses in
    (0, 1] and taps in [-1, 0). All robots are truncated together at ``max_cycles``.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario.
        make_minds: Gives the scenario's people their minds.
        observation: "features" or "situation".
        render_mode: "human" shows every step in a window, "rgb_array" makes `render`
            return pictures; both need the extra ``render``.
        **overrides: Top-level fields of the scenario to replace.

    Raises:
        HouseholdError: If the scenario or an argument cannot be used.
    """

    metadata: ClassVar[dict[str, Any]] = {
        "name": "household_v0",
        "render_modes": ["human", "rgb_array"],
        "render_fps": 4,
        "is_parallelizable": True,
    }

    def __init__(
        self,
        scenario: str | Path | Scenario,
        make_minds: MakeMinds,
        observation: str = "features",
        render_mode: str | None = None,
        **overrides: Any,  # noqa: ANN401 - checked against the scenario's fields
    ) -> None:
        check_name(observation, ENCODINGS, "observation")
        if render_mode is not None:
            check_name(render_mode, self.metadata["render_modes"], "render mode")
        self.scenario = load_scenario(scenario, **overrides)
        # What was read, not where from: files may change, or be on another machine.
        EzPickle.__init__(self, self.scenario, make_minds, observation, render_mode)
        self.render_mode = render_mode
        self._screen: Screen | None = None
        self.max_cycles = self.scenario.max_cycles
        self.behaviors = self.scenario.behaviors
        self.possible_agents = list(self.scenario.robot_names)
        self.agents: list[str] = []
        self._index = {agent: i for i, agent in enumerate(self.possible_agents)}
        self.simulation = Simulation(self.scenario, make_minds)
        self._situations = SituationReader(self.scenario)
        self._revision = self.simulation.revision
        self._read: tuple[Situation, ...] = ()
        self._features = Features(self.scenario)
        self._encoding = ENCODINGS[observation](self.scenario)
        self._notifier = Notifier(self.scenario)
        self._notices = self._notifier.new()
        self.observation_spaces: dict[str, spaces.Space[Any]] = dict.fromkeys(
            self.possible_agents, self._encoding.space
        )
        self.action_spaces = {
            agent: Actions(len(self.behaviors), robot)
            for agent, robot in self._index.items()
        }
        self.state_space = _repeated(self._features.space, len(self.possible_agents))

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """The space of an agent's observations, the same object at each call."""
        return self.observation_spaces[self.possible_agents[self._robot(agent)]]

    def action_space(self, agent: str) -> spaces.Discrete:
        """The space of an agent's actions, the same object at each call."""
        return self.action_spaces[self.possible_agents[self._robot(agent)]]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Observation], dict[str, dict[str, Any]]]:
        """Begins an episode.

        Args:
            seed: The same seed gives the same history; None goes on with the history
                that the last seed began.
            options: Not used.

        Returns:
            Observations and infos of all agents, both as after a step.

        Raises:
            HouseholdError: If the seed is no whole number from 0 up.
        """
        checked = checked_seed(seed)
        self.agents = list(self.possible_agents)
        self.simulation.begin(checked)
        self._show()
        return self._observations(), self._infos()

    def step(self, actions: Mapping[str, int]) -> Results:
        """Lets one decision period pass.

        Robots choose behaviors; people walk, look around and touch; everybody
        perceives; people judge what is new to them and decide what to do next.

        Behaviors last longer than a step. An action that repeats the present behavior
        goes on with it, and begins it anew only once it is over; another action
        interrupts it. Whether a choice is due, so that nothing is interrupted, is in
        the infos: `behavior_over`, and an `action_mask` that else leaves only the
        present behavior. `household.held` asks for choices only then.

        Args:
            actions: The behavior of each robot, by agent; a robot without an action
                goes on with what it does.

        Returns:
            Observations, rewards, terminations, truncations and infos by agent; all
            empty once the episode is over. Infos are numbers and arrays of fixed size:
            the fields of `household.observation.notices.Notices`. The touches
            themselves are in `feedback`, the situation in `situation`.

        Raises:
            HouseholdError: Before the first reset, or if an action is none of the
                behaviors or an agent none of the robots.
        """
        self._check_begun()
        choices = checked_choices(actions, self._index, len(self.behaviors))
        if not self.agents:
            return {}, {}, {}, {}, {}
        self.simulation.go_on(choices.items())
        self._show()
        return self._results()

    def checkpoint(self) -> Checkpoint:
        """Takes the whole state of this moment, for `restore`; changes nothing.

        Raises:
            HouseholdError: Before the first reset, or if the people's minds cannot be
                pickled.
        """
        self._check_begun()
        return take(self.simulation, tuple(self.agents))

    def restore(self, checkpoint: Checkpoint) -> None:
        """Goes back, or on, to a moment: from there everything goes on as it did.

        Args:
            checkpoint: Of this environment, or of another one with the same scenario
                and the same kind of minds, in whichever process.

        Raises:
            HouseholdError: If it belongs to another scenario.
        """
        restore(self.simulation, checkpoint)
        self.agents = list(checkpoint.agents)

    def __getstate__(self) -> dict[str, Any]:
        """How it was made, and the moment that it has come to."""
        made: dict[str, Any] = super().__getstate__()
        begun = self.simulation.begun
        return {**made, "checkpoint": self.checkpoint() if begun else None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Makes it anew and goes on to that moment."""
        super().__setstate__(state)
        if state["checkpoint"] is not None:
            self.restore(state["checkpoint"])

    def render(self) -> NDArray[np.uint8] | None:
        """Shows this moment.

        Returns:
            A picture of shape (480, 640, 3) for "rgb_array", else None.

        Raises:
            HouseholdError: If the extra ``render`` is not installed.
        """
        if self.render_mode is None:
            return None
        if self._screen is None:
            fps = self.metadata["render_fps"]
            self._screen = Screen(self.scenario, self.render_mode, fps)
        return self._screen.show(snapshot(self.simulation))

    def _show(self) -> None:
        """Shows this moment to a person, if one is to watch."""
        if self.render_mode == "human":
            self.render()

    def close(self) -> None:
        """Closes the window, if there is one."""
        if self._screen is not None:
            self._screen.close()
            self._screen = None

    @property
    def time(self) -> float:
        """Time since the beginning of the episode [s]."""
        return self.simulation.time

    @property
    def decision(self) -> int:
        """Steps since the beginning of the episode."""
        return self.simulation.decision

    def _robot(self, agent: str) -> int:
        """Index of a robot."""
        try:
            return self._index[agent]
        except (KeyError, TypeError):
            return robot_index(agent, self._index)

    def _results(self) -> Results:
        over = self.decision >= self.max_cycles
        observations, infos = self._observations(), self._infos()
        rewards = dict(
            zip(self.agents, self.simulation.robots.rewards.tolist(), strict=True)
        )
        terminations = dict.fromkeys(self.agents, False)
        truncations = dict.fromkeys(self.agents, over)
        if over:
            self.agents = []
        return observations, rewards, terminations, truncations, infos

    def _infos(self) -> dict[str, dict[str, Any]]:
        told = self._notices
        self._notifier.write(told, self.simulation.robots, self.simulation.view)
        over, attended = told.behavior_over.tolist(), told.attended.tolist()
        caresses, taps = told.caresses.tolist(), told.taps.tolist()
        masks = told.action_mask.copy()  # The caller's to keep; numbers are anyway.
        return {
            agent: {
                "caresses": caresses[i],
                "taps": taps[i],
                "behavior_over": over[i],
                "attended": attended[i],
                "action_mask": masks[i],
            }
            for i, agent in enumerate(self.agents)
        }

    def _observations(self) -> dict[str, Observation]:
        rows = self._encoding.encode(self.simulation.view)
        return {agent: rows[i] for i, agent in enumerate(self.agents)}

    def state(self) -> Singles:
        """What all robots observe together, for centralized critics.

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        return self._features.encode(self.simulation.view).reshape(-1)

    def _check_begun(self) -> None:
        if not self.simulation.begun:
            raise HouseholdError("nobody is at home yet: call reset() first")

    def situation(self, agent: str) -> Situation:
        """The situation as a robot sees it now.

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        return self._seen()[self._robot(agent)]

    def _seen(self) -> tuple[Situation, ...]:
        """The situation as each robot sees it now; read anew in another revision."""
        if self.simulation.revision != self._revision:
            activity = self.simulation.people.appearance.activity
            attends = self.simulation.senses.relations.attends
            close = self.simulation.proximity.close
            self._read = self._situations.seen(activity, attends, close)
            self._revision = self.simulation.revision
        return self._read

    def feedback(self, agent: str) -> tuple[Feedback, ...]:
        """The touches that a robot felt in the last step, without their cause."""
        return self.simulation.robots.feedback[self._robot(agent)]

    def causes(self, agent: str) -> tuple[Cause, ...]:
        """What each touch of the last step was really about; for evaluation only."""
        return self.simulation.robots.causes[self._robot(agent)]

    def behavior(self, agent: str) -> Bout:
        """What a robot is doing, or did last."""
        return self.simulation.robots.bouts[self._robot(agent)]

    def behavior_over(self, agent: str) -> bool:
        """Whether what a robot was doing is done, so that it can choose anew."""
        return self.simulation.robots.is_over(self._robot(agent), self.time)

    def attended(self, agent: str) -> bool:
        """Whether any person attends to a robot.

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        n = len(self.simulation.people.everyone)
        attends = self.simulation.senses.relations.attends
        return True in attends[:n, n + self._robot(agent)].tolist()

    def approached(self, agent: str) -> bool:
        """Whether any person is seen walking towards a robot.

        What anybody could see who watched them walk; not what they have in mind.

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        n, robot = len(self.simulation.people.everyone), self._robot(agent)
        crowd = self.simulation.crowd
        if True not in crowd.walking[:n].tolist():  # Mostly nobody walks.
            return False
        way = crowd.position[n + robot] - crowd.position[:n]
        return bool((crowd.walking[:n] & faces(crowd.heading[:n], way)).any())

    def appropriateness(self, agent: str) -> Floats:
        """What the people present would think of each behavior now.

        The mean over all people of their preference times how strongly each would
        see or hear that behavior. For evaluation only: it reads private preferences.

        Returns:
            Shape (n_behaviors,), in [-1, 1].

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        return self.simulation.appropriateness(self._robot(agent))

    def opinion(self, agent: str) -> dict[str, int]:
        """Each person's questionnaire answer on a robot, 1 to 10 (paper, 4.1).

        Raises:
            HouseholdError: Before the first reset.
        """
        self._check_begun()
        return self.simulation.people.opinions(self._robot(agent))

    def describe(self, observation: Observation) -> str:
        """What an observation of any of the robots says, in words, line by line.

        Raises:
            HouseholdError: If it is no observation of one robot.
        """
        people = self.scenario.person_names
        if isinstance(observation, Mapping) and "activities" in observation:
            return situation_in_words(observation, people)
        shape = self._features.space.shape
        if np.shape(observation) != shape:
            raise HouseholdError(
                f"observation: {shown(observation)}; allowed: what one robot observed, "
                f"an array of shape {shape} or the parts of a situation"
            )
        return features_in_words(
            np.asarray(observation), self._features.layout, people, self.behaviors
        )

    def __str__(self) -> str:  # PettingZoo's is the name of all households.
        return repr(self)

    def __repr__(self) -> str:
        scenario = self.scenario
        moment = f"step {self.decision} of {self.max_cycles}"
        return (
            f"Household({scenario.name!r}: {len(scenario.people)} people, "
            f"{len(scenario.robots)} robots, {len(self.behaviors)} behaviors; "
            f"{moment if self.simulation.begun else 'not yet reset'})"
        )


def _repeated(space: spaces.Box, times: int) -> spaces.Box:
    """A flat box that holds several copies of another."""
    return spaces.Box(np.tile(space.low, times), np.tile(space.high, times))
