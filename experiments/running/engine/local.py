"""Processes on this machine that never outlive the program that started them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from typing import TypeVar

from experiments.threads import one_thread

T = TypeVar("T")

ENDS_WITHIN = 5.0
"""How long the pool's own thread may take to notice that its workers are gone [s]."""


class LocalExecutor(ProcessPoolExecutor):
    """A process pool that can be left at once: `shutdown` ends what still runs.

    The standard library's pool waits for the running tasks, also after Ctrl-C.
    """

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the pool; with `cancel_futures` running tasks are ended as well."""
        # `terminate_workers` is public only from Python 3.14 on.
        processes = list((getattr(self, "_processes", None) or {}).values())
        manager = getattr(self, "_executor_manager_thread", None)
        super().shutdown(wait and not cancel_futures, cancel_futures=cancel_futures)
        if cancel_futures:
            for process in processes:
                process.terminate()
            for process in processes:
                process.join()
            if manager is not None:
                # Else it closes its pipe while the ending interpreter writes to it.
                manager.join(ENDS_WITHIN)


class Here(Executor):
    """No other process: a task runs in this one, as soon as it is submitted."""

    def submit(
        self, fn: Callable[..., T], /, *args: object, **kwargs: object
    ) -> Future[T]:
        """Runs a task to its end."""
        future: Future[T] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def local_executor(workers: int) -> Executor:
    """Returns a pool of `workers` fresh processes (never forks of this one)."""
    if sys.platform == "win32":
        method = "spawn"
    else:
        method = "forkserver"
        _start_server()
    return LocalExecutor(
        workers,
        mp_context=multiprocessing.get_context(method),
        initializer=_start_worker,
    )


def _start_server() -> None:
    """Starts what forks the workers, deaf to Ctrl-C from its first instruction on.

    Workers inherit that: `_start_worker` comes only after all their imports.
    """
    from multiprocessing import forkserver, resource_tracker  # not on Windows

    resource_tracker.ensure_running()  # started below, it would end the deafness
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        forkserver.ensure_running()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _start_worker() -> None:
    """Leaves Ctrl-C to the parent, and ends this process when the parent is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    one_thread()
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """Waits for the parent's end: a killed parent cannot stop its workers itself."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
