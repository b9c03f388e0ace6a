"""States of many actors to learn from, without a household."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Self

import numpy as np

from learners.experience import Experience, Reward

ROLES = ("entering", "working", "reading", "sleeping", "playing", "calling", "unknown")
N_BEHAVIORS = 6
ENTRY = 4.0  # [s], about half a behavior: situations change in between
TOUCH_EVERY = 4  # entries
BOUT = 2  # entries

View = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Crowd:
    """A state of many actors: what each plays, and whether it attends to the robot.

    Nobody attends to anybody else, so that sorting gives the canonical form.
    """

    plays: tuple[tuple[str, str, bool], ...]

    @property
    def entities(self) -> tuple[str, ...]:
        """The actors, sorted by name."""
        return tuple(name for name, _, _ in self.plays)

    def swapped(self, e1: str, e2: str) -> Self:
        """Two actors in each other's place."""
        names = {e1: e2, e2: e1}
        renamed = ((names.get(name, name), r, a) for name, r, a in self.plays)
        return type(self)(tuple(sorted(renamed)))

    def without(self, e: str) -> Self:
        """The same without one actor."""
        return type(self)(tuple(each for each in self.plays if each[0] != e))

    def canonical(self) -> Self:
        """The actors' names dealt out anew in the order of their places."""
        return type(self)(self._dealt(self.entities))

    def without_names(self) -> Self:
        """The same for any actors."""
        return type(self)(self._dealt([f"p{i:02}" for i in range(len(self.plays))]))

    def views(self) -> tuple[tuple[str, View], ...]:
        """Every actor with its role and whether it attends to the robot."""
        looks = (("attends", "robot"),)
        return tuple(
            (name, (("plays", role), *(looks if attends else ())))
            for name, role, attends in self.plays
        )

    def _dealt(self, names: Sequence[str]) -> tuple[tuple[str, str, bool], ...]:
        places = sorted((role, attends) for _, role, attends in self.plays)
        return tuple((n, r, a) for n, (r, a) in zip(names, places, strict=True))


def walk(n_actors: int, n_states: int, rng: np.random.Generator) -> list[Crowd]:
    """States one after the other, each other than the last in one actor's place."""
    names = [f"e{i:02}" for i in range(n_actors)]
    places = [_place(rng) for _ in names]
    states = []
    for _ in range(n_states):
        places[rng.integers(n_actors)] = _place(rng)
        pairs = zip(names, places, strict=True)
        states.append(Crowd(tuple((name, *place) for name, place in pairs)))
    return states


def _place(rng: np.random.Generator) -> tuple[str, bool]:
    return ROLES[rng.integers(len(ROLES))], bool(rng.random() < 0.3)


def experiences(
    states: Iterable[Crowd], rng: np.random.Generator
) -> Iterator[Experience]:
    """One entry after the other through the states, a touch every few of them."""
    action = 0
    for index, (state, next_state) in enumerate(pairwise(states)):
        begin, end = index * ENTRY, (index + 1) * ENTRY
        touch = Reward(
            value=float(rng.choice((-1.0, 1.0))),
            time=end,
            giver=state.entities[rng.integers(len(state.entities))],
            attending=True,
            approach_began=begin + 1.0,
        )
        if chosen := index % BOUT == 0:
            action = int(rng.integers(N_BEHAVIORS))
        yield Experience(
            state=state,
            action=action,
            next_state=next_state,
            time=begin,
            next_time=end,
            rewards=(touch,) if index % TOUCH_EVERY == 0 else (),
            chosen=chosen,
        )
