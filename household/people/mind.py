"""The seam between a simulated person and what decides for it.

The environment tells a mind what its person perceives, and the mind answers with an
intention for the next decision period. Minds live in ``policies``; the environment
knows only this contract.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.people.appraisal import Judgement
from household.people.feedback import Cause, Kind

OWN_ACTIVITY = -1
"""`Intention.look`: the object of the own activity, or the way ahead in walking."""


@dataclass(frozen=True, slots=True)
class Wish:
    """The wish to touch a robot.

    Attributes:
        robot: Index of the robot.
        kind: How to touch it.
        strength: In (0, 1].
        cause: What it is about; travels along unread, for evaluation.
    """

    robot: int
    kind: Kind
    strength: float
    cause: Cause


@dataclass(slots=True)
class Percept:
    """What a person perceives at the end of a decision period.

    Attributes:
        time: Now [s].
        period: Time since the last percept [s].
        activity: The role that it plays where it stands.
        arrived: Whether it is where it intended to be, or as near as others let it.
        touched: Whether its wish to touch was fulfilled in this period.
        mood: Its mood, in [-1, 1].
        judgements: What it thinks of the bouts that it first perceived now.
        pleasing: Whether each robot is doing something that pleases it, (n_robots,).
        moving: Whether each robot is on the move, shape (n_robots,).
        sees: Whether it sees each entity (people first, then robots), shape (n,).
        level: How loud it hears each entity, shape (n,) [dB].
    """

    time: float
    period: float
    activity: Activity
    arrived: bool
    touched: bool
    mood: float
    judgements: Sequence[Judgement]
    pleasing: NDArray[np.bool_]
    moving: NDArray[np.bool_]
    sees: NDArray[np.bool_]
    level: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Intention:
    """What a person is about to do.

    Attributes:
        place: Index of the activity region to be in.
        look: Index of the entity to look at, or `OWN_ACTIVITY`.
        eyes_open: False in sleep.
        wish: The touch that it is out to give, if any; it goes to the robot first.
    """

    place: int
    look: int = OWN_ACTIVITY
    eyes_open: bool = True
    wish: Wish | None = None


class Mind(Protocol):
    """Decides for one person."""

    def reset(self, rng: np.random.Generator) -> Intention:
        """Begins a new episode.

        Args:
            rng: The person's own stream; the mind may keep it.

        Returns:
            The first intention; the person begins in its place.
        """
        ...

    def decide(self, percept: Percept) -> Intention:
        """Answers a percept with the intention for the next period."""
        ...
