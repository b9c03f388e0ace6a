"""Draws all figures of an experiment, in a process of its own beside the analysis."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from experiments import figures
from experiments.errors import ExperimentError
from experiments.paper import EXPERIMENTS, Experiment, comparison
from experiments.report.records import DrawnFigure
from experiments.running.engine import (
    ctrl_c_held_back,
    open_engine,
    result_of,
    run_trials,
)
from experiments.running.store import Results
from experiments.running.study import Study

Figures = tuple[DrawnFigure, ...]

FiguresOf = Callable[[int], Figures]
"""Waits for the figures of an experiment, by its number."""


@contextmanager
def drawing(numbers: Sequence[int], out: Path) -> Iterator[FiguresOf]:
    """Has other processes draw the figures of experiments while a block runs.

    Args:
        numbers: Of the experiments.
        out: The directory of all results.

    Yields:
        Waits for the figures of one of them. What a dying process takes with it is
        drawn again.
    """
    executor = open_engine().open()
    try:
        drawn = {number: _begun(executor, number, out) for number in numbers}
        yield lambda number: _finished(drawn[number], number, out)
    finally:
        with ctrl_c_held_back():
            executor.shutdown(cancel_futures=True)


def _begun(executor: Executor, number: int, out: Path) -> Future[Figures] | None:
    try:
        with ctrl_c_held_back():
            return executor.submit(draw, number, out)
    except (BrokenExecutor, OSError, EOFError):  # a worker has just died
        return None


def _finished(future: Future[Figures] | None, number: int, out: Path) -> Figures:
    if future is not None:
        try:
            return result_of(future)
        except BrokenExecutor:
            pass
    (outcome,) = run_trials(partial(draw, out=out), [number], open_engine(workers=1))
    if outcome.value is None:
        raise ExperimentError(
            f"figures of experiment {number}: the process that draws them dies each "
            f"time ({outcome.error}). Is there too little memory?"
        ) from outcome.error
    return outcome.value


def stored_study(experiment: Experiment, results: Results) -> Study:
    """Returns the study with the seeds that it was last prepared for."""
    return experiment.study(tuple(results.read_study()["seeds"]))


def draw(number: int, out: Path) -> Figures:
    """Draws the figures of a finished experiment into `figures`.

    Args:
        number: Of the experiment.
        out: The directory of all results.
    """
    experiment = EXPERIMENTS[number]
    results = Results(out / experiment.name)
    frame = results.read(stored_study(experiment, results))
    parts = [(f.name, f.caption, f.columns(frame)) for f in experiment.figures]
    compared = (
        "All conditions: the sum of all touches, and how many caresses and taps a "
        "minute brings."
    )
    name = f"{experiment.name}_rewards"
    parts.append((name, compared, comparison(experiment, frame)))
    return tuple(
        DrawnFigure(
            name=name,
            caption=caption,
            svgs=figures.inline(columns, name),
            files=figures.save(columns, out / "figures" / name),
        )
        for name, caption, columns in parts
    )
