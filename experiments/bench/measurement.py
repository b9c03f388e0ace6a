"""Measurements: what was found, how often, and what the design demands of it."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Growth:
    """What grows with what: a point of a plot."""

    what: str
    """What is measured, at the y axis."""

    against: str
    """What there is more and more of, at the x axis."""

    x: float
    """How much of it."""

    @property
    def part(self) -> str:
        """Name of the table and the plot that it belongs to."""
        return f"{self.what} against {self.against}"


@dataclass(frozen=True, kw_only=True)
class Measurement:
    """One quantity, measured several times."""

    part: str
    """What it belongs to: a table of its own, and a plot if it has a `growth`."""

    name: str
    """What was measured."""

    unit: str
    """Of the values."""

    values: tuple[float, ...]
    """One for each repetition; none if what is measured is not installed."""

    growth: Growth | None = None
    """Where it is plotted."""

    at_most: float | None = None
    """The budget, if it is an upper bound."""

    at_least: float | None = None
    """The budget, if it is a lower bound."""

    hint: str = ""
    """How to install what is missing."""

    @property
    def median(self) -> float | None:
        """The middle of the repetitions; None if there are none."""
        return statistics.median(self.values) if self.values else None

    @property
    def holds(self) -> bool | None:
        """Whether the budget is kept; None without a budget."""
        if self.median is None:
            return None
        if self.at_most is not None:
            return self.median <= self.at_most
        if self.at_least is not None:
            return self.median >= self.at_least
        return None

    def plain(self) -> dict[str, Any]:
        """Returns everything as plain data, for JSON."""
        fields = ("part", "name", "unit", "values", "at_most", "at_least", "hint")
        plain = {name: getattr(self, name) for name in fields}
        x = None if self.growth is None else self.growth.x
        return plain | {"x": x, "median": self.median, "holds": self.holds}


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How much is measured."""

    repetitions: int = 7
    """Of everything; the median counts."""

    steps: int = 1000
    """Environment steps in a repetition, and as many before the first one: a home keeps
    the paths that it has searched, and it takes some time until it has most of them."""

    people: tuple[int, ...] = (1, 2, 4, 8, 16, 32, 64)
    """Households to step, with two robots each."""

    robots: tuple[int, ...] = (1, 2, 4, 8, 16)
    """Households to step, with four people each."""

    rooms: tuple[int, ...] = (1, 2, 4, 8, 16)
    """Generated homes to step in, with four people and two robots."""

    actors: tuple[int, ...] = (1, 2, 4, 8, 16)
    """In the states that a learner learns from."""

    company: tuple[int, ...] = (1, 2, 4, 8, 12, 16, 32, 64)
    """People in the situations that a learner takes apart."""

    situations: tuple[int, ...] = (500, 1_000, 2_000, 4_000, 8_000)
    """That a learner has visited."""

    homes: tuple[int, ...] = (1, 8, 32, 128)
    """That are stepped at once."""

    trials: int = 8
    """In a repetition, with one worker and again with two."""

    decisions: int = 4000
    """In each of the trials, so that a repetition lasts some seconds."""

    trial_decisions: int = 1800
    """In a whole trial of `evening` that is compared with its bare steps."""


SHORT_TURNS = 16
"""In a repetition, where the same code is compared with itself: other work on the
machine comes and goes. Beside other programs turns are long, as each one finds the
processor's caches full of the other's."""


def alternate(
    subjects: Mapping[str, Callable[[], object]],
    repetitions: int,
    calls: int,
    turns: int = 1,
) -> dict[str, list[float]]:
    """Times several things in turn.

    Args:
        subjects: What to call, by name; each is called as often first, to warm up.
        repetitions: How often all of it is done.
        calls: Of each in a repetition, at least.
        turns: In which a repetition is done.

    Returns:
        For each name the processor's time of one call in each repetition [s].
    """
    turns = min(turns, calls)
    each = -(-calls // turns)
    for call in subjects.values():
        _turn(call, calls)
    times: dict[str, list[float]] = {name: [] for name in subjects}
    for _ in range(repetitions):
        spent = dict.fromkeys(subjects, 0.0)
        for _ in range(turns):
            for name, call in subjects.items():
                spent[name] += _turn(call, each)
        for name, seconds in spent.items():
            times[name].append(seconds / (turns * each))
    return times


def _turn(call: Callable[[], object], calls: int) -> float:
    begin = time.process_time()
    for _ in range(calls):
        call()
    return time.process_time() - begin


def exponent(measurements: Sequence[Measurement], at_most: float) -> Measurement:
    """Returns with which power of n something grows, in the upper half of its range.

    The slope of the logarithm against that of n, fitted in each repetition; the lower
    half says little, as what does not grow at all outweighs the rest there.

    Args:
        measurements: At least two points of one plot, by growing `x`.
        at_most: The power that is allowed.
    """
    upper = measurements[-max(2, (len(measurements) + 1) // 2) :]
    n = np.log([each.growth.x for each in upper if each.growth])
    slopes = np.polyfit(n, np.log([each.values for each in upper]), 1)[0]
    return Measurement(
        part=measurements[0].part,
        name="power of n",
        unit="",
        values=tuple(slopes.tolist()),
        at_most=at_most,
    )


def ratios(above: list[float], below: list[float]) -> tuple[float, ...]:
    """Returns the ratio in each round."""
    return tuple(a / b for a, b in zip(above, below, strict=True))


def microseconds(seconds: list[float]) -> tuple[float, ...]:
    """Returns times in microseconds."""
    return tuple(1e6 * each for each in seconds)
