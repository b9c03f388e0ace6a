"""Giving feedback: which judgements make people touch a robot, how and how soon."""

import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import bind, compiled
from household.people.mind import Appraisals, Condition, Percepts, Wish
from household.people.traits import Traits, traits_of
from household.scenario.persona import Persona
from household.simulation.random_streams import Draws
from household.state import Stateful

DRAWS = 2
"""For each robot in each moment: whether to react, and whether by mistake in the wrong
way."""

DELAY_DRAWS = 2
"""For each person in each moment: they make one normal number, for how soon."""


class FeedbackState(NamedTuple):
    """What everybody is out to do, and how welcome politeness is to each.

    Attributes:
        target: Index of the robot that each is out to touch, or `NOBODY`, (n_people,).
        struck: Who made up its mind to touch a robot when this was last considered,
            shape (n_people,).
        due: Who did so before and has not reacted yet, shape (n_people,).
        left: Time until then, shape (n_people,) [s].
        meant: Index of the robot that each made up its mind to touch, (n_people,).
        about: Index of the robot whose bout the touch is about, shape (n_people,).
        praises: Whether it is to be a caress, shape (n_people,).
        strength: How strong it is to be, in [0, 1], shape (n_people,).
        waited: How long each has had its wish, shape (n_people,) [s].
        changed: Whose wish is another than before, shape (n_people,).
        freshness: How welcome each robot's politeness still is to each, in [0, 1],
            shape (n_people, n_robots).
    """

    target: Annotated[Indices, "n_people"]
    struck: Annotated[Mask, "n_people"]
    due: Annotated[Mask, "n_people"]
    left: Annotated[Floats, "n_people"]
    meant: Annotated[Indices, "n_people"]
    about: Annotated[Indices, "n_people"]
    praises: Annotated[Mask, "n_people"]
    strength: Annotated[Floats, "n_people"]
    waited: Annotated[Floats, "n_people"]
    changed: Annotated[Mask, "n_people"]
    freshness: Annotated[Floats, "n_people", "n_robots"]


class FeedbackGiving(Stateful):
    """People's readiness to praise and to sanction.

    Faults are sanctioned more readily than politeness is praised; who came to expect
    politeness praises it less and less, until a fault that it sanctioned or a time
    without politeness brings the wish back (paper, sections 3.1, 5.1 and 5.2).

    Between the judgement and the moment at which a person sets about it lies its
    reaction time (docs/deviations.md). As people decide once in a period, it is rounded
    to whole periods. One thing is on a person's mind at a time: what it judges before
    it has reacted and touched leads to nothing; but who is myopic touches the same
    robot for what that did last.

    Args:
        personas: Of each person; hold every constant.
        n_robots: How many robots there are.
        rngs: Each person's own stream.

    Attributes:
        wishes: The touch that each person is out to give, if any.
        changed: Whose wish changed when it was last considered, shape (n_people,).
        target: Index of the robot that each is out to touch, or `NOBODY`, (n_people,).
    """

    STATE = ("_draws", "_state", "_meant", "wishes")

    def __init__(
        self,
        personas: Sequence[Persona],
        n_robots: int,
        rngs: Sequence[np.random.Generator],
    ) -> None:
        n = len(personas)
        self._draws = Draws(rngs, DRAWS * n_robots + DELAY_DRAWS)
        self.wishes: list[Wish | None] = [None] * n
        self._meant: list[Wish | None] = [None] * n
        self._state = FeedbackState(
            target=np.full(n, NOBODY, np.intp),
            struck=np.zeros(n, np.bool_),
            due=np.zeros(n, np.bool_),
            left=np.zeros(n),
            meant=np.full(n, NOBODY, np.intp),
            about=np.full(n, NOBODY, np.intp),
            praises=np.zeros(n, np.bool_),
            strength=np.zeros(n),
            waited=np.zeros(n),
            changed=np.zeros(n, np.bool_),
            freshness=np.ones((n, n_robots)),
        )
        self.changed = self._state.changed
        self.target = self._state.target
        self._traits = traits_of(personas)
        self._percepts: Percepts | None = None

    def consider(self, percepts: Percepts) -> None:
        """Takes in what was perceived: forms, keeps, fulfills or drops wishes."""
        if percepts is not self._percepts:  # Mostly the same, and bound once.
            self._percepts = percepts
            known = self._state, self._traits, percepts.appraisals, percepts.condition
            self._consider = bind(_consider, *known)
        if not self._consider(percepts.period, self._draws.next()):
            return
        for i in self._state.struck.nonzero()[0].tolist():
            self._meant[i] = self._wish(i, percepts)
        for i in self.changed.nonzero()[0].tolist():
            self.wishes[i] = None if self.target[i] == NOBODY else self._meant[i]

    def _wish(self, i: int, percepts: Percepts) -> Wish:
        """What a person just made up its mind to do, for the bout that is going on."""
        state = self._state
        return Wish(
            robot=int(state.meant[i]),
            kind="caress" if state.praises[i] else "tap",
            strength=float(state.strength[i]),
            cause=percepts.cause(int(state.about[i]), percepts.time),
        )


