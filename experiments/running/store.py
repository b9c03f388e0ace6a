"""Where results lie: one directory per study, one Parquet file per finished trial.

    DIR/study.json                            what was run, with what, by which versions
    DIR/trials/CONDITION/seed_0007.parquet    one finished trial
    DIR/trials/CONDITION/seed_0007.error.txt  the traceback of one that failed

A file is written under a temporary name, brought to the disk and renamed, so what has
its final name is whole, whenever the program is killed.
"""

from __future__ import annotations

import os
import platform
import subprocess
import traceback
from collections.abc import Callable, Iterable
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from experiments.errors import ExperimentError
from experiments.running.study import Study, Trial

if TYPE_CHECKING:
    import polars

FORMAT = 2
"""Version of what is stored; results of another version are refused, never converted.

1: situations were text alone. 2: roles, attention and factors are columns.
"""

_PACKAGES = (
    "polite-household",
    "gymnasium",
    "numba",
    "numpy",
    "pettingzoo",
    "polars",
    "pymunk",
    "scipy",
)


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
        for remains in self.directory.rglob(".*.tmp"):  # of a run that was killed
            remains.unlink(missing_ok=True)
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
        try:
            document = msgspec.json.decode(self.study_file.read_bytes(), type=dict)
        except OSError as error:
            raise ExperimentError(f"{self.study_file}: {error.strerror}.") from error
        except msgspec.DecodeError as error:
            raise ExperimentError(f"{self.study_file}: damaged ({error}).") from error
        if document.get("format") != FORMAT:
            raise ExperimentError(
                f"{self.study_file}: holds results in format "
                f"{document.get('format')!r}, this version reads format {FORMAT}. "
                f"Choose another --out, or delete {self.directory}, and run it again."
            )
        return document

    def file(self, trial: Trial) -> Path:
        """Returns where a finished trial lies."""
        folder = self.directory / "trials" / trial.condition.name
        return folder / f"seed_{trial.seed:04d}.parquet"

    def missing(self, trials: Iterable[Trial]) -> tuple[Trial, ...]:
        """Returns the trials that have no result yet."""
        return tuple(trial for trial in trials if not self.file(trial).exists())

    def write(self, trial: Trial, frame: polars.DataFrame) -> None:
        """Stores one finished trial."""
        path = self.file(trial)
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, lambda temporary: frame.write_parquet(temporary))
        self._error_file(trial).unlink(missing_ok=True)

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

        missing = self.missing(study.trials())
        if missing:
            raise ExperimentError(
                f"{self.directory}: {len(missing)} of {len(study.trials())} trials are "
                f"missing, e.g. {missing[0]}; run `household reproduce` to add them."
            )
        return pl.concat(
            _read_trial(self.file(trial)).select(
                pl.lit(trial.condition.name).alias("condition"),
                pl.lit(trial.seed).alias("seed"),
                *(
                    pl.lit(level).alias(factor)
                    for factor, level in trial.condition.factors.items()
                ),
                pl.all(),
            )
            for trial in study.trials()
        )


def _read_trial(path: Path) -> polars.DataFrame:
    import polars as pl

    try:
        return pl.read_parquet(path)
    except pl.exceptions.PolarsError as error:
        raise ExperimentError(
            f"{path}: damaged ({error}). Delete it, and `household reproduce` runs "
            "that trial again."
        ) from error


def make_directory(directory: Path) -> None:
    """Makes a directory that can be written to.

    Raises:
        ExperimentError: If there is a file in the way, or it cannot be written to.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
        probe = directory / f".writable.{os.getpid()}"
        probe.touch()
        probe.unlink()
    except (FileExistsError, NotADirectoryError) as error:
        raise ExperimentError(
            f"--out {directory}: is a file, must be a directory (existing or new)."
        ) from error
    except OSError as error:
        raise ExperimentError(
            f"--out {directory}: cannot be written to ({error.strerror})."
        ) from error


def write_whole(path: Path, write: Callable[[Path], object]) -> None:
    """Writes a file so that it is whole as soon as it has its name."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        write(temporary)
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def write_text(path: Path, text: str) -> None:
    """Writes a text file so that it is whole as soon as it has its name."""
    write_whole(path, lambda temporary: temporary.write_text(text, encoding="utf-8"))


def to_json(document: object) -> str:
    """Returns plain data as indented JSON; NaN becomes null."""
    return msgspec.json.format(msgspec.json.encode(document), indent=2).decode() + "\n"


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


def first_difference(stored: object, asked: object, path: str = "") -> str | None:
    """Returns where two pieces of plain data first differ, in words, or None."""
    if isinstance(stored, dict) and isinstance(asked, dict):
        for key in [*stored, *(key for key in asked if key not in stored)]:
            inner = f"{path}.{key}" if path else str(key)
            found = first_difference(stored.get(key), asked.get(key), inner)
            if found:
                return found
        return None
    if (
        isinstance(stored, list)
        and isinstance(asked, list)
        and len(stored) == len(asked)
    ):
        for index, (one, other) in enumerate(zip(stored, asked, strict=True)):
            found = first_difference(one, other, f"{path}[{index}]")
            if found:
                return found
        return None
    if stored == asked:
        return None
    return f"{path}: stored {_short(stored)}, asked for {_short(asked)}"


def _short(value: object, length: int = 60) -> str:
    text = msgspec.json.encode(value).decode()
    return text if len(text) <= length else text[: length - 3] + "..."


def _plain(configuration: object) -> object:
    """Returns the configuration as it will be read back from JSON."""
    return msgspec.json.decode(msgspec.json.encode(configuration))
