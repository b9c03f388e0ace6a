"""One command at a time in a directory of results.

Two would run the same trials twice and take each other's unfinished files for remains.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from experiments.errors import ExperimentError
from experiments.running.files import make_directory

NAME = ".lock"


@contextmanager
def alone_in(directory: Path) -> Iterator[None]:
    """Keeps others out of a directory while a block runs.

    The system gives the lock back when this process ends, however it ends.

    Args:
        directory: It is made if necessary.

    Raises:
        ExperimentError: If another command is at work there.
    """
    make_directory(directory)
    path = directory / NAME
    file = _locked(path)
    try:
        yield
    finally:
        path.unlink(missing_ok=True)
        os.close(file)


def _locked(path: Path) -> int:
    """Opens a file and locks it; not one that its holder has just removed."""
    while True:
        file = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        if not _lock(file):
            os.close(file)
            raise ExperimentError(
                f"--out {path.parent}: another command is at work there. Wait until it "
                "has ended, or choose another directory."
            )
        if _is_at(path, file):
            return file
        os.close(file)


def _lock(file: int) -> bool:
    if sys.platform == "win32":  # It has no such locks; there, users take care.
        return True
    import fcntl

    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _is_at(path: Path, file: int) -> bool:
    try:
        return os.path.samestat(path.stat(), os.fstat(file))
    except FileNotFoundError:
        return False
