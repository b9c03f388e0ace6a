from dataclasses import dataclass
from itertools import permutations

import numpy as np
import pytest

from learners import CATALOG, Experience, Reward, saved


@saved
@dataclass(frozen=True)
class ToyState:
    """Who plays what, looks at whom and hears; the canonical form by brute force."""

    plays: tuple
    looks: frozenset = frozenset()
    hears: frozenset = frozenset()

    @property
    def entities(self):
        return tuple(entity for entity, _ in self.plays)

    def swapped(self, e1, e2):
        return self.renamed({e1: e2, e2: e1})

    def without(self, e):
        return ToyState(
            tuple(pair for pair in self.plays if pair[0] != e),
            frozenset(pair for pair in self.looks if e not in pair),
            frozenset(pair for pair in self.hears if e not in pair),
        )

    def canonical(self):
        orders = permutations(self.entities)
        forms = (
            self.renamed(dict(zip(self.entities, order, strict=True)))
            for order in orders
        )
        return min(
            forms,
            key=lambda form: (form.plays, sorted(form.looks), sorted(form.hears)),
        )

    def without_names(self):
        form = self.canonical()
        return form.renamed({e: f"p{i}" for i, e in enumerate(form.entities)})

    def views(self):
        return tuple(
            (
                e,
                (
                    ("plays", role),
                    *sorted(
                        (relation, other)
                        for relation, pairs in (
                            ("attends", self.looks),
                            ("hears", self.hears),
                        )
                        for one, other in pairs
                        if one == e and other not in self.entities
                    ),
                ),
            )
            for e, role in self.plays
        )

    def renamed(self, names):
        return ToyState(
            tuple(sorted((names.get(e, e), role) for e, role in self.plays)),
            frozenset((names.get(a, a), names.get(b, b)) for a, b in self.looks),
            frozenset((names.get(a, a), b) for a, b in self.hears),
        )


@pytest.fixture(scope="session")
def toy():
    """toy("ann reads, bob calls", "bob robot"): a ToyState written as a sentence."""

    def make(plays, *looks, hears=()):
        pairs = (tuple(part.split()) for part in plays.split(", ") if part)
        return ToyState(
            tuple(sorted(pairs)),
            frozenset(tuple(look.split()) for look in looks),
            frozenset((name, "robot") for name in hears),
        )

    return make


@pytest.fixture(scope="session")
def touch():
    def make(value=1.0, time=0.0, giver="ann", attending=True, **more):
        return Reward(value=value, time=time, giver=giver, attending=attending, **more)

    return make


@pytest.fixture(scope="session")
def entry():
    """entry(state, action, time, ...): one second long and followed by itself."""

    def make(state="s", action=0, time=0.0, *rewards, **more):
        more.setdefault("next_state", state)
        more.setdefault("next_time", time + 1.0)
        return Experience(
            state=state, action=action, time=time, rewards=rewards, **more
        )

    return make


@pytest.fixture
def rng():
    return np.random.default_rng(0)


@pytest.fixture
def attached():
    """What a recipe needs of the world, for every name in the catalog."""
    world = {
        "ask": first_candidate,
        "appropriateness": likes_behavior_1,
        "cause": one_second_before,
    }
    return lambda name: {need: world[need] for need in CATALOG[name].needs}


def first_candidate(reward, candidates):
    return 0


def likes_behavior_1(state):
    return np.array([-1.0, 1.0, 0.0])


def one_second_before(reward):
    return reward.time - 1.0


@pytest.fixture
def live(toy):
    """live(learner, n, rng, start, late): n entries of a home that likes behavior 1.

    People take a while to react: nobody is seen setting out, or turning to the robot,
    within ``late`` seconds of what moves it.

    Returns the behaviors chosen.
    """

    def draw(rng):
        roles = ("reads", "calls", "plays")
        plays = ", ".join(f"{e} {roles[rng.integers(3)]}" for e in ("ann", "bob"))
        return toy(plays, *(["ann robot"] if rng.random() < 0.5 else []))

    def make(learner, n, rng, start=0.0, late=1.0):
        chosen, time, state = [], start, draw(rng)
        for _ in range(n):
            action = learner.act(state)
            chosen.append(action)
            following, walk = draw(rng), float(rng.integers(1, 5))
            moved, length = time + late, late + walk
            felt = ()
            if rng.random() < 0.4:
                felt = (
                    Reward(
                        value=1.0 if action == 1 else -1.0,
                        time=time + length,
                        giver=("ann", "bob")[rng.integers(2)],
                        attending=bool(rng.random() < 0.7),
                        mood=float(rng.uniform(-1, 1)),
                        approach_began=moved + walk / 2 if rng.random() < 0.5 else None,
                        attention_began=moved + walk / 4,
                    ),
                )
            learner.learn(
                Experience(
                    state=state,
                    action=action,
                    next_state=following,
                    time=time,
                    next_time=time + length,
                    rewards=felt,
                    attended=bool(rng.random() < 0.5),
                )
            )
            state, time = following, time + length
        return chosen

    return make
