"""The seam between simulated people and what decides for them.

The environment gives minds what their people perceive, and they answer with what each
intends for the next decision period. Minds live in ``policies``; the environment knows
only this contract. It speaks of everybody at once, in arrays, since that is fast;
`household.people.individuals` has the same for a mind of one person's own.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple, Protocol

import numpy as np

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


class Appraisals(NamedTuple):
    """What everybody privately thinks of what the robots do.

    Attributes:
        new: Whether each person made up its mind about each robot's bout in this
            period, shape (n_people, n_robots); it does that once for each bout.
        value: The appraisals, in [-1, 1], shape (n_people, n_robots).
        believed: Index of the robot that the person believes it was, shape (n_people,
            n_robots).
        attending: Whether the person attended to what did it, shape (n_people,
            n_robots).
        pleasing: Whether each robot does something that pleases each person, new or
            not, shape (n_people, n_robots).
    """

    new: Annotated[Mask, "n_people", "n_robots"]
    value: Annotated[Floats, "n_people", "n_robots"]
    believed: Annotated[Indices, "n_people", "n_robots"]
    attending: Annotated[Mask, "n_people", "n_robots"]
    pleasing: Annotated[Mask, "n_people", "n_robots"]


class Condition(NamedTuple):
    """How everybody is doing.

    Attributes:
        activity: The role that each plays where it stands, shape (n_people,).
        arrived: Who is where it intended to be, or as near as others let it, shape
            (n_people,).
        touched: Whose wish to touch was fulfilled in this period, shape (n_people,).
        mood: In [-1, 1], shape (n_people,).
    """

    activity: Annotated[Indices, "n_people"]
    arrived: Annotated[Mask, "n_people"]
    touched: Annotated[Mask, "n_people"]
    mood: Annotated[Floats, "n_people"]


class Surroundings(NamedTuple):
    """What goes on around everybody.

    Attributes:
        sees: Who sees each entity, people first and robots after them, shape (n_people,
            n_entities).
        level: How loud everybody hears each entity, (n_people, n_entities) [dB].
        moving: Whether each robot is on the move, shape (n_robots,).
    """

    sees: Annotated[Mask, "n_people", "n_entities"]
    level: Annotated[Floats, "n_people", "n_entities"]
    moving: Annotated[Mask, "n_robots"]


@dataclass(slots=True)
class Percepts:
    """What everybody perceives at the end of a decision period.

    For reading, and only until the minds have decided: later it holds other values.

    Attributes:
        time: Now [s].
        period: Time since the last percepts [s].
        condition: How everybody is doing.
        surroundings: What goes on around everybody.
        appraisals: What everybody thinks of what the robots do.
        cause: The bout of a robot, by its index, at a time [s], for `Wish.cause`.
    """

    time: float
    period: float
    condition: Condition
    surroundings: Surroundings
    appraisals: Appraisals
    cause: Callable[[int, float], Cause]


class Intentions(NamedTuple):
    """What everybody is about to do.

    Attributes:
        place: Index of the activity region to be in, shape (n,).
        look: Index of the entity to look at, or `OWN_ACTIVITY`, shape (n,).
        eyes_open: False in sleep, shape (n,).
        wishes: The touch that each is out to give, if any; it goes to the robot first.
        changed: Whose wish is another than in the intentions before, or for the first
            intentions, who has one, shape (n,); only these wishes are looked at.
    """

    place: Indices
    look: Indices
    eyes_open: Mask
    wishes: Sequence[Wish | None]
    changed: Mask


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
