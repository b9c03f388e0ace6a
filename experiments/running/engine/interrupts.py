"""Ctrl-C at moments of our choice.

Python raises `KeyboardInterrupt` between any two instructions of the main thread. Where
it falls between taking one of the standard library's locks and being ready to give it
back, the lock stays taken, the thread that manages a pool waits for it, and the program
never ends. So executors are handed work and shut down while Ctrl-C is held back, and
what has finished is awaited in a `SimpleQueue`, which has no such moments.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from queue import Empty, SimpleQueue
from types import FrameType
from typing import Any, TypeVar

R = TypeVar("R")

AWAKE = 0.5
"""How long to wait at a stretch [s]. The system may hand Ctrl-C to any thread; the main
thread notices only when it wakes up."""


@contextmanager
def ctrl_c_held_back() -> Iterator[None]:
    """Lets Ctrl-C take effect only at the end of the block."""
    handler = signal.getsignal(signal.SIGINT)
    in_main_thread = threading.current_thread() is threading.main_thread()
    if not (in_main_thread and callable(handler)):  # nothing would be raised here
        yield
        return
    held: list[tuple[int, FrameType | None]] = []
    signal.signal(signal.SIGINT, lambda number, frame: held.append((number, frame)))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)
        if held:
            handler(*held[0])


class Finished:
    """Futures in the order in which they finish."""

    def __init__(self) -> None:
        self._done: SimpleQueue[Future[Any]] = SimpleQueue()

    def watch(self, future: Future[Any]) -> None:
        """Has a future come out of `get` when it is done."""
        with ctrl_c_held_back():
            future.add_done_callback(self._done.put)

    def get(self) -> Future[Any]:
        """Waits for the next one."""
        while True:
            try:
                return self._done.get(timeout=AWAKE)
            except Empty:
                continue


def result_of(future: Future[R]) -> R:
    """Waits as `Future.result` does, and Ctrl-C may come at any moment."""
    finished = Finished()
    finished.watch(future)
    finished.get()
    return future.result()
