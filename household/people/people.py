"""The people of a household: they appraise what they perceive, decide and set out."""

from collections.abc import Callable, Sequence

import numpy as np

from household.compiled.arrays import Floats, Zeros, new_zeros
from household.compiled.jit import bind, compiled
from household.home.places import NOWHERE, Places
from household.motion.bodies import Goals
from household.motion.crowd import Crowd
from household.people.appearance import Appearance, appear, appearance_of, regions_of
from household.people.appraisal import Appraisers, appraise, no_appraisals
from household.people.feelings import Feelings, feelings_of, live_through
from household.people.mind import (
    OWN_ACTIVITY,
    Appraisals,
    Condition,
    Intentions,
    Minds,
    Percepts,
    Surroundings,
    Wish,
)
from household.people.person import everyone_of
from household.people.preferences import Preferences
from household.people.traits import Traits, traits_of
from household.people.wishes import Wishes
from household.perception.relations import Relations
from household.perception.senses import Senses
from household.robots.bout import Bouts
from household.robots.robots import Robots
from household.scenario.scenario import Scenario
from household.state import Stateful

MakeMinds = Callable[[Scenario], Minds]


class People(Stateful):
    """Everybody in the household, in the order of the scenario.

    Args:
        scenario: Who they are.
        make_minds: Gives them their minds.
        zeros: Makes the arrays that are recorded: moods and activities.

    Attributes:
        everyone: Who they are.
        places: Where their activities are.
        preferences: What they find polite now.
        feelings: Their moods and what they think of each robot.
        appraisals: What each thinks of what each robot does.
        appearance: How they appear to whoever looks at them.
        look: Index of the entity that each is to look at, or `OWN_ACTIVITY`, (n,).
        wishes: The touches that they are out to give.
    """

    STATE = (
        "places",
        "feelings",
        "appearance",
        "look",
        "wishes",
        "_minds",
        "_claimed",
        "_spots",
        "_arrived",
        "appraisals",
        "_last",
    )

    def __init__(
        self, scenario: Scenario, make_minds: MakeMinds, zeros: Zeros = new_zeros
    ) -> None:
        self.everyone = everyone_of(scenario)
        personas = [person.persona for person in self.everyone]
        n, n_robots = len(personas), len(scenario.robots)
        self._minds = make_minds(scenario)
        self._period = scenario.decision_period
        self._starts = [spec.start for spec in scenario.people]
        self._robots = [spec.position for spec in scenario.robots]
        self.places = Places(scenario.plan)
        self.preferences = Preferences(scenario, self.everyone)
        self.feelings = feelings_of(personas, n_robots, self._period, zeros)
        self.appearance = appearance_of(n, zeros)
        self.look = np.full(n, OWN_ACTIVITY, np.intp)
        self.wishes = Wishes(n)
        self._claimed = [NOWHERE] * n
        self._spots = np.zeros((n, 2))
        self._goals = Goals(self._spots, self.wishes.target)
        self._arrived = np.zeros(n, np.bool_)
        self._percepts: Percepts | None = None
        self.appraisals = no_appraisals(n, n_robots)
        # The decision at which the bout began that each person last judged.
        self._last = np.full((n, n_robots), -1, np.intp)
        traits, regions = traits_of(personas), regions_of(self.places)
        self._appear = bind(appear, self.appearance, regions, traits)
        self._appraisers = (
            Appraisers(self.preferences.values, self._last),
            traits,
            self.appraisals,
            self.feelings,
            self.appearance,
        )
        self._bouts: Bouts | None = None

    def begin(self, rngs: Sequence[np.random.Generator]) -> Floats:
        """Begins a new episode.

        Args:
            rngs: Each person's own random stream.

        Returns:
            Where everybody begins, shape (n, 2) [m].
        """
        self.places.clear()
        self.preferences.hold_at(0.0)
        self.feelings.forget()
        self._last[:] = -1
        self.wishes.forget()
        self._claimed = [NOWHERE] * len(self.everyone)
        self._adopt(self._minds.reset(rngs))
        position = np.zeros((len(self.everyone), 2))
        taken = [*self._robots, *filter(None, self._starts)]
        for i, (x, y) in enumerate(self._spots.tolist()):
            begin = self._starts[i] or self.places.beside((x, y), taken)
            taken.append(begin)
            position[i] = begin
        return position

    def opinions(self, robot: int) -> dict[str, int]:
        """Each person's questionnaire answer on a robot, 1 to 10 (paper, 4.1)."""
        return {
            person.name: self.feelings.opinion(i, robot)
            for i, person in enumerate(self.everyone)
        }

    def appear(self, position: Floats, half_view: Floats) -> bool:
        """Brings up to date how people appear: in which role, with eyes open or closed.

        Args:
            position: Of people and robots, shape (n + n_robots, 2) [m].
            half_view: Half of each one's field of view, (n + n_robots,) [rad]; filled
                in for people, negative with the eyes closed.

        Returns:
            Whether anybody plays another role than before.
        """
        return self._appear(position, half_view)

    def appraise(self, senses: Senses, robots: Robots, since: float) -> None:
        """Everybody appraises what the robots do, and what is new moves them.

        Args:
            senses: What everybody perceives.
            robots: What there is to be perceived.
            since: Beginning of the period in which it is perceived [s].
        """
        if robots.present is not self._bouts:  # Mostly the same, and bound once.
            self._bouts = robots.present
            known = *self._appraisers, robots.present, senses.relations
            self._appraise = bind(_appraise_and_feel, *known)
        self._appraise(since)

    def decide(self, crowd: Crowd, senses: Senses, robots: Robots, now: float) -> None:
        """Everybody decides what to do next and sets about it.

        Args:
            crowd: The bodies.
            senses: What everybody perceives.
            robots: Whose bouts touches are about.
            now: [s].
        """
        percepts = self._perceived(crowd, senses, robots, now)
        self._adopt(self._minds.decide(percepts))
        self.wishes.touched.fill(False)
        at_hand = list(self.wishes_at_hand(crowd, senses))
        crowd.send_who_needs_replan(self._goals, but=at_hand)

    def wishes_at_hand(self, crowd: Crowd, senses: Senses) -> dict[int, Wish]:
        """The wishes that people can fulfill from where they stand, by person."""
        return self.wishes.at_hand(crowd.position, senses.walls)

    def _perceived(
        self, crowd: Crowd, senses: Senses, robots: Robots, now: float
    ) -> Percepts:
        """What everybody perceives; made once, as its arrays stay the same."""
        n = len(self.everyone)
        crowd.arrived(self._spots, self._arrived)
        if self._percepts is None:
            self._percepts = Percepts(
                time=now,
                period=self._period,
                condition=Condition(
                    activity=self.appearance.activity,
                    arrived=self._arrived,
                    touched=self.wishes.touched,
                    mood=self.feelings.mood,
                ),
                surroundings=Surroundings(
                    sees=senses.relations.sees[:n],
                    level=senses.relations.level[:n],
                    moving=crowd.walking[n:],
                ),
                appraisals=self.appraisals,
                cause=robots.cause,
            )
        self._percepts.time = now
        return self._percepts

    def _adopt(self, intentions: Intentions) -> None:
        """Takes over what the minds intend.

        Anybody may write minds, and compiled loops rely on the types of arrays: so they
        are copied into arrays of our own.
        """
        self.look[:] = intentions.look
        self.appearance.eyes_open[:] = intentions.eyes_open
        self._claim_places(intentions.place.tolist())
        changed = intentions.changed.tolist()
        if True in changed:
            who = [i for i, new in enumerate(changed) if new]
            self.wishes.take_up(intentions.wishes, who)

    def _claim_places(self, intended: list[int]) -> None:
        """Who intends to be elsewhere gets a spot there."""
        if intended == self._claimed:
            return
        for i, (place, before) in enumerate(zip(intended, self._claimed, strict=True)):
            if place != before:
                self._spots[i] = self.places.claim(i, place)
        self._claimed = intended


@compiled
def _appraise_and_feel(
    appraisers: Appraisers,
    traits: Traits,
    appraisals: Appraisals,
    feelings: Feelings,
    appearance: Appearance,
    bouts: Bouts,
    relations: Relations,
    since: float,
) -> None:
    """Appraises and lives through what was found, all in one call."""
    appraise(appraisers, traits, appraisals, appearance, bouts, relations, since)
    live_through(feelings, appraisals, traits)
