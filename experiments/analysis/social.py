"""What experiments 2 to 5 are about: learning early, forgetting, credit, politeness.

As in `measures`, a function takes the table of one trial. Where a trial has nothing to
be measured the result is NaN, and the trial is left out of the estimate.
"""

from __future__ import annotations

import numpy as np
import polars as pl

from experiments.analysis import measures
from experiments.analysis.statistics import FloatArray


def settled_after(trial: pl.DataFrame, situation: str | None) -> int:
    """Returns after how many decisions a situation is mastered.

    The fewest decisions in the situation after which at least 90 % of all those that
    follow are appropriate; all of them if there is no such moment.
    """
    right = measures.appropriate(measures.decisions(trial, situation))
    remaining = np.arange(len(right), 0, -1)
    shares = right[::-1].cumsum()[::-1] / remaining
    good = np.flatnonzero(shares >= measures.CONVERGED_SHARE)
    return int(good[0]) if len(good) else len(right)


def wrong_among_first(trial: pl.DataFrame, situation: str | None, n: int = 10) -> float:
    """Returns how many of the first decisions in a situation are not appropriate.

    Args:
        trial: The table of a trial.
        situation: Which situation.
        n: How many decisions; NaN if there are fewer.
    """
    first = measures.appropriate(measures.decisions(trial, situation))[:n]
    return float((~first).sum()) if len(first) == n else float("nan")


def first_run(trial: pl.DataFrame, situation: str | None, n: int = 5) -> int:
    """Returns after how many decisions the first run of appropriate ones begins.

    Args:
        trial: The table of a trial.
        situation: Which situation.
        n: Length of the run; without one, all decisions count.
    """
    right = measures.appropriate(measures.decisions(trial, situation))
    for begin in range(len(right) - n + 1):
        if right[begin : begin + n].all():
            return begin
    return len(right)


def greedy_right(trial: pl.DataFrame, situation: str | None) -> float:
    """Returns how often the greedy choice would have been right in a situation.

    Of the last quarter of its decisions, by the Q-values of the moment: what the
    learner knew, whatever its exploration did. Behaviors of equal value share.
    """
    last = measures.last_quarter(measures.decisions(trial, situation))
    if last.is_empty():
        return float("nan")
    wanted = last["appropriateness"].struct.unnest().to_numpy()
    values = last["q"].struct.unnest().to_numpy()
    right = wanted >= wanted.max(axis=1, keepdims=True) - 1e-9
    best = values >= values.max(axis=1, keepdims=True) - 1e-9
    return float(((right & best).sum(axis=1) / best.sum(axis=1)).mean())


def ordered(trial: pl.DataFrame, situation: str | None) -> bool:
    """Returns whether a behavior that is right ends with the highest Q-value."""
    last = measures.decisions(trial, situation).tail(1)
    values = measures.final_q(trial, situation)
    if last.is_empty():
        return False
    wanted: dict[str, float] = last["appropriateness"][0]
    best = max(wanted.values()) - 1e-9
    wrong = [values[name] for name, worth in wanted.items() if worth < best]
    right = [values[name] for name, worth in wanted.items() if worth >= best]
    return all(max(right) > value for value in wrong)


def right_share(trial: pl.DataFrame, situation: str | None) -> float:
    """Returns the share of appropriate choices in the last quarter of a situation's."""
    last = measures.last_quarter(measures.decisions(trial, situation))
    return float(measures.appropriate(last).mean()) if len(last) else float("nan")


def silent_loss(trial: pl.DataFrame, situation: str | None, behavior: str) -> float:
    """Returns which share of its value a behavior loses by a choice without a touch.

    Over all choices of the behavior in the situation at which its value was positive
    and during which nobody touched the robot: the sum of what the value then lost,
    divided by the sum of the values (so that values near 0 do not count much).
    """
    chosen = measures.decisions(trial, situation).filter(
        (pl.col("behavior") == behavior) & (pl.col("touches").list.len() == 0)
    )
    before, after = own_values(chosen)
    known = before > 0
    if not known.any():
        return float("nan")
    return float((before - after)[known].sum() / before[known].sum())


def pull_fades(trial: pl.DataFrame) -> float:
    """Returns by how much touches move values less later on.

    The mean size of the change of a pair's value per touch felt during it, over the
    first half of the entries with a touch, minus that over the second half.
    """
    touched = trial.filter(pl.col("touches").list.len() > 0)
    if len(touched) < 2:
        return float("nan")
    before, after = own_values(touched)
    pulls = np.abs(after - before) / touched["touches"].list.len().to_numpy()
    half = len(pulls) // 2
    return float(pulls[:half].mean() - pulls[half:].mean())


def own_values(entries: pl.DataFrame) -> tuple[FloatArray, FloatArray]:
    """Returns each entry's Q-value of its own pair, before and after its end.

    Returns:
        Two arrays of shape (n_entries,).
    """
    before, after = np.empty(len(entries)), np.empty(len(entries))
    columns = entries.select("situation", "behavior", "q", "updates")
    for index, (situation, behavior, q, updates) in enumerate(columns.iter_rows()):
        before[index] = after[index] = q[behavior]
        for update in updates:
            if (update["situation"], update["behavior"]) == (situation, behavior):
                after[index] = update["value"]
    return before, after


def credit_accuracy(trial: pl.DataFrame, situation: str | None = None) -> float:
    """Returns the share of the touches credited to the pair that they are about.

    Args:
        trial: The table of a trial.
        situation: Counts only touches whose true cause lies there; None: all.
    """
    felt = measures.touches(trial)
    if situation is not None:
        felt = felt.filter(pl.col("cause_situation") == situation)
    if felt.is_empty():
        return float("nan")
    hit = felt.select(
        (pl.col("credited_situation") == pl.col("cause_situation"))
        & (pl.col("credited_behavior") == pl.col("cause_behavior"))
    )
    return float(hit.to_series().fill_null(value=False).to_numpy().mean())


def positive_share(trial: pl.DataFrame, begin: float, end: float) -> float:
    """Returns the share of caresses among the touches felt in [begin, end) [s]."""
    time = pl.col("time")
    felt = measures.touches(trial).filter((time >= begin) & (time < end))
    if felt.is_empty():
        return float("nan")
    return float((felt["value"].to_numpy() > 0).mean())
