"""The people of a household: they judge what they perceive and do what they intend."""

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from household.activity import Activity
from household.crowd import Crowd
from household.people.appraisal import Judgement, appraisals
from household.people.mind import OWN_ACTIVITY, Mind, Percept, Wish
from household.people.norms import norm_table
from household.people.person import Person
from household.people.places import Places
from household.people.population import preferences
from household.perception.senses import Senses
from household.robots.robots import Robots
from household.scenario import Scenario

Array = NDArray[np.float64]
MakeMinds = Callable[[Scenario], Sequence[Mind]]


ACTIVITIES = tuple(Activity)

REACH = 0.8
"""From the middle of a person to the middle of a robot that it touches [m]."""


class People:
    """Everybody in the household, in the order of the scenario.

    Args:
        scenario: Who they are.
        make_minds: Gives each of them a mind, in order.

    Attributes:
        everyone: The persons.
        places: Where their activities are.
        place: Index of the region that each is in, -1 outside all, shape (n,).
        activity: The role that each plays, as `Activity` values, shape (n,).
        pleasing: Whether each robot does what pleases each person, (n, n_robots).
    """

    def __init__(self, scenario: Scenario, make_minds: MakeMinds) -> None:
        self.places = Places(scenario.plan)
        self.everyone = [
            Person(
                name=spec.name,
                persona=persona,
                preferences=_preferences(scenario, index),
                mind=mind,
                n_robots=len(scenario.robots),
            )
            for index, (spec, persona, mind) in enumerate(
                zip(
                    scenario.people,
                    scenario.personas,
                    make_minds(scenario),
                    strict=True,
                )
            )
        ]
        self._starts = [spec.start for spec in scenario.people]
        self._robots = [spec.position for spec in scenario.robots]
        # Tastes are drawn round 0, so that on average the norms are left of them.
        norms = norm_table(scenario.household_norms, scenario.behaviors)
        average = (1.0 - scenario.heterogeneity) * norms
        self._average = np.array([average] * len(self.everyone))
        self._preferences = np.array([p.preferences for p in self.everyone]).reshape(
            len(self.everyone), len(Activity), 2, -1
        )
        self._rows = np.arange(len(self.everyone))[:, None]
        # The decision at which the bout of each robot began that each last judged.
        self._judged = np.full((len(self.everyone), len(scenario.robots)), -1)
        self._facing = [region.facing for region in scenario.plan.regions]
        self.place = np.full(len(self.everyone), -1, dtype=np.intp)
        self.activity = np.full(len(self.everyone), int(Activity.UNKNOWN))
        self.pleasing = np.zeros((len(self.everyone), len(scenario.robots)), np.bool_)

    def begin(self, rngs: Sequence[np.random.Generator]) -> Array:
        """Begins a new episode.

        Args:
            rngs: Each person's own random stream.

        Returns:
            Where everybody begins, shape (n, 2) [m].
        """
        self.places.clear()
        self._judged[:] = -1
        position = np.zeros((len(self.everyone), 2))
        taken = [*self._robots, *filter(None, self._starts)]
        for i, (person, rng) in enumerate(zip(self.everyone, rngs, strict=True)):
            person.begin(rng)
            spot = self.places.claim(i, person.intention.place)
            begin = self._starts[i] or self.places.beside(spot, taken)
            taken.append(begin)
            position[i] = begin
        self.locate(position)
        return position

    def locate(self, position: Array) -> None:
        """Reads off which role everybody plays where it stands."""
        self.place = self.places.at(position)
        self.activity = self.places.roles(self.place)

    def preferred(
        self, attends: NDArray[np.bool_], *, on_average: bool = False
    ) -> Array:
        """What everybody prefers of each robot right now.

        Args:
            attends: Whether each person attends to each robot, shape (n, n_robots).
            on_average: As if everybody were the average person of the population.

        Returns:
            Shape (n, n_robots, n_behaviors), in [-1, 1].
        """
        preferences = self._average if on_average else self._preferences
        chosen: Array = preferences[
            self._rows, self.activity[:, None], attends.astype(np.intp)
        ]
        return chosen

    def judge(
        self, senses: Senses, robots: Robots, now: float
    ) -> list[list[Judgement]]:
        """Everybody appraises the bouts that it did not appraise before.

        Appraisal = preference x how strongly the bout was seen or heard.

        Args:
            senses: What everybody perceives.
            robots: What there is to be perceived.
            now: [s].

        Returns:
            The new judgements of each person.
        """
        n = len(self.everyone)
        found: list[list[Judgement]] = [[] for _ in range(n)]
        attends = senses.attends[:n, n:]
        value = appraisals(
            self._preferences,
            self.activity,
            robots.behaviors,
            attends,
            senses.attention[:n, n:],
            senses.level[:n, n:],
            np.array([person.hears_from for person in self.everyone]),
        )
        self.pleasing = value > 0.0
        begun = np.array([bout.decision for bout in robots.bouts])
        new = (value != 0.0) & (self._judged != begun)
        self._judged = np.where(new, begun, self._judged)
        believed = _believed(senses, n).tolist()
        causes = [robots.cause(r, now) for r in range(len(begun))]
        for i, r in np.argwhere(new).tolist():
            person = self.everyone[i]
            judgement = Judgement(
                robot=believed[i][r],
                value=float(value[i, r]),
                attending=bool(attends[i, r]),
                cause=causes[r],
            )
            person.live_through(judgement)
            found[i].append(judgement)
        return found

    def decide(
        self,
        crowd: Crowd,
        senses: Senses,
        judgements: list[list[Judgement]],
        clock: tuple[float, float],
    ) -> None:
        """Everybody decides what to do next and sets about it.

        Args:
            crowd: The bodies.
            senses: What everybody perceives.
            judgements: What everybody thinks of what is new.
            clock: The time now and the time since the last decision [s].
        """
        now, period = clock
        activities = [ACTIVITIES[role] for role in self.activity.tolist()]
        for i, person in enumerate(self.everyone):
            person.calm_down(period)
            before = person.intention.wish
            person.intention = person.mind.decide(
                Percept(
                    time=now,
                    period=period,
                    activity=activities[i],
                    arrived=self._has_arrived(i, crowd),
                    touched=person.touched,
                    mood=person.mood,
                    judgements=judgements[i],
                    pleasing=self.pleasing[i],
                    moving=crowd.walking[len(self.everyone) :],
                    sees=senses.sees[i],
                    level=senses.level[i],
                )
            )
            person.touched = False
            wish = person.intention.wish
            if wish is None or not self.reaches(i, wish, crowd, senses):
                self._set_out(i, crowd, now)
                if wish is not before and crowd.walks(i):
                    # Who was on its way elsewhere is so no longer.
                    crowd.walk_began[i] = now

    def _has_arrived(self, i: int, crowd: Crowd) -> bool:
        spot = self.places.claim(i, self.everyone[i].intention.place)
        return not crowd.walks(i) and crowd.is_bound_for(i, spot)

    def wishes(self) -> Iterator[tuple[int, Wish]]:
        """The touches that people are out to give, with the index of the person."""
        for i, person in enumerate(self.everyone):
            if person.intention.wish is not None and not person.touched:
                yield i, person.intention.wish

    def reaches(self, i: int, wish: Wish, crowd: Crowd, senses: Senses) -> bool:
        """Whether a person's hand can touch the robot from where it stands."""
        person = crowd.where[i]
        robot = crowd.where[len(self.everyone) + wish.robot]
        near = math.dist(person, robot) <= REACH
        return near and senses.nothing_between(person, robot)

    def _set_out(self, i: int, crowd: Crowd, now: float) -> None:
        """Walks to where the person wants to be, unless it is on its way or there."""
        intention = self.everyone[i].intention
        if intention.wish is not None:
            goal = crowd.where[len(self.everyone) + intention.wish.robot]
        else:
            goal = self.places.claim(i, intention.place)
        if not crowd.is_bound_for(i, goal):
            crowd.send(i, goal, now)

    def gaze_targets(self, crowd: Crowd) -> Array:
        """The direction in which everybody wants to look, shape (n,) [rad]."""
        places = self.place.tolist()
        looks = [self._looks(i, place, crowd) for i, place in enumerate(places)]
        return np.array(looks)

    def _looks(self, i: int, place: int, crowd: Crowd) -> float:
        look = self.everyone[i].intention.look
        if look != OWN_ACTIVITY:
            there = crowd.where[look]
        elif crowd.walks(i) or place < 0:
            return float(crowd.heading[i])
        else:
            there = self._facing[place]
        x, y = crowd.where[i]
        return math.atan2(there[1] - y, there[0] - x)


def _preferences(scenario: Scenario, index: int) -> Array:
    """What a person of the scenario finds polite."""
    return preferences(
        norm_table(scenario.household_norms, scenario.behaviors),
        scenario.personas[index],
        scenario.behaviors,
        scenario.population,
        scenario.heterogeneity,
        index,
    )


def _believed(senses: Senses, n: int) -> NDArray[np.intp]:
    """The robot that each person blames: the one it saw, else the loudest it hears.

    Args:
        senses: What everybody perceives.
        n: How many people there are.

    Returns:
        For each robot that did something, shape (n, n_robots).
    """
    loudest = senses.level[:n, n:].argmax(axis=1)
    saw = senses.sees[:n, n:]
    return np.where(saw, np.arange(saw.shape[1]), loudest[:, None])
