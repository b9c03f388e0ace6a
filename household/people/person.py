"""A person: its body, its private thoughts and its mind."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from household.people.appraisal import Judgement, moved_mood, opinion
from household.people.mind import Intention, Mind
from household.people.persona import Persona


@dataclass(slots=True)
class Person:
    """One simulated person.

    Attributes:
        name: Unique in the household.
        persona: What kind of person it is.
        preferences: What it finds polite, shape (n_activities, 2, n_behaviors), in
            [-1, 1]; private.
        mind: What decides for it.
        intention: What it is about to do.
        mood: In [-1, 1]; private, robots perceive it with noise.
        pleased: Sum of its positive appraisals, for each robot.
        annoyed: Sum of its negative appraisals, for each robot, as positive numbers.
        touched: Whether its wish to touch was fulfilled in this step.
    """

    name: str
    persona: Persona
    preferences: NDArray[np.float64]
    mind: Mind
    n_robots: int
    intention: Intention = field(default=Intention(place=0))
    mood: float = 0.0
    pleased: list[float] = field(init=False)
    annoyed: list[float] = field(init=False)
    touched: bool = False
    _half_view: float = field(init=False)

    def __post_init__(self) -> None:
        self._half_view = math.radians(self.persona.field_of_view) / 2
        self._forget()

    def _forget(self) -> None:
        self.mood = 0.0
        self.pleased = [0.0] * self.n_robots
        self.annoyed = [0.0] * self.n_robots
        self.touched = False

    def begin(self, rng: np.random.Generator) -> None:
        """Begins a new episode with its own random stream."""
        self._forget()
        self.intention = self.mind.reset(rng)

    def live_through(self, judgement: Judgement) -> None:
        """An appraisal moves the mood and is remembered for the questionnaire."""
        self.mood = moved_mood(self.mood, judgement.value, self.persona.mood_change)
        robot, value = judgement.robot, judgement.value
        if value > 0.0:
            self.pleased[robot] += value
        else:
            self.annoyed[robot] -= value

    def calm_down(self, period: float) -> None:
        """A mood fades with time."""
        self.mood *= math.exp(-period / self.persona.mood_recovery)

    def opinion(self, robot: int) -> int:
        """Its questionnaire answer on a robot, from 1 to 10 (paper, section 4.1)."""
        return opinion(self.pleased[robot], self.annoyed[robot])

    @property
    def half_view(self) -> float:
        """Half its field of view [rad]; negative with the eyes closed."""
        if not self.intention.eyes_open:
            return -1.0
        return self._half_view

    @property
    def hears_from(self) -> float:
        """Level from which it hears at all [dB]: asleep, what wakes it."""
        return 0.0 if self.intention.eyes_open else self.persona.wakes_at
