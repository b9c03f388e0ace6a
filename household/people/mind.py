"""The seam between simulated people and what decides for them.

The environment tells minds what their people perceive, and they answer with what each
intends for the next decision period. Minds live in ``policies``; the environment knows
only this contract. It speaks of everybody at once, in arrays, since that is fast;
`household.people.individuals` has the same for a mind of one person's own.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.feedback import Cause, Kind

OWN_ACTIVITY = NOBODY
"""To look at the object of the own activity, or at the way ahead in walking."""


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


class Judgements(NamedTuple):
    """What everybody thinks of the bouts that it first perceived in this period.

    Attributes:
        new: Whether each person now judged what each robot does, (n, n_robots).
        value: The appraisals, in [-1, 1], shape (n, n_robots).
        believed: Index of the robot that the person believes it was, (n, n_robots).
        attending: Whether the person attended to what did it, shape (n, n_robots).
    """

    new: Mask
    value: Floats
    believed: Indices
    attending: Mask


@dataclass(slots=True)
class Percepts:
    """What everybody perceives at the end of a decision period.

    For reading, and only until the minds have decided: later it holds other values.

    Attributes:
        time: Now [s].
        period: Time since the last percepts [s].
        activity: The role that each plays where it stands, shape (n,).
        arrived: Who is where it intended to be, or as near as others let it, (n,).
        touched: Whose wish to touch was fulfilled in this period, shape (n,).
        mood: In [-1, 1], shape (n,).
        judgements: What everybody thinks of what is new.
        pleasing: Whether each robot does something that pleases each, (n, n_robots).
        moving: Whether each robot is on the move, shape (n_robots,).
        sees: Who sees each entity (people first, then robots), (n, n + n_robots).
        level: How loud everybody hears each, shape (n, n + n_robots) [dB].
        cause: What a robot is doing now, as what a touch is about, for `Wish.cause`.
    """

    time: float
    period: float
    activity: NDArray[np.int_]
    arrived: Mask
    touched: Mask
    mood: Floats
    judgements: Judgements
    pleasing: Mask
    moving: Mask
    sees: Mask
    level: Floats
    cause: Callable[[int, float], Cause]


class Intentions(NamedTuple):
    """What everybody is about to do.

    Attributes:
        place: Index of the activity region to be in, shape (n,).
        look: Index of the entity to look at, or `OWN_ACTIVITY`, shape (n,).
        eyes_open: False in sleep, shape (n,).
        wishes: The touch that each is out to give, if any; it goes to the robot first.
    """

    place: Indices
    look: Indices
    eyes_open: Mask
    wishes: Sequence[Wish | None]


class Minds(Protocol):
    """Decides for everybody in a household.

    For checkpoints, minds are `household.state.Stateful`, or else they pickle.
    """

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode.

        Args:
            rngs: Each person's own stream; the minds may keep them.

        Returns:
            The first intentions; people begin in their places.
        """
        ...

    def decide(self, percepts: Percepts) -> Intentions:
        """Answers percepts with the intentions for the next period.

        Returns:
            Read before the next call, so that minds may change them in place then.
        """
        ...
