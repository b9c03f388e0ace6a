"""The people of a household: they judge what they perceive and do what they intend."""

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from household.activity import Activity
from household.compiled.arrays import NOBODY, Floats, Indices, Mask, Zeros, new_zeros
from household.compiled.jit import FLOATS_2D, INDICES, MASK, bind, compiled
from household.home.places import NOWHERE, Places, place_of
from household.motion.crowd import Crowd
from household.motion.progress import within_reach
from household.people.appraisal import Appraisals, appraise
from household.people.feelings import Feelings, live_through
from household.people.mind import (
    Intentions,
    Minds,
    Percepts,
    Wish,
)
from household.people.person import everyone_of
from household.people.traits import Traits, traits_of
from household.perception.kernel import between
from household.perception.senses import Senses
from household.robots.robots import Robots
from household.scenario.scenario import Scenario
from household.state import Stateful

MakeMinds = Callable[[Scenario], Minds]

REACH = 0.8
"""From the middle of a person to the middle of a robot that it touches [m]."""


class People(Stateful):
    """Everybody in the household, in the order of the scenario.

    Args:
        scenario: Who they are.
        make_minds: Gives them their minds.
        zeros: Makes the arrays that others see: moods and activities.

    Attributes:
        everyone: Who they are.
        places: Where their activities are.
        appraisals: What they think of what robots do.
        feelings: Their moods and what they think of each robot.
        intentions: What each is about to do.
        place: Index of the region that each is in, -1 outside all, shape (n,).
        activity: The role that each plays, as `Activity` values, shape (n,).
        focus: What each looks at where it is, NaN for nothing, shape (n, 2) [m].
        touched: Whose wish to touch was fulfilled in this step, shape (n,).
        target: Index of the body that each is out to touch, or `NOBODY`, shape (n,).
    """

    intentions: Intentions

    STATE = (
        "places",
        "feelings",
        "appraisals",
        "intentions",
        "place",
        "activity",
        "focus",
        "touched",
        "target",
        "_minds",
        "_claimed",
        "_spots",
        "_arrived",
        "_wishes",
    )

    def __init__(
        self, scenario: Scenario, make_minds: MakeMinds, zeros: Zeros = new_zeros
    ) -> None:
        self.everyone = everyone_of(scenario)
        personas = [person.persona for person in self.everyone]
        n, n_robots = len(personas), len(scenario.robots)
        self._minds = make_minds(scenario)
        self._period = scenario.decision_period
        self.places = Places(scenario.plan)
        self.feelings = Feelings(personas, n_robots, self._period, zeros)
        self._starts = [spec.start for spec in scenario.people]
        self._robots = [spec.position for spec in scenario.robots]
        self.appraisals = Appraisals(scenario, self.everyone)
        self._claimed = [NOWHERE] * n
        self._spots = np.zeros((n, 2))
        self._arrived = np.zeros(n, np.bool_)
        self._near = np.zeros(n, np.bool_)
        self._find_at_hand = bind(_at_hand, then=(FLOATS_2D, INDICES, FLOATS_2D, MASK))
        self.place = np.full(n, NOWHERE, np.intp)
        self.activity: Indices = zeros("activity", (n,), np.intp)
        self.activity[:] = Activity.UNKNOWN
        self.touched = np.zeros(n, np.bool_)
        self.target = np.full(n, NOBODY, np.intp)
        self.focus = np.full((n, 2), np.nan)
        # Intentions come from minds, which anybody may write: not `bind`.
        self._show = partial(
            _show,
            self.place,
            self.activity,
            self.focus,
            self.places.circles,
            self.places.roles,
            self.places.facing,
            traits_of(personas),
        )
        judging = *self.feelings.arrays, *self.appraisals.arrays
        self._judge = partial(_judge, *judging)
        self._wishes: dict[int, Wish] = {}
        self._percepts: Percepts | None = None

    def begin(self, rngs: Sequence[np.random.Generator]) -> Floats:
        """Begins a new episode.

        Args:
            rngs: Each person's own random stream.

        Returns:
            Where everybody begins, shape (n, 2) [m].
        """
        self.places.clear()
        self.feelings.forget()
        self.touched[:] = False
        self.appraisals.forget()
        self._claimed = [NOWHERE] * len(self.everyone)
        self.target[:] = NOBODY
        self._wishes, self._percepts = {}, None
        self.intentions = self._minds.reset(rngs)
        self._claim_places()
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

    def show(self, position: Floats, half_view: Floats) -> bool:
        """Tells how people appear: in which role, and with open eyes or closed.

        Args:
            position: Of people and robots, shape (n + n_robots, 2) [m].
            half_view: Half of each one's field of view, (n + n_robots,) [rad]; filled
                in for people, negative with the eyes closed.

        Returns:
            Whether anybody plays another role than before.
        """
        return self._show(self.intentions.eyes_open, position, half_view)

    def judge(self, senses: Senses, robots: Robots) -> None:
        """Everybody appraises the bouts that it did not appraise before.

        Args:
            senses: What everybody perceives.
            robots: What there is to be perceived.
        """
        self._judge(
            self.activity,
            self.intentions.eyes_open,
            robots.behaviors,
            robots.begun,
            senses.attends,
            senses.attention,
            senses.sees,
            senses.level,
        )

    def decide(self, crowd: Crowd, senses: Senses, robots: Robots, now: float) -> None:
        """Everybody decides what to do next and sets about it.

        Args:
            crowd: The bodies.
            senses: What everybody perceives.
            robots: Whose bouts touches are about.
            now: [s].
        """
        before = self.intentions.wishes
        self.intentions = self._minds.decide(
            self._perceived(crowd, senses, robots, now)
        )
        self._claim_places()
        wishes = self.intentions.wishes
        changed = [] if wishes is before else self._take_up(wishes, before)
        self.touched.fill(False)
        at_hand = self._at_hand(crowd, senses)
        crowd.send_who_needs_replan(self._spots, self.target, now, but=at_hand)
        for i in changed:
            if i not in at_hand and crowd.walks(i):
                # Who was on its way elsewhere is so no longer.
                crowd.walk_began[i] = now

    def _perceived(
        self, crowd: Crowd, senses: Senses, robots: Robots, now: float
    ) -> Percepts:
        """What everybody perceives; made once, as its arrays stay the same."""
        crowd.arrived(self._spots, self._arrived)
        if self._percepts is None:
            self._percepts = Percepts(
                time=now,
                period=self._period,
                activity=self.activity,
                arrived=self._arrived,
                touched=self.touched,
                mood=self.feelings.mood,
                judgements=self.appraisals.judgements,
                pleasing=self.appraisals.pleasing,
                moving=crowd.walking[len(self.everyone) :],
                sees=senses.sees,
                level=senses.level,
                cause=robots.cause,
            )
        self._percepts.time = now
        return self._percepts

    def _claim_places(self) -> None:
        """Who intends to be elsewhere gets a spot there."""
        intended = self.intentions.place.tolist()
        if intended == self._claimed:
            return
        for i, (place, before) in enumerate(zip(intended, self._claimed, strict=True)):
            if place != before:
                self._spots[i] = self.places.claim(i, place)
        self._claimed = intended

    def _take_up(
        self, wishes: Sequence[Wish | None], before: Sequence[Wish | None]
    ) -> list[int]:
        """Who wants to touch a robot goes after it; returns whose wish is another."""
        changed = [
            i
            for i, (new, old) in enumerate(zip(wishes, before, strict=True))
            if new is not old or self.touched[i]
        ]
        for i in changed:
            wish = wishes[i]
            if wish is None:
                self._forget_wish(i)
            else:
                self._wishes[i] = wish
                self.target[i] = len(wishes) + wish.robot
        return changed

    def wishes_at_hand(self, crowd: Crowd, senses: Senses) -> list[tuple[int, Wish]]:
        """The touches that people can give from where they stand, and who can."""
        if not self._wishes:
            return []
        return [(i, self._wishes[i]) for i in self._at_hand(crowd, senses)]

    def has_touched(self, i: int) -> None:
        """A person's wish is fulfilled; its mind hears of it when it next decides."""
        self.touched[i] = True
        self._forget_wish(i)

    def _forget_wish(self, i: int) -> None:
        self._wishes.pop(i, None)
        self.target[i] = NOBODY

    def _at_hand(self, crowd: Crowd, senses: Senses) -> list[int]:
        """Whose hand can touch what it is out to touch from where it stands."""
        anybody = self._wishes and self._find_at_hand(
            crowd.position, self.target, senses.walls, self._near
        )
        return self._near.nonzero()[0].tolist() if anybody else []


