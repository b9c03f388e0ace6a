"""Learners: time and memory of updates, against actors and situations visited."""

from __future__ import annotations

import time
import tracemalloc
from collections.abc import Callable, Iterator, Mapping

import numpy as np

from experiments.bench.measurement import Growth, Measurement, Settings, exponent

BUDGET_ACTORS = 8
"""Actors that the budget of an update is for."""

BUDGET_PEOPLE = 12
"""People that the budgets of learning by views are for."""

LINEAR = 1.2
"""Power up to which something counts as growing like n."""

FLAT = 0.2
"""Power up to which a time counts as not growing: as much is the machine's noise."""

ACTORS = 4
"""In the states of which more and more are visited."""


def updates(settings: Settings) -> Iterator[Measurement]:
    """Yields the time of an update with the canonical form, against the actors."""
    from experiments.bench.updates import Composition, times

    canonical = Composition(settings=lambda _: {"representation": "canonical"})
    growths = [
        Growth(what="learner's update", against="actors", x=actors)
        for actors in settings.actors
    ]
    found = [
        Measurement(
            part=growth.part,
            name=str(actors),
            unit="us",
            values=tuple(
                times(canonical, actors, known=True).update
                for _ in range(min(settings.repetitions, 3))
            ),
            growth=growth,
            at_most=20.0 if actors == BUDGET_ACTORS else None,
        )
        for actors, growth in zip(settings.actors, growths, strict=True)
    ]
    yield from (*found, exponent(found, at_most=2.0))


def people(settings: Settings) -> Iterator[Measurement]:
    """Yields what the learner by views takes, against the people in a situation."""
    from experiments.bench.updates import Composition, memory, times

    views, often = Composition(learner="views"), min(settings.repetitions, 3)
    taken = {
        n: [times(views, n, known=True) for _ in range(often)] for n in settings.company
    }
    sizes = {n: [memory(views, n) for _ in range(often)] for n in settings.company}
    updates = {n: [each.update for each in found] for n, found in taken.items()}
    choices = {n: [each.choice for each in found] for n, found in taken.items()}
    yield from _against_people("update by views", "us", updates, budget=20.0)
    yield from _against_people("choice by views", "us", choices, budget=15.0)
    yield from _against_people("memory by views", "kB", sizes, budget=None)


def _against_people(
    what: str, unit: str, values: Mapping[int, list[float]], budget: float | None
) -> Iterator[Measurement]:
    growths = [Growth(what=what, against="people", x=n) for n in values]
    found = [
        Measurement(
            part=growth.part,
            name=str(n),
            unit=unit,
            values=tuple(values[n]),
            growth=growth,
            at_most=budget if n == BUDGET_PEOPLE else None,
        )
        for n, growth in zip(values, growths, strict=True)
    ]
    yield from (*found, exponent(found, at_most=LINEAR))


def visited(settings: Settings) -> Iterator[Measurement]:
    """Yields time of an update and memory of a learner, against what it visited."""
    lives = [_lives(settings.situations) for _ in range(min(settings.repetitions, 3))]
    for place, (what, unit, at_most) in enumerate(
        (("update", "us", FLAT), ("memory", "kB", 1.0))
    ):
        growths = [
            Growth(what=f"learner's {what}", against="situations visited", x=situations)
            for situations in settings.situations
        ]
        found = [
            Measurement(
                part=growth.part,
                name=f"{growth.x:.0f}",
                unit=unit,
                values=tuple(each[index][place] for each in lives),
                growth=growth,
            )
            for index, growth in enumerate(growths)
        ]
        yield from (*found, exponent(found, at_most))


def _lives(marks: tuple[int, ...]) -> list[tuple[float, float]]:
    """One learner meets ever new situations.

    Returns:
        At each mark the time of an update since the last one [us], and the memory of
        the learner [kB]. Memory is measured in a second life, as that slows it down.
    """
    clock = time.process_time
    times = [1e6 * (later - before) for before, later in _lived(marks, clock)]
    tracemalloc.start()
    try:
        sizes = [later for _, later in _lived(marks, _allocated)]
    finally:
        tracemalloc.stop()
    since = np.diff((0, *marks)).tolist()
    return [
        (spent / entries, size / 1e3)
        for spent, entries, size in zip(times, since, sizes, strict=True)
    ]


def _allocated() -> float:
    return tracemalloc.get_traced_memory()[0]


def _lived(
    marks: tuple[int, ...], gauge: Callable[[], float]
) -> Iterator[tuple[float, float]]:
    """Reads a gauge before and after what is learned up to each mark."""
    from experiments.bench.crowds import N_BEHAVIORS, experiences, walk
    from learners.credit.rules import Designated
    from learners.qlearner import QLearner
    from learners.representation import Canonical

    rng = np.random.default_rng(0)
    states = walk(ACTORS, max(marks) + 1, rng)
    lived = list(experiences(states, rng))
    learner = QLearner(
        N_BEHAVIORS, rng, credit=Designated(), representation=Canonical()
    )
    begin = gauge()
    for first, last in zip((0, *marks), marks, strict=False):
        before = gauge()
        for experience in lived[first:last]:
            learner.learn(experience)
        yield before - begin, gauge() - begin
