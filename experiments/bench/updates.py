"""How long an update takes, against the number of actors and the analogy.

Run with `python -m experiments.bench.updates`; the table goes into docs/learners.md.
"""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from learners.analogy import Propagation
from learners.analogy.adaptive import AdaptiveAnalogy
from learners.credit.rules import Designated
from learners.experience import Experience, Reward
from learners.qlearner import QLearner
from learners.representation import Canonical

ROLES = ("entering", "working", "reading", "sleeping", "playing", "calling", "unknown")
N_BEHAVIORS = 4
ENTRY = 4.0  # [s], about half a behavior: situations change in between
TOUCH_EVERY = 4  # entries
KNOWN_STATES = 100
UPDATES = 2000  # once to warm up, once measured
RUNS = 10  # parts that the measured updates are timed in
SWEEPS = 3  # over the whole table


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
        touch = Reward(
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
            rewards=(touch,) if index % TOUCH_EVERY == 0 else (),
        )


def microseconds(components: Mapping[str, Any], n_actors: int, *, known: bool) -> float:
    """Time of one `learn`, designated credit and social rate [us].

    The mean of the fastest of ten runs: other work on the machine only adds to it.

    Args:
        components: of the learner beside its credit.
        n_actors: actors in every state.
        known: whether the states come from a small set and were all met before, or
            are as good as never met before.
    """
    rng = np.random.default_rng(0)
    pool = crowds(n_actors, KNOWN_STATES if known else 2 * UPDATES, rng)
    order = rng.integers(len(pool), size=2 * UPDATES) if known else range(2 * UPDATES)
    lived = list(experiences((pool[i] for i in order), rng))
    learner = QLearner(N_BEHAVIORS, rng, credit=Designated(), **components)
    for experience in lived[:UPDATES]:
        learner.learn(experience)
    measured = np.array_split(np.arange(UPDATES, len(lived)), RUNS)
    return min(_seconds(learner, [lived[i] for i in run]) for run in measured) * 1e6


def _seconds(learner: QLearner, lived: list[Experience]) -> float:
    begin = time.process_time()
    for experience in lived:
        learner.learn(experience)
    return (time.process_time() - begin) / len(lived)


ANALOGIES: dict[str, Callable[[int], dict[str, Any]]] = {
    "none": lambda _: {},
    "one swap": lambda _: {"analogy": Propagation()},
    "closed swaps": lambda n: {"analogy": Propagation(depth=max(n - 1, 1))},
    "canonical": lambda _: {"representation": Canonical()},
    "adaptive": lambda _: {"analogy": AdaptiveAnalogy()},
}
LARGEST_CLOSURE = 4  # actors; the closure has up to n! states


def table(actors: Sequence[int] = (1, 2, 4, 8, 16)) -> str:
    """The speed table in Markdown: microseconds per update, known / new states."""
    cells = [(name, n) for n in actors for name in ANALOGIES if _feasible(name, n)]
    # Several sweeps over the whole table, so that a busy minute of the machine does not
    # settle on one cell.
    sweeps = [[_known_and_new(*cell) for cell in cells] for _ in range(SWEEPS)]
    best = dict(zip(cells, np.min(sweeps, axis=0), strict=True))
    lines = [
        f"| actors | {' | '.join(ANALOGIES)} |",
        f"| --- {'| --- ' * len(ANALOGIES)}|",
    ]
    for n in actors:
        row = [_cell(best.get((name, n))) for name in ANALOGIES]
        lines.append(f"| {n} | {' | '.join(row)} |")
    return "\n".join(lines)


def _feasible(name: str, n_actors: int) -> bool:
    return name != "closed swaps" or n_actors <= LARGEST_CLOSURE


def _known_and_new(name: str, n_actors: int) -> list[float]:
    make = ANALOGIES[name]
    return [
        microseconds(make(n_actors), n_actors, known=known) for known in (True, False)
    ]


def _cell(known_and_new: NDArray[np.float64] | None) -> str:
    if known_and_new is None:
        return "-"
    return " / ".join(f"{each:.1f}" for each in known_and_new)


if __name__ == "__main__":
    print(table())
