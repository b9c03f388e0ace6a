"""Where results lie: one directory per study, one Parquet file per finished trial.

    DIR/study.json                            what was run, with what, by which versions
    DIR/trials/CONDITION/seed_0007.parquet    one finished trial
    DIR/trials/CONDITION/seed_0007.error.txt  the traceback of one that failed

A file is written under a temporary name, brought to the disk and renamed, so what has
its final name is whole, whenever the program is killed.
"""

from __future__ import annotations

import hashlib
import platform
import subprocess
import traceback
from collections.abc import Iterable, Sequence
from functools import cache, cached_property
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from experiments.errors import ExperimentError
from experiments.running.files import (
    make_directory,
    remove_remains,
    to_json,
    write_text,
    write_whole,
)
from experiments.running.study import Study, Trial
from experiments.running.study_files import first_difference, read_study_file
from experiments.running.trial_files import (
    FORMAT,
    Identity,
    arrow_table,
    encoded,
    fault_of,
)

if TYPE_CHECKING:
    import polars
    import pyarrow

_PACKAGES = (
    "polite-household",
    "gymnasium",
    "numba",
    "numpy",
    "pettingzoo",
    "polars",
    "pymunk",
    "scipy",
    "stable-baselines3",
    "torch",
)


BLOCK = 1_000
"""So many trials are read at a time: what Arrow holds of small files is ten times their
size."""


class Results:
    """The directory of one study."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory

    @property
    def study_file(self) -> Path:
        """The file that says what was run."""
        return self.directory / "study.json"

    def prepare(self, study: Study, configuration: object) -> None:
        """Makes the directory ready for a study, or for going on with it.

        Args:
            study: What will be run.
            configuration: Plain data that fixes every result but the seeds.

        Raises:
            ExperimentError: If the directory cannot be used, or holds results of
                another configuration. Nothing stored is touched then.
        """
        stored = self.check(configuration)
        session = {"versions": versions(), "commit": commit()}
        sessions = list(stored["sessions"]) if stored else []
        if session not in sessions:
            sessions.append(session)
        document = {
            "format": FORMAT,
            "study": study.name,
            "seeds": list(study.seeds),
            "sessions": sessions,
            "configuration": configuration,
        }
        make_directory(self.directory)
        remove_remains(self.directory)
        write_text(self.study_file, to_json(document))

    def check(self, configuration: object) -> dict[str, Any] | None:
        """Returns what `study.json` holds, None without one; changes nothing.

        Raises:
            ExperimentError: If it is damaged or has another configuration.
        """
        if not self.study_file.exists():
            return None
        stored = self.read_study()
        difference = first_difference(stored["configuration"], _plain(configuration))
        if difference:
            raise ExperimentError(
                f"{self.study_file}: holds results of another configuration "
                f"({difference}). Choose another --out, or delete {self.directory}."
            )
        return stored

    def read_study(self) -> dict[str, Any]:
        """Returns the content of `study.json`.

        Raises:
            ExperimentError: If it is missing, damaged or of another format.
        """
        return read_study_file(self.study_file)

    def file(self, trial: Trial) -> Path:
        """Returns where a finished trial lies."""
        folder = self.directory / "trials" / trial.condition.name
        return folder / f"seed_{trial.seed:04d}.parquet"

    def fault(self, trial: Trial) -> str | None:
        """Returns why a trial has no usable result, in one line; None if it has."""
        path = self.file(trial)
        if not path.exists():
            return f"{path}: missing"
        fault = fault_of(path, self.identity(trial))
        return fault and f"{path}: {fault}"

    def missing(self, trials: Iterable[Trial]) -> tuple[Trial, ...]:
        """Returns the trials that have no result yet, or none that can be used."""
        return tuple(trial for trial in trials if self.fault(trial))

    def write(self, trial: Trial, frame: polars.DataFrame) -> None:
        """Stores one finished trial.

        Raises:
            ExperimentError: If the disk is full.
        """
        path = self.file(trial)
        content = encoded(frame, self.identity(trial))
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, lambda temporary: temporary.write_bytes(content))
        self._error_file(trial).unlink(missing_ok=True)

    def identity(self, trial: Trial) -> Identity:
        """Returns what a trial's file says it is."""
        study, configuration = self._known
        return Identity(
            study=study,
            configuration=configuration,
            condition=trial.condition.name,
            seed=trial.seed,
        )

    @cached_property
    def _known(self) -> tuple[str, str]:
        """The study's name, and a digest of its configuration."""
        stored = self.read_study()
        configuration = msgspec.json.encode(stored["configuration"])
        return stored["study"], hashlib.sha256(configuration).hexdigest()

    def write_error(self, trial: Trial, error: BaseException) -> Path:
        """Stores the traceback of a trial that failed and returns where."""
        path = self._error_file(trial)
        path.parent.mkdir(parents=True, exist_ok=True)
        write_text(path, "".join(traceback.format_exception(error)))
        return path

    def _error_file(self, trial: Trial) -> Path:
        return self.file(trial).with_suffix(".error.txt")

    def read(self, study: Study) -> polars.DataFrame:
        """Returns every finished trial of a study in one frame.

        The first columns are `condition` and `seed`, then the condition's factors.

        Raises:
            ExperimentError: If a trial is missing or damaged.
        """
        import polars as pl

        trials = study.trials()
        absent = [trial for trial in trials if not self.file(trial).exists()]
        if absent:
            raise ExperimentError(
                f"{self.directory}: {len(absent)} of {len(trials)} trials are "
                f"missing, e.g. {absent[0]}; run the same command again to add them."
            )
        first = self._arrow(trials[0], study.columns).schema
        return pl.concat(
            self._block(trials[at : at + BLOCK], study.columns, first)
            for at in range(0, len(trials), BLOCK)
        )

    def _block(
        self, trials: Sequence[Trial], columns: Sequence[str], schema: pyarrow.Schema
    ) -> polars.DataFrame:
        """Returns some trials in one frame, which is made only once for all of them."""
        import polars as pl
        import pyarrow as pa

        tables = []
        for trial in trials:
            tables.append(self._arrow(trial, columns))
            if not tables[-1].schema.equals(schema):
                raise ExperimentError(
                    f"{self.file(trial)}: its columns are other than those of the "
                    "first trial. Delete one of them, and run it again."
                )
        rows = [table.num_rows for table in tables]
        whole = pl.DataFrame(pa.concat_tables(tables))
        return pl.concat([_labels(trials, rows), whole], how="horizontal")

    def table(self, trial: Trial, columns: Sequence[str] = ()) -> polars.DataFrame:
        """Returns a trial's table, which has these columns and perhaps others.

        Raises:
            ExperimentError: If it is missing or damaged.
        """
        import polars as pl

        return pl.DataFrame(self._arrow(trial, columns))

    def _arrow(self, trial: Trial, columns: Sequence[str]) -> pyarrow.Table:
        path = self.file(trial)
        table = arrow_table(path, self.identity(trial))
        lacking = [name for name in columns if name not in table.column_names]
        if lacking:
            raise ExperimentError(f"{path}: has no column {lacking[0]!r}. Delete it.")
        return table


