"""Runs studies: what is missing, and nothing twice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.errors import ExperimentError
from experiments.running.engine import Engine, Outcome, open_engine, run_trials
from experiments.running.files import ask_for_space
from experiments.running.store import Results
from experiments.running.study import Study, Trial
from experiments.running.trial import configuration

if TYPE_CHECKING:
    import polars


SPACE, SPACE_PER_TRIAL = 6e7, 1e5
"""What figures, report, replays and their viewer take, and what a trial's table takes
[bytes]; about twice what those of the paper take."""


@dataclass(frozen=True, kw_only=True)
class Job:
    """One trial with the place its result belongs to."""

    results: Results
    """The directory of its study."""

    trial: Trial
    """What to run."""

    run: Callable[..., polars.DataFrame]
    """How to run it."""

    start: tuple[Results, Trial] | None = None
    """A stored trial that it starts from, whose table `run` gets as well."""


def prepare(studies: Sequence[Study], out: Path) -> tuple[Job, ...]:
    """Makes directories ready and returns what is still to be run.

    Args:
        studies: What is to be run.
        out: The directory that gets a directory for each study.

    Raises:
        ExperimentError: If the directory cannot be used or holds other results; all
            studies are checked before the first is written to.
        HouseholdError: If a study's scenario cannot be used.
    """
    wanted = [(study, Results(out / study.name)) for study in studies]
    configurations = [configuration(study) for study in studies]
    for (_, results), asked in zip(wanted, configurations, strict=True):
        results.check(asked)
    for (study, results), asked in zip(wanted, configurations, strict=True):
        results.prepare(study, asked)
    jobs = tuple(job for study in studies for job in missing(study, out))
    if jobs:
        need = SPACE + SPACE_PER_TRIAL * len(jobs)
        ask_for_space(out, need, f"the result of {len(jobs)} trials")
    return jobs


def missing(study: Study, out: Path) -> tuple[Job, ...]:
    """Returns what is still to be run of a study; changes nothing.

    Args:
        study: What is wanted.
        out: The directory that holds the directory of the study.
    """
    results, trials = Results(out / study.name), study.trials()
    known = results.study_file.exists()
    return tuple(
        Job(
            results=results,
            trial=trial,
            run=study.run,
            start=study.start and _start(study.start(trial), out),
        )
        for trial in (results.missing(trials) if known else trials)
    )


def run(jobs: Sequence[Job], engine: Engine, advance: Callable[[], None]) -> None:
    """Runs jobs and stores each result as it comes.

    Args:
        jobs: From `prepare`.
        engine: Where to run them.
        advance: Called after each one.

    Raises:
        ExperimentError: At the end, if some trials failed; the others are stored.
    """
    failed: list[str] = []
    for outcome in run_trials(_run, map(_begun, jobs), engine):
        failed += _store(outcome)
        advance()
    if failed:
        raise ExperimentError(
            f"{len(failed)} of {len(jobs)} trials failed, the others are stored. "
            f"First: {failed[0]}."
        )


def run_study(study: Study, out: Path | str, engine: str = "here") -> polars.DataFrame:
    """Runs what is still missing of a study, and returns its table.

    Args:
        study: What to run.
        out: The directory that gets a directory for the study.
        engine: Where to run trials, see `open_engine`. With any but `here`, the
            program that calls this needs a guard of its main module.

    Returns:
        The tables of all trials, with the columns `condition` and `seed`.

    Raises:
        ExperimentError: If the directory cannot be used or holds other results, or some
            trials failed; the others are stored.
        HouseholdError: If the study's scenario cannot be used.
    """
    jobs = prepare((study,), Path(out))
    run(jobs, open_engine(engine), lambda: None)
    return Results(Path(out) / study.name).read(study)


def _start(start: tuple[str, Trial] | None, out: Path) -> tuple[Results, Trial] | None:
    return None if start is None else (Results(out / start[0]), start[1])


def _begun(job: Job) -> tuple[Job, polars.DataFrame | None]:
    """Reads what a job starts from, only now: not all of it is ever in memory."""
    if job.start is None:
        return job, None
    results, trial = job.start
    return job, results.table(trial)


def _run(begun: tuple[Job, polars.DataFrame | None]) -> polars.DataFrame:
    job, table = begun
    return job.run(job.trial) if table is None else job.run(job.trial, table)


def _store(
    outcome: Outcome[tuple[Job, polars.DataFrame | None], polars.DataFrame],
) -> list[str]:
    """Stores a result; returns what failed if there is none."""
    job, _ = outcome.trial
    results, trial = job.results, job.trial
    if outcome.value is not None and not outcome.value.is_empty():
        results.write(trial, outcome.value)
        return []
    error = outcome.error or RuntimeError("the trial's table is empty")
    path = results.write_error(trial, error)
    reason = str(error).strip().partition("\n")[0]
    return [f"{trial}: {type(error).__name__}: {reason} (traceback in {path})"]
