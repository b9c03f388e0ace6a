"""Snapshots: one frozen record of everything that can be seen of a household.

The one place that reads the environment's insides for those who watch it: the replay
recorder and the renderer. A snapshot that was read back from a replay file is equal to
the one that was taken, so both draw from either.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.people.feedback import Cause, Feedback
from household.perception.situation import Situation
from household.robots.robots import Robots
from household.scenario import Scenario

if TYPE_CHECKING:
    from household.environment import Household

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Touch:
    """A touch, with what only the researcher may know.

    Attributes:
        robot: Name of the robot that was touched.
        feedback: The touch as the robot feels it.
        cause: What it is really about.
    """

    robot: str
    feedback: Feedback
    cause: Cause


class Snapshot(NamedTuple):
    """A moment; in every array people come first and robots after them.

    A tuple, as it is made at every step of a recording: a frozen dataclass takes four
    times as long.

    Attributes:
        decision: Steps since the episode began; 0 is the moment after the reset.
        time: The same in seconds.
        position: Shape (n, 2) [m].
        heading: Where bodies face, shape (n,) [rad].
        gaze: Where heads point, shape (n,) [rad].
        half_view: Half of each person's field of view, shape (n_people,) [rad];
            negative with the eyes closed.
        activity: Each person's role, as `Activity` values, shape (n_people,).
        attends: Who attends to whom, shape (n, n).
        attention: How much, shape (n, n).
        mood: Each person's private mood, shape (n_people,), in [-1, 1].
        behavior: What each robot does, -1 before its first choice, shape (n_robots,).
        begun: The step at which each robot began it, shape (n_robots,).
        reward: What each robot felt in the step that led here, shape (n_robots,).
        touches: The touches of that step.
    """

    decision: int
    time: float
    position: Array
    heading: Array
    gaze: Array
    half_view: Array
    activity: NDArray[np.int64]
    attends: NDArray[np.bool_]
    attention: Array
    mood: Array
    behavior: NDArray[np.int64]
    begun: NDArray[np.int64]
    reward: Array
    touches: tuple[Touch, ...]


def layout(scenario: Scenario) -> dict[str, tuple[tuple[int, ...], type]]:
    """Shape and type of each array of a snapshot, by name."""
    people, robots = len(scenario.people), len(scenario.robots)
    n = people + robots
    return {
        "position": ((n, 2), np.float64),
        "heading": ((n,), np.float64),
        "gaze": ((n,), np.float64),
        "half_view": ((people,), np.float64),
        "activity": ((people,), np.int64),
        "attends": ((n, n), np.bool_),
        "attention": ((n, n), np.float64),
        "mood": ((people,), np.float64),
        "behavior": ((robots,), np.int64),
        "begun": ((robots,), np.int64),
        "reward": ((robots,), np.float64),
    }


def snapshot(home: "Household") -> Snapshot:
    """Takes a snapshot; later steps do not change it.

    Only what the environment changes in place is copied; it makes the rest anew.
    """
    crowd, senses, robots = home.life.crowd, home.life.senses, home.life.robots
    people, touched = home.life.people, robots.touched
    return Snapshot(
        decision=home.decision,
        time=home.time,
        position=crowd.position,
        heading=crowd.heading.copy(),
        gaze=crowd.gaze.copy(),
        half_view=home.life.half_view[: len(people.everyone)].copy(),
        activity=people.activity.copy(),
        attends=senses.attends.copy(),
        attention=senses.attention.copy(),
        mood=people.feelings.mood.copy(),
        behavior=robots.behaviors.copy(),
        begun=robots.begun.copy(),
        reward=_rewards(robots) if touched else np.zeros(len(robots.names)),
        touches=_touches(home) if touched else (),
    )


def _rewards(robots: Robots) -> Array:
    return np.array([float(sum(t.value for t in f)) for f in robots.feedback])


def _touches(home: "Household") -> tuple[Touch, ...]:
    robots = home.life.robots
    return tuple(
        Touch(robot, feedback, cause)
        for robot, felt, causes in zip(
            robots.names, robots.feedback, robots.causes, strict=True
        )
        for feedback, cause in zip(felt, causes, strict=True)
    )


def situations(home: "Household") -> tuple[Situation, ...]:
    """The situation as each robot sees it now."""
    return tuple(home.situation(agent) for agent in home.possible_agents)