@compiled
def _consider(
    state: FeedbackState,
    traits: Traits,
    appraisals: Appraisals,
    condition: Condition,
    period: float,
    draws: Annotated[Floats, "n_people", "n_draws"],
) -> bool:
    """What everybody perceived makes it used to politeness, and sometimes react.

    Args:
        state: Brought up to date in place.
        traits: Of each person, shape (n_people,).
        appraisals: What everybody thinks of what the robots do.
        condition: How everybody is doing.
        period: Time since the last call [s].
        draws: Uniform numbers, shape (n_people, DRAWS * n_robots + DELAY_DRAWS).

    Returns:
        Whether anybody made up its mind, or is out to do something else than before.
    """
    target, waited, changed = state.target, state.waited, state.changed
    struck, due, left = state.struck, state.due, state.left
    anybody = False
    for i in range(len(target)):
        fresh, persona = state.freshness[i], traits[i]
        _recover(fresh, appraisals.pleasing[i], period, persona)
        waited[i] += period
        left[i] -= period
        struck[i] = False
        if condition.touched[i] and target[i] != NOBODY and not state.praises[i]:
            _make_welcome(fresh, target[i], state.strength[i], persona)
        ends = condition.touched[i] or waited[i] > persona["patience"]
        changed[i] = target[i] != NOBODY and ends
        if changed[i]:
            target[i] = NOBODY
        appraised = 0
        for r in range(len(fresh)):
            if not appraisals.new[i, r]:
                continue
            place = DRAWS * appraised
            chance, slip = draws[i, place], draws[i, place + 1]
            appraised += 1
            liked, robot = appraisals.value[i, r], appraisals.believed[i, r]
            ready = chance < _readiness(liked, condition.mood[i], fresh[robot], persona)
            fresh[robot] = _used_to(fresh[robot], liked, persona)
            minded = due[i] or target[i] != NOBODY
            again = minded and _turns_to(state, i, robot, liked, persona)
            if again or (ready and not minded):
                struck[i] = True
                changed[i] |= target[i] != NOBODY
                state.meant[i], state.about[i] = robot, r
                state.strength[i] = abs(liked)
                state.praises[i] = (liked > 0.0) != (slip < _wrong(liked, persona))
                soon = _reaction(abs(liked), draws[i, -DELAY_DRAWS:], persona)
                left[i] = left[i] if minded else soon
                due[i] |= not minded
        # At the nearest decision, so that reactions are not later on average.
        if due[i] and left[i] < period / 2:
            target[i], waited[i], due[i] = state.meant[i], 0.0, False
            changed[i] = True
        anybody |= changed[i] or struck[i]
    return anybody


@compiled
def _turns_to(
    state: FeedbackState, i: int, robot: int, value: float, persona: np.void
) -> bool:
    """Whether what a robot just did replaces what a person has a touch in mind for.

    Args:
        state: What everybody has in mind.
        i: Index of the person.
        robot: Index of the robot that did it.
        value: What the person thinks of that, in [-1, 1].
        persona: Its row of the traits.
    """
    newer = robot == state.meant[i] and not state.struck[i]
    myopia = persona["myopia"]
    return newer and myopia * abs(value) > (1.0 - myopia) * state.strength[i]


@compiled
def _wrong(value: float, persona: np.void) -> float:
    """Chance that a touch says the opposite of what a person thinks of a bout."""
    mistakes, doubt = persona["mistakes"], persona["doubt"]
    if doubt == 0.0:
        return mistakes
    # Beyond 700 the power is more than a number can hold.
    by_doubt = 1.0 / (1.0 + math.exp(min(2.0 * abs(value) / doubt, 700.0)))
    return mistakes + (1.0 - 2.0 * mistakes) * by_doubt


@compiled
def _reaction(strength: float, draws: Floats, persona: np.void) -> float:
    """How long it takes from a judgement to a reaction [s].

    Log-normal; the median falls with the strength of the feeling.

    Args:
        strength: In [0, 1].
        draws: Two uniform numbers.
        persona: Its row of the traits.
    """
    median = persona["reaction"] * (1.0 - persona["haste"]) ** strength
    # A standard normal number, after Box and Muller.
    z = math.sqrt(-2.0 * math.log(1.0 - draws[0])) * math.cos(2.0 * math.pi * draws[1])
    return median * math.exp(persona["reaction_spread"] * z)


@compiled
def _recover(fresh: Floats, pleasing: Mask, period: float, persona: np.void) -> None:
    """Robots that do nothing that pleases become welcome again."""
    recovered = 1.0 - math.exp(-period / persona["recovery"])
    for robot in range(len(fresh)):
        if not pleasing[robot]:
            fresh[robot] += recovered * (1.0 - fresh[robot])


@compiled
def _readiness(value: float, mood: float, fresh: float, persona: np.void) -> float:
    """Chance that a person reacts to a bout that it appraised."""
    if value > 0.0:
        return persona["praise"] * value * fresh
    return persona["sanction"] * -value * (1.0 - persona["irritability"] * mood)


@compiled
def _used_to(fresh: float, value: float, persona: np.void) -> float:
    """Politeness becomes what is expected."""
    return fresh * (1.0 - persona["habituation"] * max(value, 0.0))


@compiled
def _make_welcome(fresh: Floats, robot: int, tap: float, persona: np.void) -> None:
    """A robot that was tapped is praised again for what is polite.

    Only a tap that was given does that, not a fault that nobody answered.
    """
    fresh[robot] += persona["contrast"] * tap * (1.0 - fresh[robot])
