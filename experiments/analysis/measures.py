"""What is read off the tables of trials: choices, values, touches, convergence.

Unless it says otherwise, a function takes the table of one trial (one seed of one
condition; columns as in `experiments.running.trial_columns`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from math import ceil

import numpy as np
import numpy.typing as npt
import polars as pl

from experiments.analysis.statistics import FloatArray

Measure = Callable[[pl.DataFrame], float]
"""Takes the table of a trial, returns one number."""

CONVERGED_SHARE = 0.9
"""Share of appropriate choices from which a situation counts as learned."""


@dataclass(frozen=True, kw_only=True)
class StudyMeasure:
    """Takes the table of a study, returns one number per seed."""

    label: str
    """The condition, or the contrast of conditions, that is measured, in words."""

    conditions: tuple[str, ...]
    """Names of the conditions whose trials it needs; empty if it needs none."""

    values: Callable[[pl.DataFrame], FloatArray]
    """Takes the study's table, returns one number per seed, shape (n_seeds,); NaN where
    a seed has nothing to be measured."""


def per_seed(frame: pl.DataFrame, condition: str, measure: Measure) -> FloatArray:
    """Returns a measure of every trial of a condition, in the order of the seeds.

    Args:
        frame: The table of a study, with `condition` and `seed`.
        condition: Which condition.
        measure: A function of one trial's table.

    Returns:
        Shape (n_seeds,).
    """
    return np.array([float(measure(trial)) for trial in trials_of(frame, condition)])


def trials_of(frame: pl.DataFrame, condition: str) -> list[pl.DataFrame]:
    """Returns the tables of the trials of a condition, in the order of the seeds."""
    chosen = frame.filter(pl.col("condition") == condition)
    return chosen.sort("seed", maintain_order=True).partition_by("seed")


def of(condition: str, measure: Measure, *, label: str | None = None) -> StudyMeasure:
    """Returns a measure of a study: that of every trial of a condition.

    Args:
        condition: The name of the condition.
        measure: A function of one trial's table.
        label: What is measured, in words; None: the name of the condition.
    """
    return StudyMeasure(
        label=condition if label is None else label,
        conditions=(condition,),
        values=partial(per_seed, condition=condition, measure=measure),
    )


def of_each(conditions: Sequence[str], measure: Measure) -> tuple[StudyMeasure, ...]:
    """Returns the measure of a study for each of some conditions."""
    return tuple(of(condition, measure) for condition in conditions)


def on_references(measure: Measure) -> Callable[[str], StudyMeasure]:
    """Returns the measure of a study for any condition that is named."""
    return partial(of, measure=measure)


def difference(more: str, less: str, measure: Measure) -> StudyMeasure:
    """Returns a measure of a study: by how much two conditions differ, seed by seed.

    Args:
        more: The condition that is taken from.
        less: The condition that is taken away.
        measure: A function of one trial's table.
    """

    def measured(frame: pl.DataFrame) -> FloatArray:
        one = per_seed(frame, more, measure)
        return one - per_seed(frame, less, measure)

    return StudyMeasure(
        label=f"{more} - {less}", conditions=(more, less), values=measured
    )


def decisions(trial: pl.DataFrame, situation: str | None) -> pl.DataFrame:
    """Returns the entries in which a behavior was chosen in a situation."""
    return trial.filter(
        pl.col("chosen") & (pl.col("situation") == pl.lit(situation, pl.String))
    )


def last_quarter(table: pl.DataFrame) -> pl.DataFrame:
    """Returns the last quarter of the rows, rounded up."""
    return table.tail(ceil(len(table) / 4))


def appropriate(table: pl.DataFrame) -> npt.NDArray[np.bool_]:
    """Returns in which entries the robot did what the people then wanted most.

    Args:
        table: Entries in which a behavior was chosen.

    Returns:
        Shape (n_rows,). Where several behaviors are wanted equally, each will do.
    """
    wanted = table["appropriateness"].struct.unnest()
    best = wanted.to_numpy().max(axis=1, initial=-np.inf)
    columns = [wanted.columns.index(name) for name in table["behavior"]]
    done = wanted.to_numpy()[np.arange(len(table)), columns]
    result: npt.NDArray[np.bool_] = done >= best - 1e-9
    return result


def q_curve(
    trial: pl.DataFrame, situation: str | None, behavior: str
) -> tuple[FloatArray, FloatArray]:
    """Returns the course of one Q-value: the times of its changes and its values.

    Every change of a situation that the study follows has its own time. A change of
    another one has the time at which the robot met it again, or the trial's end.

    Returns:
        Times [s] and values, equally long; both empty if the situation was never met.
        The first is the value when the situation was first met.
    """
    met = trial.filter(pl.col("situation") == pl.lit(situation, pl.String)).head(1)
    if met.is_empty():
        return np.empty(0), np.empty(0)
    changes = _changes(trial).filter(
        (pl.col("situation") == pl.lit(situation, pl.String))
        & (pl.col("behavior") == behavior)
    )
    first = met["q"].struct.field(behavior)[0]
    times = np.concatenate([met["time"].to_numpy(), changes["next_time"].to_numpy()])
    return times, np.concatenate([[first], changes["value"].to_numpy()])


def behaviors(frame: pl.DataFrame) -> tuple[str, ...]:
    """Returns the names of the behaviors in the order of their actions."""
    return tuple(frame["q"].struct.fields)


def final_values(trial: pl.DataFrame) -> dict[str | None, dict[str, float]]:
    """Returns the Q-values at the end, of each situation that was met."""
    met = trial.group_by("situation", maintain_order=True).agg(pl.col("q").first())
    values: dict[str | None, dict[str, float]] = dict(met.iter_rows())
    last = _changes(trial).group_by("situation", "behavior").agg(pl.col("value").last())
    for situation, behavior, value in last.iter_rows():
        if situation in values:
            values[situation][behavior] = value
    return values


def _changes(trial: pl.DataFrame) -> pl.DataFrame:
    """One row for each change of a Q-value, in order, with when it is seen."""
    told = trial.select("next_time", "updates").explode("updates")
    return told.drop_nulls("updates").unnest("updates")


def final_q(trial: pl.DataFrame, situation: str | None) -> dict[str, float]:
    """Returns the Q-values of a situation at the end; empty if it was never met."""
    return {} if situation is None else final_values(trial).get(situation, {})


def masters(trial: pl.DataFrame, situation: str | None) -> bool:
    """Returns whether at least 90 % of the last quarter of the choices are right.

    What there is of `converged` for a policy that has no Q-values of its own.
    """
    return _mastered(last_quarter(decisions(trial, situation)))


def converged(trial: pl.DataFrame, situation: str | None) -> bool:
    """Returns whether a situation was learned.

    Over the last quarter of the decisions taken in it at least 90 % are appropriate,
    and at the end the Q-value of the appropriate behavior (in the last decision) is
    above all others.
    """
    last = last_quarter(decisions(trial, situation))
    return _mastered(last) and _settled(last, final_q(trial, situation))


def learned_share(trial: pl.DataFrame, least: int = 8) -> float:
    """Returns the share of the situations with enough decisions that converged.

    Args:
        trial: The table of a trial.
        least: Decisions that a situation needs to be counted (our choice: the last
            quarter is then two at least).
    """
    parts = trial.filter("chosen").partition_by("situation")
    ends = [last_quarter(part) for part in parts if len(part) >= least]
    if not ends:
        return float("nan")
    values = final_values(trial)
    learned = [
        _mastered(last) and _settled(last, values[last["situation"][0]])
        for last in ends
    ]
    return float(np.mean(learned))


def _mastered(last: pl.DataFrame) -> bool:
    """Whether at least 90 % of these choices are right."""
    return not last.is_empty() and appropriate(last).mean() >= CONVERGED_SHARE


def _settled(last: pl.DataFrame, values: dict[str, float]) -> bool:
    """Whether what was right in the last of these choices has the highest value."""
    wanted: dict[str, float] = last["appropriateness"][-1]
    best = max(wanted.values()) - 1e-9
    right = max(values[name] for name, worth in wanted.items() if worth >= best)
    wrong = [values[name] for name, worth in wanted.items() if worth < best]
    return all(right > value for value in wrong)


def keeps_alternating(
    trial: pl.DataFrame, situation: str | None, share: float = 0.1
) -> bool:
    """Returns whether every behavior is still chosen at the end.

    Each behavior makes up at least `share` of the choices in the last quarter of the
    decisions taken in the situation.
    """
    last = last_quarter(decisions(trial, situation))
    chosen = last["behavior"].to_list()
    return bool(chosen) and all(
        chosen.count(name) >= share * len(chosen) for name in behaviors(trial)
    )


def fall_from_peak(values: FloatArray) -> float:
    """Returns how much of its highest value a curve has lost at the end.

    Returns:
        (peak - end) / peak; 0 if it never was positive, for then nothing was learned
        that could be forgotten.
    """
    peak = float(values.max(initial=0.0))
    return (peak - float(values[-1])) / peak if peak > 0 else 0.0


def touches(table: pl.DataFrame) -> pl.DataFrame:
    """Returns one row per touch, with the columns of `trial_columns.TOUCH`.

    Args:
        table: The table of a trial or of a study; `condition` and `seed` are kept.
    """
    keys = [name for name in ("condition", "seed", "robot") if name in table.columns]
    felt = table.select(*keys, "touches").explode("touches").drop_nulls("touches")
    return felt.unnest("touches")


def final_reward(trial: pl.DataFrame) -> float:
    """Returns the cumulative reward at the end, over all robots."""
    return float(trial["reward"].sum())


def typical_seed(frame: pl.DataFrame, condition: str) -> int:
    """Returns the seed whose final cumulative reward is the median of all seeds.

    With an even number of seeds the two in the middle tie; ties go to the lowest seed.

    Args:
        frame: The table of a study.
        condition: The condition that is meant.
    """
    rewards = (
        frame.filter(pl.col("condition") == condition)
        .group_by("seed")
        .agg(pl.col("reward").sum())
        .sort("seed")
    )
    distance = (rewards["reward"] - rewards["reward"].median()).abs().round(9)
    return int(rewards["seed"][int(distance.arg_min() or 0)])