def _labels(trials: Sequence[Trial], rows: Sequence[int]) -> polars.DataFrame:
    """Which trial each row is of: its condition, its seed and its factors."""
    import numpy as np
    import polars as pl

    named = [
        {
            "condition": trial.condition.name,
            "seed": trial.seed,
            **trial.condition.factors,
        }
        for trial in trials
    ]
    schema = dict.fromkeys(named[0], pl.String) | {"seed": pl.Int32}
    each = pl.DataFrame(named, schema_overrides=schema, infer_schema_length=None)
    return each[np.repeat(np.arange(len(rows)), rows)]


def versions() -> dict[str, str]:
    """Returns the versions of Python and of the packages that results depend on."""
    found = {"python": platform.python_version()}
    for package in _PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "not installed"
    return found


@cache
def commit() -> str | None:
    """Returns the git commit this code is at, `+` if it was changed, None if none."""
    here = Path(__file__).parent

    def git(*arguments: str) -> str:
        return subprocess.run(
            ["git", "-C", str(here), *arguments],
            capture_output=True,
            check=True,
            text=True,
        ).stdout.strip()

    try:
        return git("rev-parse", "HEAD") + ("+" if git("status", "--porcelain") else "")
    except (OSError, subprocess.CalledProcessError):
        return None


def _plain(configuration: object) -> object:
    """Returns the configuration as it will be read back from JSON."""
    return msgspec.json.decode(msgspec.json.encode(configuration))
