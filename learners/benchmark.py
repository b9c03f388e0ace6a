"""How long an update takes, against the number of actors and the analogy.

Run with `python -m learners.benchmark`; the table goes into docs/learners.md.
"""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Self

import numpy as np

from learners.adaptive import AdaptiveAnalogy
from learners.analogy import Analogy, Canonical, Propagation
from learners.credit import Designated
from learners.experience import Experience, Feedback
from learners.qlearner import QLearner

ROLES = ("entering", "working", "reading", "sleeping", "playing", "calling", "unknown")
N_BEHAVIORS = 4
ENTRY = 4.0  # [s], about half a behavior: situations change in between
TOUCH_EVERY = 4  # entries
KNOWN_STATES = 100
UPDATES = 4000  # once to warm up, once measured
RUNS = 10  # parts that the measured updates are timed in


@dataclass(frozen=True)
class Crowd:
    """A state of many actors: what each plays and whether it attends to the robot.

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
        places = sorted((role, attends) for _, role, attends in self.plays)
        names = self.entities
        dealt = ((n, r, a) for n, (r, a) in zip(names, places, strict=True))
        return type(self)(tuple(dealt))


def crowds(n_actors: int, n_states: int, rng: np.random.Generator) -> list[Crowd]:
    """Random states of so many actors, equal ones as likely as chance has it."""
    roles = rng.integers(len(ROLES), size=(n_states, n_actors))
    attends = rng.random((n_states, n_actors)) < 0.3
    return [
        Crowd(
            tuple(
                (f"e{i:02}", ROLES[role], bool(looks))
                for i, (role, looks) in enumerate(zip(*state, strict=True))
            )
        )
        for state in zip(roles, attends, strict=True)
    ]


def experiences(
    states: Iterable[Crowd], rng: np.random.Generator
) -> Iterator[Experience]:
    """One entry after the other through the states, a touch every few of them."""
    for index, (state, next_state) in enumerate(pairwise(states)):
        begin, end = index * ENTRY, (index + 1) * ENTRY
        touch = Feedback(
            value=float(rng.choice((-1.0, 1.0))),
            time=end,
            giver=state.entities[0],
            attending=True,
            approach_began=begin + 1.0,
        )
        yield Experience(
            state=state,
            action=int(rng.integers(N_BEHAVIORS)),
            next_state=next_state,
            time=begin,
            next_time=end,
            feedback=(touch,) if index % TOUCH_EVERY == 0 else (),
        )


def microseconds(analogy: Analogy, n_actors: int, *, known: bool) -> float:
    """Time of one `learn`, designated credit and social rate [us].

    The mean of the fastest of ten runs: other work on the machine only adds to it.

    Args:
        analogy: the analogy; its memory is filled on the way.
        n_actors: actors in every state.
        known: whether the states come from a small set and were all met before, or
            are as good as never met before.
    """
    rng = np.random.default_rng(0)
    pool = crowds(n_actors, KNOWN_STATES if known else 2 * UPDATES, rng)
    order = rng.integers(len(pool), size=2 * UPDATES) if known else range(2 * UPDATES)
    lived = list(experiences((pool[i] for i in order), rng))
    learner = QLearner(
        N_BEHAVIORS, rng, credit=Designated(), analogy=analogy, horizon=60.0
    )
    for experience in lived[:UPDATES]:
        learner.learn(experience)
    measured = np.array_split(np.arange(UPDATES, len(lived)), RUNS)
    return min(_seconds(learner, [lived[i] for i in run]) for run in measured) * 1e6


def _seconds(learner: QLearner, lived: list[Experience]) -> float:
    begin = time.perf_counter()
    for experience in lived:
        learner.learn(experience)
    return (time.perf_counter() - begin) / len(lived)


ANALOGIES: dict[str, Callable[[int], Analogy]] = {
    "none": lambda _: Analogy(),
    "one swap": lambda _: Propagation(),
    "closed swaps": lambda n: Propagation(depth=max(n - 1, 1)),
    "canonical": lambda _: Canonical(),
    "adaptive": lambda _: AdaptiveAnalogy(),
}
LARGEST_CLOSURE = 4  # actors; the closure has up to n! states


def table(actors: Iterable[int] = (1, 2, 4, 8, 16)) -> str:
    """The speed table in Markdown: microseconds per update, known / new states."""
    lines = [
        f"| actors | {' | '.join(ANALOGIES)} |",
        f"| --- {'| --- ' * len(ANALOGIES)}|",
    ]
    for n in actors:
        cells = [_cell(name, n) for name in ANALOGIES]
        lines.append(f"| {n} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _cell(name: str, n_actors: int) -> str:
    if name == "closed swaps" and n_actors > LARGEST_CLOSURE:
        return "-"
    make = ANALOGIES[name]
    known, new = (
        microseconds(make(n_actors), n_actors, known=known) for known in (True, False)
    )
    return f"{known:.1f} / {new:.1f}"


if __name__ == "__main__":
    print(table())
