"""Snapshots: one frozen record of everything that can be seen of a household.

The one place that reads the environment's insides for those who watch it: the replay
recorder and the renderer. A snapshot that was read back from a replay file is equal to
the one that was taken, so both draw from either.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers, Mask, Singles
from household.feedback import Cause, Feedback
from household.robots.robots import Robots
from household.scenario.scenario import Scenario

if TYPE_CHECKING:
    from household.simulation.simulation import Simulation

Present = tuple[
    Floats, Floats, Floats, Floats, Integers, Mask, Floats, Floats, Integers, Integers
]


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
        attention: How much, in single precision: it fills most of a recording, (n, n).
        mood: Each person's private mood, shape (n_people,), in [-1, 1].
        behavior: What each robot does, -1 before its first choice, shape (n_robots,).
        begun: The step at which each robot began it, shape (n_robots,).
        reward: What each robot felt in the step that led here, shape (n_robots,).
        touches: The touches of that step.
    """

    decision: int
    time: float
    position: Floats
    heading: Floats
    gaze: Floats
    half_view: Floats
    activity: Integers
    attends: Mask
    attention: Singles
    mood: Floats
    behavior: Integers
    begun: Integers
    reward: Floats
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
        "attention": ((n, n), np.float32),
        "mood": ((people,), np.float64),
        "behavior": ((robots,), np.int64),
        "begun": ((robots,), np.int64),
        "reward": ((robots,), np.float64),
    }


def snapshot(simulation: "Simulation") -> Snapshot:
    """Takes a snapshot; later steps do not change it."""
    robots = simulation.robots
    reward = rewards(robots) if robots.touched else np.zeros(len(robots.names))
    arrays: dict[str, NDArray[Any]] = {
        name: array[: shape[0]].astype(kind)
        for (name, (shape, kind)), array in zip(
            layout(simulation.scenario).items(),
            (*present(simulation), reward),
            strict=True,
        )
    }
    return Snapshot(
        decision=simulation.decision,
        time=simulation.time,
        touches=touches(robots),
        **arrays,
    )


def present(simulation: "Simulation") -> Present:
    """The arrays of this moment, without rewards, in the order of a snapshot.

    Not copied: they are always the same arrays, with new values after every step.
    ``half_view`` is there for robots, too.
    """
    crowd, senses, people, robots = (
        simulation.crowd,
        simulation.senses,
        simulation.people,
        simulation.robots,
    )
    return (
        crowd.position,
        crowd.heading,
        crowd.gaze,
        simulation.half_view,
        people.activity,
        senses.attends,
        senses.attention,
        people.feelings.mood,
        robots.behaviors,
        robots.begun,
    )


def rewards(robots: Robots) -> Floats:
    """What each robot felt in the last step, shape (n_robots,)."""
    return np.array([float(sum(t.value for t in f)) for f in robots.feedback])


def touches(robots: Robots) -> tuple[Touch, ...]:
    """The touches of the last step."""
    return tuple(
        Touch(robot, feedback, cause)
        for robot, felt, causes in zip(
            robots.names, robots.feedback, robots.causes, strict=True
        )
        for feedback, cause in zip(felt, causes, strict=True)
    )
