"""Minds of one person each, for those who would rather write one in plain Python."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from household.activity import Activity
from household.arguments import check_name
from household.compiled.arrays import Floats, Mask
from household.feedback import Cause, Kind
from household.home.places import Places
from household.people.mind import OWN_ACTIVITY, Intentions, Minds, Percepts, Wish
from household.scenario.scenario import Scenario

ACTIVITIES = tuple(Activity)


@dataclass(frozen=True, slots=True)
class Appraisal:
    """What a person thinks of one bout.

    Attributes:
        robot: Index of the robot that the person believes it was.
        value: How much it likes the bout, in [-1, 1].
        attending: Whether the person attended to what did it.
        cause: The bout itself; for `Wish.cause`.
    """

    robot: int
    value: float
    attending: bool
    cause: Cause

    def wish(self, kind: Kind, strength: float) -> Wish:
        """The wish to answer that bout with a touch.

        Args:
            kind: How to touch the robot.
            strength: In (0, 1].
        """
        return Wish(self.robot, kind, strength, self.cause)


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
        appraisals: What it thinks of the bouts about which it made up its mind now.
        pleasing: Whether each robot is doing something that pleases it, (n_robots,).
        moving: Whether each robot is on the move, shape (n_robots,).
        sees: Whether it sees each entity (people first, then robots), shape (n,).
        level: How loud it hears each entity, shape (n,) [dB].
        names: Of the entities; none if `Individuals` were not told the scenario.
    """

    time: float
    period: float
    activity: Activity
    arrived: bool
    touched: bool
    mood: float
    appraisals: Sequence[Appraisal]
    pleasing: Mask
    moving: Mask
    sees: Mask
    level: Floats
    names: tuple[str, ...] = ()

    def sees_who(self, name: str) -> bool:
        """Whether it sees a person or a robot, by name.

        Raises:
            HouseholdError: If there is nobody of that name.
        """
        return bool(self.sees[self._index(name)])

    def hears_how_loud(self, name: str) -> float:
        """How loud it hears a person or a robot, by name [dB].

        Raises:
            HouseholdError: If there is nobody of that name.
        """
        return float(self.level[self._index(name)])

    def _index(self, name: str) -> int:
        check_name(name, self.names, "person or robot")
        return self.names.index(name)


@dataclass(frozen=True, slots=True)
class Intention:
    """What a person is about to do.

    Attributes:
        place: Name of the activity region to be in, or an activity, of which the person
            takes its own region; or the region's index.
        look: Name of the person or robot to look at, or its index, or `OWN_ACTIVITY`.
        eyes_open: False in sleep.
        wish: The touch that it is out to give, if any; it goes to the robot first.
    """

    place: str | int
    look: str | int = OWN_ACTIVITY
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

    A wish lasts for as long as the mind answers with an equal one, at most until it is
    fulfilled; an equal one after that is another wish.

    Args:
        minds: One for each person, in order; or for some, by the person's index.
        scenario: Who lives where; without it, minds speak of places and of each other
            by index only.
    """

    def __init__(
        self,
        minds: Sequence[Mind] | Mapping[int, Mind],
        scenario: Scenario | None = None,
    ) -> None:
        by_person = minds if isinstance(minds, Mapping) else dict(enumerate(minds))
        self.who = tuple(by_person)
        self._minds = tuple(by_person.values())
        self._places = [_places(person, scenario) for person in self.who]
        self._names = () if scenario is None else _names(scenario)
        self._wishes: list[Wish | None] = []

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode for each."""
        n = len(self._minds)
        self._wishes = [None] * n
        each = [mind.reset(rng) for mind, rng in zip(self._minds, rngs, strict=True)]
        return self._together(each, np.zeros(n, np.bool_))

    def decide(self, percepts: Percepts) -> Intentions:
        """Asks one after the other."""
        each = [
            mind.decide(_percept(person, percepts, self._names))
            for person, mind in zip(self.who, self._minds, strict=True)
        ]
        return self._together(each, percepts.condition.touched[list(self.who)])

    def _together(self, each: Sequence[Intention], touched: Mask) -> Intentions:
        """Puts everybody's intentions together, and finds whose wish is another."""
        before, self._wishes = self._wishes, [one.wish for one in each]
        differs = [new != old for new, old in zip(self._wishes, before, strict=True)]
        places = [
            _index(one.place, known, "place")
            for one, known in zip(each, self._places, strict=True)
        ]
        known = {name: index for index, name in enumerate(self._names)}
        looks = [_index(one.look, known, "person or robot") for one in each]
        return Intentions(
            place=np.array(places, dtype=np.intp),
            look=np.array(looks, dtype=np.intp),
            eyes_open=np.array([one.eyes_open for one in each]),
            wishes=self._wishes,
            changed=touched | np.array(differs),
        )


def _index(named: str | int, known: Mapping[str, int], what: str) -> int:
    """What a mind speaks of, by index."""
    if not isinstance(named, str):
        return named
    check_name(named, known, what)
    return known[named]


def _names(scenario: Scenario) -> tuple[str, ...]:
    """Everybody's names, people first, as minds know them."""
    return (*scenario.person_names, *scenario.robot_names)


def _places(person: int, scenario: Scenario | None) -> dict[str, int]:
    """The regions by their names, and by the activities that a person has there."""
    if scenario is None:
        return {}
    places = Places(scenario.plan)
    names = [name for each in places.regions for name in (each.activity, each.name)]
    return {name: places.own(name, person) for name in names}


def _percept(i: int, percepts: Percepts, names: tuple[str, ...]) -> Percept:
    """What one person perceives; the arrays are its own, to keep."""
    condition, surroundings = percepts.condition, percepts.surroundings
    return Percept(
        time=percepts.time,
        period=percepts.period,
        activity=ACTIVITIES[condition.activity[i]],
        arrived=bool(condition.arrived[i]),
        touched=bool(condition.touched[i]),
        mood=float(condition.mood[i]),
        appraisals=_appraisals(i, percepts),
        pleasing=percepts.appraisals.pleasing[i].copy(),
        moving=surroundings.moving.copy(),
        sees=surroundings.sees[i].copy(),
        level=surroundings.level[i].copy(),
        names=names,
    )


def _appraisals(i: int, percepts: Percepts) -> tuple[Appraisal, ...]:
    """What one person thinks of the bouts that are new to it."""
    found = percepts.appraisals
    return tuple(
        Appraisal(
            robot=int(found.believed[i, robot]),
            value=float(found.value[i, robot]),
            attending=bool(found.attending[i, robot]),
            cause=percepts.cause(robot, percepts.time),
        )
        for robot in np.flatnonzero(found.new[i]).tolist()
    )