@compiled
def _judge(
    mood: Floats,
    pleased: Floats,
    annoyed: Floats,
    fading: Floats,
    new: Mask,
    value: Floats,
    believed: Indices,
    attending: Mask,
    pleasing: Mask,
    judged: Indices,
    preferences: Floats,
    traits: Traits,
    activity: Indices,
    eyes_open: Mask,
    doing: Indices,
    begun: Indices,
    attends: Mask,
    attention: Floats,
    sees: Mask,
    level: Floats,
) -> None:
    """What `appraise` finds out is lived through; both say what is what."""
    appraise(
        new,
        value,
        believed,
        attending,
        pleasing,
        judged,
        preferences,
        traits,
        activity,
        eyes_open,
        doing,
        begun,
        attends,
        attention,
        sees,
        level,
    )
    live_through(mood, pleased, annoyed, fading, new, value, believed, traits)


@compiled
def _at_hand(position: Floats, target: Indices, walls: Floats, near: Mask) -> bool:
    """Who could touch what it is after: it is within reach, with no wall between.

    Args:
        position: Shape (n, 2) [m].
        target: Whom each of the first m bodies is after, `NOBODY` for none, shape (m,).
        walls: As in `between`, shape (4, k) [m].
        near: Set to who could, shape (m,).

    Returns:
        Whether anybody could.
    """
    if not within_reach(position, target, REACH, near):
        return False
    for i in range(len(target)):
        near[i] = near[i] and between(position, i, target[i], walls) == 0
    return bool(near.any())


@compiled
def _show(
    place: Indices,
    activity: Indices,
    focus: Floats,
    circles: Floats,
    roles: Indices,
    facing: Floats,
    traits: Traits,
    eyes_open: Mask,
    position: Floats,
    half_view: Floats,
) -> bool:
    changed = False
    for i in range(len(place)):
        place[i] = place_of(position[i], circles)
        # The last ones are for nowhere, which -1 is the index of.
        changed |= activity[i] != roles[place[i]]
        activity[i], focus[i] = roles[place[i]], facing[place[i]]
        half = math.radians(traits[i]["field_of_view"] / 2)
        half_view[i] = half if eyes_open[i] else -1.0
    return changed
