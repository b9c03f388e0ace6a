"""Giving feedback: which appraisals make people touch a robot, and how."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import (
    FLOAT,
    FLOATS,
    FLOATS_2D,
    INDICES_2D,
    MASK,
    MASK_2D,
    bind,
    compiled,
)
from household.people.mind import Percepts, Wish
from household.people.traits import Traits, traits_of
from household.scenario.persona import Persona
from household.simulation.random_streams import Draws
from household.state import Stateful

DRAWS = 2
"""For each robot in each moment: whether to react, and whether it goes wrong."""

STATE = np.dtype(
    [
        ("robot", np.intp),
        ("about", np.intp),
        ("praise", np.bool_),
        ("waited", np.float64),
        ("changed", np.bool_),
    ],
    align=True,
)
"""What a person is out to do: which robot to touch, or `NOBODY`; whose bout that is
about; whether it is to be a caress; for how long already [s]; whether that is new."""


class FeedbackGiving(Stateful):
    """People's readiness to praise and to sanction.

    Faults are sanctioned more readily than politeness is praised; who came to expect
    politeness praises it less and less, until a fault or a time without it brings the
    wish back (paper, sections 3.1, 5.1 and 5.2).

    Args:
        personas: Of each person; hold every constant.
        n_robots: How many robots there are.
        rngs: Each person's own stream.

    Attributes:
        wishes: The touch that each person is out to give, if any.
        wanted: Index of the robot that each is out to touch, or `NOBODY`, shape (n,).
    """

    STATE = ("_draws", "_state", "_freshness", "wishes")

    def __init__(
        self,
        personas: Sequence[Persona],
        n_robots: int,
        rngs: Sequence[np.random.Generator],
    ) -> None:
        n = len(personas)
        self._draws = Draws(rngs, DRAWS * n_robots)
        self._state = np.zeros(n, STATE)
        self._state["robot"] = NOBODY
        self.wishes: list[Wish | None] = [None] * n
        self.wanted: Indices = self._state["robot"]
        self._changed: Mask = self._state["changed"]
        self._freshness = np.ones((n, n_robots))
        self._consider = bind(
            _consider,
            self._state,
            self._freshness,
            traits_of(personas),
            then=(
                *(MASK, MASK_2D, MASK_2D, FLOATS_2D, INDICES_2D, MASK_2D),
                *(FLOATS, FLOAT, FLOATS_2D),
            ),
        )

    def consider(self, percepts: Percepts) -> None:
        """Takes in what was perceived: forms, keeps, fulfils or drops wishes."""
        anything = self._consider(
            percepts.touched,
            percepts.pleasing,
            *percepts.judgements,
            percepts.mood,
            percepts.period,
            self._draws.next(),
        )
        if anything:
            self.wishes = self.wishes.copy()
            for i in self._changed.nonzero()[0].tolist():
                self.wishes[i] = self._wish(i, percepts)

    def _wish(self, i: int, percepts: Percepts) -> Wish | None:
        """What a person is out to do from now on."""
        robot, about, praise, *_ = self._state[i].item()
        if robot == NOBODY:
            return None
        return Wish(
            robot=robot,
            kind="caress" if praise else "tap",
            strength=abs(float(percepts.judgements.value[i, about])),
            cause=percepts.cause(about, percepts.time),
        )


@compiled
def _consider(
    state: NDArray[np.void],
    freshness: Floats,
    traits: Traits,
    touched: Mask,
    pleasing: Mask,
    new: Mask,
    value: Floats,
    believed: Indices,
    attending: Mask,
    mood: Floats,
    period: float,
    draws: Floats,
) -> bool:
    """What everybody perceived makes it used to politeness, and sometimes react.

    Args:
        state: What each is out to do, as `STATE`, shape (n,); changed in place.
        freshness: How welcome each robot's politeness still is, in [0, 1], shape
            (n, n_robots); changed in place.
        traits: Of each person, shape (n,).
        touched: As in `Percepts`, like all that follow up to ``period``.
        pleasing: Shape (n, n_robots).
        new: Shape (n, n_robots).
        value: Shape (n, n_robots).
        believed: Shape (n, n_robots).
        attending: Shape (n, n_robots).
        mood: Shape (n,).
        period: [s].
        draws: Uniform numbers, shape (n, DRAWS * n_robots).

    Returns:
        Whether anybody is out to do something else than before.
    """
    anything = False
    for i in range(len(state)):
        mine, persona = state[i], traits[i]
        _recover(freshness[i], pleasing[i], period, persona)
        mine["changed"] = False
        mine["waited"] += period
        if mine["robot"] != NOBODY and (
            touched[i] or mine["waited"] > persona["patience"]
        ):
            mine["robot"], mine["changed"] = NOBODY, True
        judged = 0
        for r in range(new.shape[1]):
            if not new[i, r]:
                continue
            chance, slip = draws[i, DRAWS * judged], draws[i, DRAWS * judged + 1]
            judged += 1
            liked, robot = value[i, r], believed[i, r]
            ready = chance < _readiness(liked, mood[i], freshness[i, robot], persona)
            freshness[i, robot] = _used_to(freshness[i, robot], liked, persona)
            calls = calls_for_feedback(liked, attending[i, r], persona)
            if ready and calls and mine["robot"] == NOBODY:
                mine["robot"], mine["about"], mine["waited"] = robot, r, 0.0
                mine["praise"] = (liked > 0.0) != (slip < persona["mistakes"])
                mine["changed"] = True
        anything |= mine["changed"]
    return anything


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
    """Politeness becomes what is expected; a fault makes it welcome again."""
    if value > 0.0:
        return fresh * (1.0 - persona["habituation"] * value)
    return fresh + persona["contrast"] * -value * (1.0 - fresh)


@compiled
def calls_for_feedback(value: float, attending: bool, persona: np.void) -> bool:
    """Whether a bout is one that such a person reacts to at all.

    Args:
        value: What it thinks of the bout, in [-1, 1].
        attending: Whether it attended to what did it.
        persona: Its row of the traits.
    """
    missed = persona["only_when_attending"] and not attending
    return not (abs(value) < persona["tolerance"] or missed)
