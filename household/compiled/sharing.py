"""Sharing the compiler: processes that start together do not compile the same."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


class Later:
    """A function that another process is compiling: got when it is first called.

    Meanwhile this process goes on, usually by compiling what nobody has begun.

    Args:
        get: Waits for the function.
    """

    def __init__(self, get: Callable[[], Callable[..., Any]]) -> None:
        self._get = get
        self._found: Callable[..., Any] | None = None

    def __call__(self, *arguments: Any) -> Any:  # noqa: ANN401 - the function's own
        """Calls the function, once it is there."""
        if self._found is None:
            self._found = self._get()
        return self._found(*arguments)


@contextmanager
def turn_at(path: Path | None, *, wait: bool) -> Iterator[bool]:
    """Has one process at a time do something; the system ends the turn of a dead one.

    Args:
        path: A file that stands for what is done. Where it cannot be written, and where
            there are no such locks, everybody may do it at the same time.
        wait: For the end of somebody else's turn.

    Yields:
        Whether it is this process's turn; always if it waits.
    """
    file = _opened(path)
    try:
        yield file is None or _locked(file, wait)
    finally:
        if file is not None:
            os.close(file)


def _opened(path: Path | None) -> int | None:
    if path is None or sys.platform == "win32":
        return None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        return os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError:
        return None


def _locked(file: int, wait: bool) -> bool:
    import fcntl

    try:
        fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
    except BlockingIOError:
        return False
    except OSError:  # Some network drives have no locks.
        return True
    return True
