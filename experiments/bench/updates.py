"""How long learning and choosing take, against the number of actors.

Run with `python -m experiments.bench.updates`; the tables go into docs/learners.md.
"""

import time
import tracemalloc
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle, islice
from typing import Any

import numpy as np

from experiments.bench.crowds import N_BEHAVIORS, Crowd, experiences, walk
from learners.catalog import make_learner
from learners.components import made
from learners.experience import Experience
from learners.learner import Learner

KNOWN_STATES = 100
UPDATES = 2000  # once to warm up, once measured
RUNS = 10  # stretches that the measured updates are timed in
SWEEPS = 3  # over the whole table


@dataclass(frozen=True, kw_only=True)
class Composition:
    """A learner whose time is taken.

    Attributes:
        learner: its name in the catalog.
        settings: see `learners.components`.
        most_actors: beyond, it is left out.
    """

    learner: str = "designated"
    settings: Callable[[int], Mapping[str, Any]] = lambda _: {}
    most_actors: int = 64

    def make(self, n_actors: int) -> Learner:
        """A new one for states of so many actors."""
        settings = made(self.settings(n_actors))
        return make_learner(
            self.learner, N_BEHAVIORS, np.random.default_rng(0), **settings
        )


@dataclass(frozen=True, kw_only=True)
class Times:
    """What a learner takes [us].

    Attributes:
        update: one `learn`.
        choice: one `act`.
    """

    update: float
    choice: float


def times(composition: Composition, n_actors: int, *, known: bool) -> Times:
    """Times a learner that lives through the states of a crowd.

    Times are the means of the fastest of ten runs: other work on the machine only adds
    to them.

    Args:
        composition: the learner.
        n_actors: actors in every state.
        known: whether the states come from a small set and were all met before, or
            are as good as never met before.
    """
    rng = np.random.default_rng(0)
    lived = list(experiences(_states(n_actors, rng, known=known), rng))
    learner = composition.make(n_actors)
    for experience in lived[:UPDATES]:
        learner.learn(experience)
    runs = [
        _run(learner, [lived[i] for i in run])
        for run in np.array_split(np.arange(UPDATES, 2 * UPDATES), RUNS)
    ]
    choice, update = (1e6 * each for each in np.min(runs, axis=0).tolist())
    return Times(update=update, choice=choice)


def memory(composition: Composition, n_actors: int) -> float:
    """Memory of a learner that lived through the known states of a crowd [kB]."""
    rng = np.random.default_rng(0)
    lived = list(experiences(_states(n_actors, rng, known=True), rng))
    tracemalloc.start()
    try:
        learner = composition.make(n_actors)
        for experience in lived[:UPDATES]:
            learner.act(experience.state)
            learner.learn(experience)
        return tracemalloc.get_traced_memory()[0] / 1e3
    finally:
        tracemalloc.stop()


def _states(n_actors: int, rng: np.random.Generator, *, known: bool) -> list[Crowd]:
    if known:
        return list(islice(cycle(walk(n_actors, KNOWN_STATES, rng)), 2 * UPDATES + 1))
    return walk(n_actors, 2 * UPDATES + 1, rng)


def _run(learner: Learner, lived: Sequence[Experience]) -> tuple[float, float]:
    """Seconds of one choice and of one update."""
    clock, n = time.process_time, len(lived)
    begin = clock()
    for experience in lived:
        learner.act(experience.state)
    chosen = clock()
    for experience in lived:
        learner.learn(experience)
    return (chosen - begin) / n, (clock() - chosen) / n


BY_VIEWS = {"representation": "views", "pooling": "hierarchical_rates"}

ANALOGIES: Mapping[str, Composition] = {
    "none": Composition(),
    "one swap": Composition(settings=lambda _: {"analogy": "swap"}, most_actors=16),
    "closed swaps": Composition(
        settings=lambda n: {"analogy": {"name": "swap", "depth": max(n - 1, 1)}},
        most_actors=4,  # up to n! analogs
    ),
    "canonical": Composition(settings=lambda _: {"representation": "canonical"}),
    "adaptive": Composition(settings=lambda _: {"analogy": "adaptive"}),
}

PEOPLE: Mapping[str, Composition] = {
    "`views`": Composition(learner="views"),
    "`audible_views`": Composition(learner="audible_views"),
    "`nested_views`": Composition(learner="nested_views"),
    "`views`, adaptive pooling": Composition(
        learner="views", settings=lambda _: {"pooling": "adaptive"}
    ),
    "`views`, Thompson": Composition(
        learner="views", settings=lambda _: {"exploration": "thompson"}
    ),
    "`tamer` by views": Composition(learner="tamer", settings=lambda _: BY_VIEWS),
    "`designated_views`": Composition(learner="designated_views"),
    "`travel_posterior` by views": Composition(
        learner="travel_posterior", settings=lambda _: BY_VIEWS
    ),
}


def table(
    compositions: Mapping[str, Composition],
    actors: Sequence[int],
    cell: Callable[[Composition, int], list[float]],
) -> str:
    """A table in Markdown: a row for each number of actors, a column for each learner.

    Args:
        compositions: the learners, by the heading of their column.
        actors: how many there are in a state.
        cell: measures the numbers of a cell.
    """
    cells = [
        (name, n)
        for n in actors
        for name, each in compositions.items()
        if n <= each.most_actors
    ]
    # Several sweeps over the whole table, so that a busy minute of the machine does not
    # settle on one cell.
    sweeps = [[cell(compositions[name], n) for name, n in cells] for _ in range(SWEEPS)]
    best = dict(zip(cells, np.min(sweeps, axis=0).tolist(), strict=True))
    lines = [
        f"| actors | {' | '.join(compositions)} |",
        f"| --- {'| --- ' * len(compositions)}|",
    ]
    for n in actors:
        row = [_text(best.get((name, n))) for name in compositions]
        lines.append(f"| {n} | {' | '.join(row)} |")
    return "\n".join(lines)


def known_and_new(composition: Composition, n_actors: int) -> list[float]:
    """Time of an update in states met before, and in new ones [us]."""
    return [times(composition, n_actors, known=known).update for known in (True, False)]


def update_and_choice(composition: Composition, n_actors: int) -> list[float]:
    """Time of an update and of a choice in states met before [us]."""
    found = times(composition, n_actors, known=True)
    return [found.update, found.choice]


def _text(numbers: list[float] | None) -> str:
    return "-" if numbers is None else " / ".join(f"{each:.1f}" for each in numbers)


if __name__ == "__main__":
    print(table(ANALOGIES, (1, 2, 4, 8, 16), known_and_new), end="\n\n")
    print(table(PEOPLE, (1, 2, 4, 8, 12, 16, 32, 64), update_and_choice))
