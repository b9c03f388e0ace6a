"""The four evaluation methods of section 4.1, for every condition of an experiment."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Generic, TypeVar

import numpy as np
import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.measures import Measure
from experiments.analysis.statistics import Estimate, FloatArray, mean, proportion
from experiments.analysis.target_situations import TargetSituation

T = TypeVar("T")

BEYOND = "Beyond the paper"

METHODS = (
    "Cumulative reward",
    "Frequency of rewards",
    "Q-table",
    "Human opinion",
    BEYOND,
)
"""The paper's four methods in its order, then what only a simulator can measure."""


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """One number for how well a condition did."""

    method: str
    """One of the paper's four methods."""

    measure: str
    """What exactly, with its unit."""

    condition: str
    """Of which condition."""

    estimate: Estimate
    """Over all seeds."""

    is_share: bool = False
    """Whether to show it in percent."""


@dataclass(frozen=True, kw_only=True)
class Method:
    """One way to measure how well a condition did."""

    name: str
    """One of the paper's four methods, or `Beyond the paper`."""

    text: str
    """What exactly, with its unit."""

    measure: Measure
    """A function of one trial's table; NaN leaves the trial out."""

    is_share: bool = False
    """Whether to show it in percent."""

    estimate: Callable[[FloatArray], Estimate] = mean
    """Takes one number per seed."""


def evaluations(
    frame: pl.DataFrame,
    conditions: tuple[str, ...],
    situations: tuple[TargetSituation, ...],
    further: tuple[Method, ...] = (),
) -> tuple[Evaluation, ...]:
    """Returns every evaluation of every condition, method by method.

    Args:
        frame: The table of a study.
        conditions: In the order of presentation.
        situations: Those that are to be learned.
        further: What an experiment measures beside what all of them do.
    """
    methods = [*_methods(situations, measures.behaviors(frame)), *further]
    methods.sort(key=lambda method: METHODS.index(method.name))
    trials = {name: measures.trials_of(frame, name) for name in conditions}
    return tuple(
        _evaluated(method, trials[condition], condition)
        for method in methods
        for condition in conditions
    )


def _evaluated(
    method: Method, trials: Sequence[pl.DataFrame], condition: str
) -> Evaluation:
    values = np.array([float(method.measure(trial)) for trial in trials])
    known = values[~np.isnan(values)]
    return Evaluation(
        method=method.name,
        measure=method.text,
        condition=condition,
        estimate=method.estimate(known),
        is_share=method.is_share,
    )


def _methods(
    situations: tuple[TargetSituation, ...], behaviors: tuple[str, ...]
) -> Iterator[Method]:
    yield Method(
        name="Cumulative reward", text="at the end", measure=measures.final_reward
    )
    for sign, what in ((1, "caresses"), (-1, "taps")):
        for quarter, when in ((0, "first"), (3, "last")):
            yield Method(
                name="Frequency of rewards",
                text=f"{what} per minute, {when} quarter",
                measure=_frequency(sign, quarter),
            )
    for situation in situations:
        found = _Remembered(situation.find)
        values = _Remembered(partial(_values_at_end, found))
        yield Method(
            name="Q-table",
            text=f"{situation.name}: converged",
            measure=_of(found, measures.converged),
            is_share=True,
            estimate=proportion,
        )
        yield Method(
            name="Q-table",
            text=f"{situation.name}: right behavior has the highest Q at the end",
            measure=_of(found, social.ordered),
            is_share=True,
            estimate=proportion,
        )
        for behavior in behaviors:
            yield Method(
                name="Q-table",
                text=f"{situation.name}: final Q of {behavior.replace('_', ' ')}",
                measure=partial(_final_q, values, behavior),
            )
        yield Method(
            name=BEYOND,
            text=f"{situation.name}: right choices in the last quarter",
            measure=_of(found, social.right_share),
            is_share=True,
        )
        yield Method(
            name=BEYOND,
            text=f"{situation.name}: greedy choices that would be right, last quarter",
            measure=_of(found, social.greedy_right),
            is_share=True,
        )
    yield Method(
        name="Human opinion",
        text="1 (autistic) to 10 (sociable), at the end",
        measure=_opinion,
    )


def _frequency(sign: int, quarter: int) -> Measure:
    def measure(trial: pl.DataFrame) -> float:
        span = float(trial["next_time"].to_numpy().max()) / 4
        begin, end = quarter * span, (quarter + 1) * span
        time = pl.col("time")
        felt = measures.touches(trial).filter(
            (pl.col("value") * sign > 0) & (time > begin) & (time <= end)
        )
        return len(felt) / (span / 60.0)

    return measure


class _Remembered(Generic[T]):
    """Says of a trial once what a function says of it, for several measures.

    Args:
        function: Takes the table of a trial, which stays as it is.
    """

    def __init__(self, function: Callable[[pl.DataFrame], T]) -> None:
        self._function = function
        self._known: dict[int, tuple[pl.DataFrame, T]] = {}

    def __call__(self, trial: pl.DataFrame) -> T:
        # With the trial itself beside it, no other one gets its identity.
        if id(trial) not in self._known:
            self._known[id(trial)] = trial, self._function(trial)
        return self._known[id(trial)][1]


def _of(
    found: Callable[[pl.DataFrame], str | None],
    measure: Callable[[pl.DataFrame, str | None], float],
) -> Measure:
    return lambda trial: measure(trial, found(trial))


def _values_at_end(
    found: Callable[[pl.DataFrame], str | None], trial: pl.DataFrame
) -> dict[str, float]:
    return measures.final_q(trial, found(trial))


def _final_q(
    values: Callable[[pl.DataFrame], dict[str, float]],
    behavior: str,
    trial: pl.DataFrame,
) -> float:
    return values(trial).get(behavior, 0.0)


def _opinion(trial: pl.DataFrame) -> float:
    last = trial.sort("next_time").group_by("robot").last()
    return float(last["opinion"].to_numpy().mean())
