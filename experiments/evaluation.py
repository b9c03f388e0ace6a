"""The four evaluation methods of section 4.1, for every condition of an experiment."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import polars as pl

from experiments import measures
from experiments.measures import Measure
from experiments.statistics import Estimate, mean, proportion


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """One number that tells how well a condition did."""

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


def evaluate(
    frame: pl.DataFrame, conditions: tuple[str, ...], roles: tuple[str, ...]
) -> tuple[Evaluation, ...]:
    """Returns every evaluation of every condition, method by method.

    Args:
        frame: The table of a study.
        conditions: In the order of presentation.
        roles: The roles whose situations are to be learned.
    """
    names = measures.behaviors(frame)
    return tuple(
        Evaluation(
            method=method,
            measure=text,
            condition=condition,
            estimate=(proportion if is_share else mean)(
                measures.per_seed(frame, condition, measure)
            ),
            is_share=is_share,
        )
        for method, text, measure, is_share in _measures(roles, names)
        for condition in conditions
    )


def _measures(
    roles: tuple[str, ...], behaviors: tuple[str, ...]
) -> Iterator[tuple[str, str, Measure, bool]]:
    yield "Cumulative reward", "at the end", measures.final_reward, False
    for sign, what in ((1, "caresses"), (-1, "taps")):
        for quarter, when in ((0, "first"), (3, "last")):
            yield (
                "Frequency of rewards",
                f"{what} per minute, {when} quarter",
                _frequency(sign, quarter),
                False,
            )
    for role in roles:
        yield "Q-table", f"{role}: converged", _converged(role), True
        for name in behaviors:
            text = f"{role}: final Q of {name.replace('_', ' ')}"
            yield "Q-table", text, _final_q(role, name), False
    yield "Human opinion", "1 (autistic) to 10 (sociable), at the end", _opinion, False


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


def _converged(role: str) -> Measure:
    return lambda trial: measures.converged(trial, measures.situation_with(trial, role))


def _final_q(role: str, behavior: str) -> Measure:
    def measure(trial: pl.DataFrame) -> float:
        values = measures.final_q(trial, measures.situation_with(trial, role))
        return values.get(behavior, 0.0)

    return measure


def _opinion(trial: pl.DataFrame) -> float:
    last = trial.sort("next_time").group_by("robot").last()
    return float(last["opinion"].to_numpy().mean())
