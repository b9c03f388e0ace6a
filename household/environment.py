"""The household as a PettingZoo environment; what a step does is told in `step`."""

import math
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from gymnasium import spaces
from gymnasium.utils import EzPickle
from numpy.typing import NDArray
from pettingzoo import ParallelEnv

from household.activity import ACTIVITY_NAMES
from household.crowd import Crowd
from household.errors import HouseholdError, choose_from
from household.observation import ENCODINGS, Features, View
from household.people.appraisal import heard_strength, seen_strength
from household.people.feedback import Cause, Feedback
from household.people.mind import Wish
from household.people.people import MakeMinds, People
from household.perception.senses import Senses
from household.perception.situation import Situation
from household.robots.behavior import Bout
from household.robots.motion import MOTIONS, Mover
from household.robots.robots import Robots
from household.scenario import MOST_PEOPLE, Scenario
from household.scenario_check import load_scenario
from household.snapshot import snapshot
from household.streams import Streams

if TYPE_CHECKING:
    from household.render import Screen

Array = NDArray[np.float64]
Observation = Any

PERSON_RADIUS, ROBOT_RADIUS = 0.25, 0.15
"""Of the bodies [m]; the robot's is that of a small dog, as the AIBO is."""

PERSON_MASS, ROBOT_MASS = 70.0, 2.0
"""Of the bodies [kg]; an AIBO weighs about 2 kg."""

ROBOT_SPEED = 0.5
"""At which robots walk [m/s]."""

SITUATIONS_KEPT = 4096
"""So many situations are remembered, whoever they were seen from."""

