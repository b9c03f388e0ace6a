"""Snapshots: one frozen record of everything that can be seen of a household.

The replay recorder and the renderer see a household through this module alone. A
snapshot that was read back from a replay file equals the one that was taken, so
pictures can be drawn from either.
"""

from dataclasses import dataclass

from household.feedback import Cause, Feedback
from household.robots.robots import Robots
from household.simulation.moment import Moment, recorded
from household.simulation.simulation import Simulation


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


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Snapshot(Moment):
    """A moment; in every array people come first and robots after them."""

    decision: int
    """Steps since the episode began; 0 is the moment after the reset."""

    time: float
    """The same in seconds."""

    touches: tuple[Touch, ...]
    """The touches of the step that led here."""


def snapshot(simulation: Simulation) -> Snapshot:
    """Takes a snapshot; later steps do not change it."""
    return Snapshot(
        decision=simulation.decision,
        time=simulation.time,
        touches=touches(simulation.robots),
        **recorded(simulation.record, simulation.scenario),
    )


def touches(robots: Robots) -> tuple[Touch, ...]:
    """The touches of the last step."""
    return tuple(
        Touch(robot, feedback, cause)
        for robot, felt, causes in zip(
            robots.names, robots.feedback, robots.causes, strict=True
        )
        for feedback, cause in zip(felt, causes, strict=True)
    )
