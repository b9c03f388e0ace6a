"""Stored studies, checked from end to end."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from experiments.errors import ExperimentError
from experiments.running.store import Results
from experiments.running.study import Condition, Trial
from experiments.running.trial_files import decoded

STUDY_FILE = "study.json"

MOST = 100
"""Faults that are told; who mends so many checks again."""


def studies_at(path: Path) -> tuple[Results, ...]:
    """Returns every study at or below a path.

    Args:
        path: A study file, or a directory of results.

    Raises:
        ExperimentError: If there is none.
    """
    files = [path] if path.is_file() else sorted(path.rglob(STUDY_FILE))
    if not files:
        raise ExperimentError(f"{path}: no {STUDY_FILE} there.")
    return tuple(Results(file.parent) for file in files)


def faults_of(studies: tuple[Results, ...]) -> tuple[str, ...]:
    """Returns all that is wrong with studies, one line each; reads every trial.

    Args:
        studies: From `studies_at`.
    """
    found = list(islice(_faults(studies), MOST + 1))
    if len(found) > MOST:
        found[MOST] = "and more; mend these first"
    return tuple(" ".join(fault.split()) for fault in found)


def size_of(studies: tuple[Results, ...]) -> str:
    """Returns how much there is in faultless studies, in a few words."""
    trials = sum(len(_trials(results)) for results in studies)
    return f"studies: {len(studies)}, trials: {trials}"


def _faults(studies: tuple[Results, ...]) -> Iterator[str]:
    for results in studies:
        try:
            trials = _trials(results)
        except ExperimentError as error:
            yield str(error)
            continue
        missing = [trial for trial in trials if not results.file(trial).exists()]
        if missing:
            yield (
                f"{results.directory}: {len(missing)} of {len(trials)} trials are "
                f"missing, e.g. {missing[0]}"
            )
        for trial in trials:
            if trial not in missing:
                yield from _fault(results, trial)


def _fault(results: Results, trial: Trial) -> Iterator[str]:
    try:
        decoded(results.file(trial), results.identity(trial))
    except ExperimentError as error:
        yield str(error)


def _trials(results: Results) -> list[Trial]:
    """The trials of a study by what its file says, whatever this version would run."""
    document = results.read_study()
    named = document["configuration"].get("conditions", {})
    if not isinstance(named, dict):
        raise ExperimentError(f"{results.study_file}: damaged (no conditions).")
    try:
        conditions = [Condition(name=n, scenario="", learner="") for n in named]
    except ExperimentError as error:
        raise ExperimentError(f"{results.study_file}: {error}") from error
    return [
        Trial(condition=condition, seed=seed)
        for seed in document["seeds"]
        for condition in conditions
    ]
