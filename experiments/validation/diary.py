"""A diary of an episode: where everybody was, what was judged, and what was touched.

It is kept from outside, from what happens: judgements, walks and touches. How people
come to react is not its business.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from experiments.analysis.statistics import FloatArray
from household.environment import Household
from household.feedback import Kind
from household.scenario.scenario import Scenario
from policies.people import make_minds

MOVED = 0.01
"""Who came farther than this in a period was seen to walk [m]."""


@dataclass(frozen=True, slots=True)
class Judgement:
    """A person thinks something of a bout.

    Attributes:
        person: Index of the person.
        robot: Index of the robot.
        bout: Decision at which the bout began.
        time: Of the judgement [s].
        value: In [-1, 1].
    """

    person: int
    robot: int
    bout: int
    time: float
    value: float


@dataclass(frozen=True, slots=True)
class Given:
    """A touch and the judgement that it answers.

    Attributes:
        person: Index of the giver.
        robot: Index of the robot.
        bout: Decision at which the bout began that it is about.
        judged: When the giver judged it [s].
        time: Of the touch [s].
        kind: A caress or a tap.
        strength: In (0, 1].
    """

    person: int
    robot: int
    bout: int
    judged: float
    time: float
    kind: Kind
    strength: float


@dataclass(frozen=True, eq=False, kw_only=True)
class Diary:
    """An episode, moment by moment; people come first and robots after them.

    Attributes:
        time: Of each moment, shape (t,) [s].
        position: Shape (t, n, 2) [m].
        heading: Where bodies face, shape (t, n) [rad].
        gaze: Where heads point, shape (t, n) [rad].
        eyes_open: Shape (t, n_people).
        attention: Of each for each, shape (t, n, n).
        judgements: Of bouts that call for feedback.
        touches: In the order in which they were felt.
    """

    time: FloatArray
    position: FloatArray
    heading: FloatArray
    gaze: FloatArray
    eyes_open: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
    attention: FloatArray
    judgements: tuple[Judgement, ...]
    touches: tuple[Given, ...]

    @property
    def period(self) -> float:
        """From one moment to the next [s]."""
        return float(self.time[1] - self.time[0])

    @property
    def people(self) -> int:
        """How many people there are."""
        return self.eyes_open.shape[1]

    def moved(self, i: int) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Whether a body walked between each moment and the next, shape (t - 1,)."""
        way = np.linalg.norm(np.diff(self.position[:, i], axis=0), axis=1)
        return np.asarray(way > MOVED)


def live(scenario: Scenario, chances: Sequence[float], seed: int) -> Diary:
    """Lives through an episode with robots that act by chance.

    Args:
        scenario: Who lives where.
        chances: Of each behavior, whenever a robot chooses; they add up to 1.
        seed: Of the episode and of the robots.
    """
    env = Household(scenario, make_minds)
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    record = env.simulation.record
    moments, judgements, touches = [record.copy()], list[Judgement](), list[Given]()
    while env.agents:
        actions = {
            agent: int(rng.choice(len(chances), p=chances))
            for agent in env.agents
            if env.behavior_over(agent)
        }
        agents = env.agents
        env.step(actions)
        moments.append(record.copy())
        judgements += _judged(env)
        touches += (one for agent in agents for one in _given(env, agent))
    told, n = np.array(moments), len(scenario.people)
    return Diary(
        time=told["decision"] * scenario.decision_period,
        position=told["position"],
        heading=told["heading"],
        gaze=told["gaze"],
        eyes_open=told["half_view"][:, :n] >= 0.0,
        attention=told["attention"],
        judgements=tuple(judgements),
        touches=tuple(touches),
    )


def _judged(env: Household) -> list[Judgement]:
    """What people have just thought of bouts that call for feedback."""
    found, robots = env.simulation.people.appraisals, env.simulation.robots
    personas = env.scenario.personas
    return [
        Judgement(
            person=int(i),
            robot=int(r),
            bout=robots.cause(int(r), env.time).decision,
            time=env.time,
            value=float(found.value[i, r]),
        )
        for i, r in np.argwhere(found.new)
        if abs(found.value[i, r]) >= personas[i].tolerance
        if found.attending[i, r] or not personas[i].only_when_attending
    ]


def _given(env: Household, agent: str) -> list[Given]:
    """The touches that a robot has just felt."""
    people, robots = env.scenario.person_names, env.scenario.robot_names
    return [
        Given(
            person=people.index(touch.giver),
            robot=robots.index(agent),
            bout=cause.decision,
            judged=cause.time,
            time=touch.time,
            kind=touch.kind,
            strength=touch.strength,
        )
        for touch, cause in zip(env.feedback(agent), env.causes(agent), strict=True)
    ]