ROBOT_VIEW = math.radians(120.0) / 2
"""Half a robot's field of view [rad]."""


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
        EzPickle.__init__(
            self, scenario, make_minds, observation, render_mode, **overrides
        )
        _check_name(observation, ENCODINGS, "observation")
        if render_mode is not None:
            _check_name(render_mode, self.metadata["render_modes"], "render mode")
        self.scenario = load_scenario(scenario, **overrides)
        self.render_mode = render_mode
        self._screen: Screen | None = None
        self.max_cycles = self.scenario.max_cycles
        self.behaviors = self.scenario.behaviors
        self.possible_agents = list(self.scenario.robot_names)
        self.agents: list[str] = []
        self._index = {agent: i for i, agent in enumerate(self.possible_agents)}
        self._make_parts(make_minds)
        self._features = Features(self.scenario)
        self._encoding = ENCODINGS[observation](self.scenario)
        actions = spaces.Discrete(len(self.behaviors))
        self.observation_spaces: dict[str, spaces.Space[Any]] = dict.fromkeys(
            self.possible_agents, self._encoding.space
        )
        self.action_spaces = dict.fromkeys(self.possible_agents, actions)
        self.state_space = _repeated(self._features.space, len(self.possible_agents))

    def _make_parts(self, make_minds: MakeMinds) -> None:
        """Makes the people, the robots, their bodies and their senses."""
        scenario, n_robots = self.scenario, len(self.possible_agents)
        self.people = People(scenario, make_minds)
        self.robots = Robots(scenario)
        personas = [person.persona for person in self.people.everyone]
        n_people = len(personas)
        self.crowd = Crowd(
            scenario.plan,
            radius=np.array([PERSON_RADIUS] * n_people + [ROBOT_RADIUS] * n_robots),
            mass=np.array([PERSON_MASS] * n_people + [ROBOT_MASS] * n_robots),
            speed=np.array(
                [p.walking_speed for p in personas] + [ROBOT_SPEED] * n_robots
            ),
            steering_period=scenario.steering_period,
            physics_period=scenario.physics_period,
        )
        self.senses = Senses(scenario.plan, scenario.perception, n_people + n_robots)
        self._streams = Streams(n_people, n_robots)
        self._head_turn = np.radians(
            [p.head_speed for p in personas] + [360.0] * n_robots
        )
        self._absorption = np.array([p.absorption for p in personas] + [1.0] * n_robots)
        self._half_view = np.full(n_people + n_robots, ROBOT_VIEW)
        self._salience = np.ones(n_people + n_robots)
        self._source = np.zeros(n_people + n_robots)
        self._noise = np.zeros((n_robots, MOST_PEOPLE))
        self._motions = [MOTIONS[b.motion] for b in scenario.repertoire]
        # Situations recur; each is put together once.
        self._names = (*scenario.person_names, *self.possible_agents)
        self._plays = lru_cache(maxsize=SITUATIONS_KEPT)(self._make_plays)
        self._situation = lru_cache(maxsize=SITUATIONS_KEPT)(self._make_situation)
        self._moments = round(scenario.decision_period / scenario.steering_period)

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """The space of an agent's observations, the same object at each call."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Discrete:
        """The space of an agent's actions, the same object at each call."""
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Observation], dict[str, dict[str, Any]]]:
        """Begins an episode.

        Args:
            seed: The same seed gives the same history; None goes on with the history
                that the last seed began.
            options: Not used.

        Returns:
            Observations and empty infos of all agents.
        """
        self.agents = list(self.possible_agents)
        self.decision = 0
        self._streams.begin(seed)
        self.robots.begin()
        self.senses.forget()
        people = self.people.begin(self._streams.people)
        robots = np.array([spec.position for spec in self.scenario.robots])
        headings = np.radians([spec.heading for spec in self.scenario.robots])
        self.crowd.place(
            np.vstack([people, robots]),
            np.concatenate([np.zeros(len(people)), headings]),
        )
        self._look_around(np.full(len(self._head_turn), 2 * np.pi))
        self._perceive()
        self._show()
        return self._observations(), {agent: {} for agent in self.agents}

    def step(
        self, actions: Mapping[str, int]
    ) -> tuple[
        dict[str, Observation],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Lets one decision period pass.

        Robots choose behaviors; people walk, look around and touch; everybody
        perceives; people judge what is new to them and decide what to do next.

        Args:
            actions: The behavior of each robot, by agent; agents that have left are
                ignored, a robot without an action goes on with what it does.

        Returns:
            Observations, rewards, terminations, truncations and infos by agent; all
            empty once the episode is over.
        """
        if not self.agents:
            return {}, {}, {}, {}, {}
        self._choose(actions)
        self._move_robots()
        self._live()
        self.decision += 1
        self._look_around(self._head_turn * self.scenario.decision_period)
        self._perceive()
        judgements = self.people.judge(self.senses, self.robots, self.time)
        clock = (self.time, self.scenario.decision_period)
        self.people.decide(self.crowd, self.senses, judgements, clock)
        self._show()
        return self._results()

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
            from household.render import Screen

            fps = self.metadata["render_fps"]
            self._screen = Screen(self.scenario, self.render_mode, fps)
        return self._screen.show(snapshot(self))

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
        return self.decision * self.scenario.decision_period

    def _choose(self, actions: Mapping[str, int]) -> None:
        for agent, action in actions.items():
            if agent in self._index:
                behavior = int(action)
                if not 0 <= behavior < len(self.behaviors):
                    raise HouseholdError(
                        f"{agent}: action {action!r} is none of the behaviors; "
                        f"allowed: 0 to {len(self.behaviors) - 1}"
                    )
                self.robots.choose(
                    self._index[agent], behavior, self.decision, self.time
                )

    def _move_robots(self) -> None:
        """Robots move as their behaviors have it; who is done stands still."""
        n_people = len(self.people.everyone)
        for robot, bout in enumerate(self.robots.bouts):
            if self.robots.is_over(robot, self.time):
                self.crowd.halt(n_people + robot)
                continue
            mover = Mover(
                body=n_people + robot,
                n_people=n_people,
                begins=bout.decision == self.decision,
                spots=self.people.places.centers,
                rng=self._streams.robots[robot],
                now=self.time,
                period=self.scenario.decision_period,
            )
            self._motions[bout.behavior](mover, self.crowd)

    def _live(self) -> None:
        """People walk where they intended to and touch robots that they reach."""
        self.robots.forget_touches()
        for moment in range(1, self._moments + 1):
            self.crowd.advance()
            now = self.time + moment * self.scenario.steering_period
            for i, wish in self.people.wishes():
                if self.people.reaches(i, wish, self.crowd, self.senses):
                    self._touch(i, wish, now)

    def _touch(self, i: int, wish: Wish, now: float) -> None:
        """A person touches a robot, which feels it and sees who it was."""
        person, j = self.people.everyone[i], len(self.people.everyone) + wish.robot
        feedback = Feedback(
            giver=person.name,
            kind=wish.kind,
            strength=wish.strength,
            time=now,
            mood=float(self._moods[wish.robot, i]),
            attending=bool(self.senses.attends[i, j]),
            approach_began=_known(self.crowd.walk_began[i]),
            attention_began=_known(self.senses.attention_began[i, j]),
        )
        self.robots.feel(wish.robot, feedback, wish.cause)
        person.touched = True
        self.crowd.halt(i)

    def _look_around(self, most: Array) -> None:
        """Everybody turns its head towards what it wants to look at."""
        robots = self.crowd.heading[len(self.people.everyone) :]
        target = np.concatenate([self.people.gaze_targets(self.crowd), robots])
        self.crowd.turn_heads(target, most)

    def _perceive(self) -> None:
        """Everybody sees, hears and attends; robots read moods off faces."""
        since = self.time - self.scenario.decision_period
        people, robots = self.people, self.robots
        n_people = len(people.everyone)
        people.locate(self.crowd.position[:n_people])
        self._half_view[:n_people] = [p.half_view for p in people.everyone]
        self._salience[n_people:] = robots.salience(since)
        self._source[n_people:] = robots.sources(since)
        self.senses.perceive(
            position=self.crowd.position,
            gaze=self.crowd.gaze,
            half_view=self._half_view,
            salience=self._salience,
            absorption=self._absorption,
            source=self._source,
            now=self.time,
        )
        moods = np.array([person.mood for person in people.everyone])
        # Drawn for as many as could be here, so that one more shifts nobody's draws.
        for rng, drawn in zip(self._streams.robots, self._noise, strict=True):
            rng.standard_normal(out=drawn)
        misread = self.scenario.perception.mood_noise * self._noise[:, :n_people]
        self._moods = np.minimum(np.maximum(moods + misread, -1.0), 1.0)

    def _results(self) -> Any:  # noqa: ANN401 - the tuple that `step` documents
        over = self.decision >= self.max_cycles
        observations = self._observations()
        rewards, infos = {}, {}
        for agent in self.agents:
            touches = self.feedback(agent)
            rewards[agent] = float(sum(touch.value for touch in touches))
            infos[agent] = {
                "situation": self.situation(agent),
                "feedback": touches,
                "caresses": sum(touch.kind == "caress" for touch in touches),
                "taps": sum(touch.kind == "tap" for touch in touches),
            }
        terminations = dict.fromkeys(self.agents, False)
        truncations = dict.fromkeys(self.agents, over)
        if over:
            self.agents = []
        return observations, rewards, terminations, truncations, infos

    def _observations(self) -> dict[str, Observation]:
        rows = self._encoding.encode(self._view())
        return {agent: rows[self._index[agent]] for agent in self.agents}

    def _view(self) -> View:
        """What robots may know of this moment."""
        n = len(self.people.everyone)
        position, senses = self.crowd.position, self.senses
        return View(
            offset=position[None, :, :] - position[n:, None, :],
            activity=self.people.activity,
            walking=self.crowd.walking[:n],
            attends=senses.attends[:n, n:],
            attention=senses.attention[:n, n:],
            facing=np.cos(senses.angle[:n, n:]),
            mood=self._moods,
            behavior=self.robots.behaviors,
            left=self.robots.left(self.time),
            touches=self.robots.felt,
        )

    def state(self) -> NDArray[np.float32]:
        """What all robots observe together, for centralized critics."""
        return self._features.encode(self._view()).reshape(-1)

    def situation(self, agent: str) -> Situation:
        """The situation as a robot sees it now."""
        n, attends = len(self.people.everyone), self.senses.attends
        target = n + self._index[agent]
        who = {"none": attends[:0], "robot": attends[:n, target], "all": attends}
        chosen = who[self.scenario.situation.attention]
        return self._situation(self.people.activity.tobytes(), chosen.tobytes(), target)

    def _make_situation(
        self, activity: bytes, attends: bytes, target: int
    ) -> Situation:
        """The situation that these roles and this attention make."""
        names = self._names
        relations = np.flatnonzero(np.frombuffer(attends, np.bool_)).tolist()
        if self.scenario.situation.attention == "all":
            pairs = [divmod(pair, len(names)) for pair in relations]
        else:
            pairs = [(observer, target) for observer in relations]
        attended = frozenset((names[i], names[j]) for i, j in pairs)
        return Situation(self._plays(activity), attended)

    def _make_plays(self, activity: bytes) -> tuple[tuple[str, str], ...]:
        """Who plays which role, as situations have it."""
        roles = [ACTIVITY_NAMES[role] for role in np.frombuffer(activity, np.int_)]
        return Situation.of(dict(zip(self._names, roles, strict=False))).plays

    def feedback(self, agent: str) -> tuple[Feedback, ...]:
        """The touches that a robot felt in the last step, without their cause."""
        return self.robots.feedback[self._index[agent]]

    def causes(self, agent: str) -> tuple[Cause, ...]:
        """What each touch of the last step was really about; for evaluation only."""
        return self.robots.causes[self._index[agent]]

    def behavior(self, agent: str) -> Bout:
        """What a robot is doing, or did last."""
        return self.robots.bouts[self._index[agent]]

    def behavior_over(self, agent: str) -> bool:
        """Whether what a robot was doing is done, so that it can choose anew."""
        return self.robots.is_over(self._index[agent], self.time)

    def attended(self, agent: str) -> bool:
        """Whether any person attends to a robot."""
        n = len(self.people.everyone)
        return bool(self.senses.attends[:n, n + self._index[agent]].any())

    def appropriateness(self, agent: str) -> Array:
        """What the people present would think of each behavior now.

        The mean over all people of their preference times how strongly each would
        see or hear that behavior. For evaluation only: it reads private preferences.

        Returns:
            Shape (n_behaviors,), in [-1, 1].
        """
        n, robot = len(self.people.everyone), self._index[agent]
        senses, target = self.senses, n + self._index[agent]
        loudness = np.array([b.loudness for b in self.scenario.repertoire])
        heard = heard_strength(loudness - senses.loss[:n, target, None])
        seen = seen_strength(senses.attention[:n, target, None])
        liked = self.people.preferred(senses.attends[:n, n:])[:, robot]
        return (liked * np.maximum(seen, heard)).mean(axis=0)

    def opinion(self, agent: str) -> dict[str, int]:
        """Each person's questionnaire answer on a robot, 1 to 10 (paper, 4.1)."""
        robot = self._index[agent]
        return {p.name: p.opinion(robot) for p in self.people.everyone}


def _known(moment: float) -> float | None:
    return None if math.isnan(moment) else float(moment)


def _repeated(space: spaces.Box, times: int) -> spaces.Box:
    """A flat box that holds several copies of another."""
    return spaces.Box(np.tile(space.low, times), np.tile(space.high, times))


def _check_name(name: str, allowed: Any, what: str) -> None:  # noqa: ANN401
    if name not in allowed:
        raise HouseholdError(choose_from(name, allowed, what))
