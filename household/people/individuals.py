"""Minds of one person each, for those who would rather write one in plain Python."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from household.activity import Activity
from household.compiled.arrays import Floats, Mask
from household.feedback import Cause
from household.people.mind import OWN_ACTIVITY, Intentions, Minds, Percepts, Wish

ACTIVITIES = tuple(Activity)


@dataclass(frozen=True, slots=True)
class Judgement:
    """What a person thinks of one bout.

    Attributes:
        robot: Index of the robot that the person believes it was.
        value: The appraisal, in [-1, 1].
        attending: Whether the person attended to what did it.
        cause: The bout itself; travels along unread, for evaluation.
    """

    robot: int
    value: float
    attending: bool
    cause: Cause


@dataclass(frozen=True, slots=True)
class Percept:
    """What one person perceives at the end of a decision period.

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
    pleasing: Mask
    moving: Mask
    sees: Mask
    level: Floats


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
    """Decides for one person.

    A checkpoint takes minds along as they pickle, and puts others in their place that
    were unpickled. What a mind should not take along, such as a large network, it
    leaves out in ``__getstate__`` and finds again in ``__setstate__``.
    """

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


class Individuals(Minds):
    """People who each have a mind of their own.

    Args:
        minds: One for each person, in order.
    """

    def __init__(self, minds: Sequence[Mind]) -> None:
        self._minds = minds

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode for each."""
        return _together(
            [mind.reset(rng) for mind, rng in zip(self._minds, rngs, strict=True)]
        )

    def decide(self, percepts: Percepts) -> Intentions:
        """Asks one after the other."""
        return _together(
            [mind.decide(_seen_by(i, percepts)) for i, mind in enumerate(self._minds)]
        )


def _together(intentions: Sequence[Intention]) -> Intentions:
    return Intentions(
        place=np.array([each.place for each in intentions], dtype=np.intp),
        look=np.array([each.look for each in intentions], dtype=np.intp),
        eyes_open=np.array([each.eyes_open for each in intentions]),
        wishes=[each.wish for each in intentions],
    )


def _seen_by(i: int, percepts: Percepts) -> Percept:
    """One person's share of what everybody perceives; arrays of its own to keep."""
    return Percept(
        time=percepts.time,
        period=percepts.period,
        activity=ACTIVITIES[percepts.activity[i]],
        arrived=bool(percepts.arrived[i]),
        touched=bool(percepts.touched[i]),
        mood=float(percepts.mood[i]),
        judgements=_judged_by(i, percepts),
        pleasing=percepts.pleasing[i].copy(),
        moving=percepts.moving.copy(),
        sees=percepts.sees[i].copy(),
        level=percepts.level[i].copy(),
    )


def _judged_by(i: int, percepts: Percepts) -> tuple[Judgement, ...]:
    new, value, believed, attending = percepts.judgements
    return tuple(
        Judgement(
            robot=int(believed[i, robot]),
            value=float(value[i, robot]),
            attending=bool(attending[i, robot]),
            cause=percepts.cause(robot, percepts.time),
        )
        for robot in np.flatnonzero(new[i]).tolist()
    )
