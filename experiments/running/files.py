"""Files that are whole as soon as they have their names, and room for them."""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Callable
from pathlib import Path

import msgspec

from experiments.errors import ExperimentError


def make_directory(directory: Path) -> None:
    """Makes a directory that can be written to.

    Raises:
        ExperimentError: If there is a file in the way, or it cannot be written to.
    """
    from household.errors import shown_path

    try:
        directory.mkdir(parents=True, exist_ok=True)
        probe = directory / f".writable.{os.getpid()}"
        probe.touch()
        probe.unlink()
    except (FileExistsError, NotADirectoryError) as error:
        raise ExperimentError(
            f"--out {shown_path(directory)}: is a file, must be a directory (existing "
            "or new)."
        ) from error
    except OSError as error:
        raise ExperimentError(
            f"--out {shown_path(directory)}: cannot be written to ({error.strerror})."
        ) from error


def remove_remains(directory: Path) -> None:
    """Removes what a killed run left unfinished, at or below a directory.

    Only who is alone there may do so (`experiments.running.lock`).
    """
    for remains in list(directory.rglob(".*.tmp")):
        if remains.is_dir():
            shutil.rmtree(remains, ignore_errors=True)
        else:
            remains.unlink(missing_ok=True)


def ask_for_space(directory: Path, need: float, what: str) -> None:
    """Refuses to begin what cannot be stored to its end.

    Args:
        directory: Where it will be stored; it is there.
        need: About so much [bytes].
        what: What needs it, for the message.

    Raises:
        ExperimentError: If there is less.
    """
    free = shutil.disk_usage(directory).free
    if free < need:
        raise ExperimentError(
            f"--out {directory}: {free / 1e6:.1f} MB are free, {what} needs about "
            f"{need / 1e6:.1f} MB. Make room or choose another directory."
        )


def write_whole(path: Path, write: Callable[[Path], object]) -> None:
    """Writes a file so that it is whole as soon as it has its name.

    Raises:
        ExperimentError: If the disk is full; the text names the file.
    """
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        write(temporary)
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        temporary.replace(path)
    except OSError as error:
        if error.errno in _FULL:
            raise _no_space(path, temporary) from error
        raise
    finally:
        temporary.unlink(missing_ok=True)


_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def _no_space(path: Path, temporary: Path) -> ExperimentError:
    written = temporary.stat().st_size if temporary.exists() else 0
    return ExperimentError(
        f"{path}: the disk is full (it needs more than {written} bytes). Make room and "
        "run the same command again: what is stored stays stored."
    )


def write_text(path: Path, text: str) -> None:
    """Writes a text file so that it is whole as soon as it has its name."""
    write_whole(path, lambda temporary: temporary.write_text(text, encoding="utf-8"))


def to_json(document: object) -> str:
    """Returns plain data as indented JSON; NaN becomes null."""
    return msgspec.json.format(msgspec.json.encode(document), indent=2).decode() + "\n"
