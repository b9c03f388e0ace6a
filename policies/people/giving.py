"""Giving feedback: which appraisals make a person touch a robot, and how."""

import math

import numpy as np

from household.people.appraisal import Judgement
from household.people.mind import Percept, Wish
from household.people.persona import Persona
from household.streams import Draws


class FeedbackGiving:
    """A person's readiness to praise and to sanction.

    Faults are sanctioned more readily than politeness is praised; who came to expect
    politeness praises it less and less, until a fault or a time without it brings the
    wish back (paper, sections 3.1, 5.1 and 5.2).

    Args:
        persona: Holds every constant.
        n_robots: How many robots there are.
        rng: The person's own stream.

    Attributes:
        wish: The touch that the person is out to give, if any.
    """

    def __init__(
        self, persona: Persona, n_robots: int, rng: np.random.Generator
    ) -> None:
        self._persona = persona
        self._draws = Draws([rng], 2 * n_robots)
        self._freshness = [1.0] * n_robots
        self._waited = 0.0
        self.wish: Wish | None = None

    def consider(self, percept: Percept) -> None:
        """Takes in what was perceived: forms, keeps, fulfils or drops a wish."""
        persona = self._persona
        recovered = 1.0 - math.exp(-percept.period / persona.recovery)
        for robot, pleases in enumerate(percept.pleasing.tolist()):
            if not pleases:
                lost = 1.0 - self._freshness[robot]
                self._freshness[robot] += recovered * lost
        self._waited += percept.period
        if percept.touched or self._waited > persona.patience:
            self.wish = None
        draws = self._draws.next().reshape(-1, 2).tolist()
        for judgement, drawn in zip(percept.judgements, draws, strict=False):
            self._weigh(judgement, percept.mood, drawn)

    def _weigh(self, judgement: Judgement, mood: float, drawn: list[float]) -> None:
        chance, slip = drawn
        ready = chance < self._readiness(judgement, mood)
        self._get_used_to(judgement)
        if ready and self.wish is None and calls_for_feedback(self._persona, judgement):
            praise = (judgement.value > 0.0) != (slip < self._persona.mistakes)
            self.wish = Wish(
                robot=judgement.robot,
                kind="caress" if praise else "tap",
                strength=abs(judgement.value),
                cause=judgement.cause,
            )
            self._waited = 0.0

    def _readiness(self, judgement: Judgement, mood: float) -> float:
        """Chance that a person reacts to a bout that it appraised."""
        persona, value = self._persona, judgement.value
        if value > 0.0:
            return persona.praise * value * self._freshness[judgement.robot]
        return persona.sanction * -value * (1.0 - persona.irritability * mood)

    def _get_used_to(self, judgement: Judgement) -> None:
        """Politeness becomes what is expected; a fault makes it welcome again."""
        fresh, persona = self._freshness, self._persona
        robot, value = judgement.robot, judgement.value
        if value > 0.0:
            fresh[robot] *= 1.0 - persona.habituation * value
        else:
            fresh[robot] += persona.contrast * -value * (1.0 - fresh[robot])


def calls_for_feedback(persona: Persona, judgement: Judgement) -> bool:
    """Whether a bout is one that such a person reacts to at all.

    Args:
        persona: What kind of person it is.
        judgement: What it thinks of the bout.
    """
    weak = abs(judgement.value) < persona.tolerance
    missed = persona.only_when_attending and not judgement.attending
    return not weak and not missed
