"""What other processes do for the report while this one analyzes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import contextmanager
from functools import partial
from typing import TypeVar

from experiments.errors import ExperimentError
from experiments.running.engine import (
    Engine,
    ctrl_c_held_back,
    open_engine,
    result_of,
    run_trials,
)

R = TypeVar("R")


class Helpers:
    """Processes that are given tasks; what a dying one takes with it is done again.

    Args:
        executor: Where tasks run.
    """

    def __init__(self, executor: Executor) -> None:
        self._executor = executor

    def begin(
        self, what: str, task: Callable[..., R], *arguments: object
    ) -> Callable[[], R]:
        """Begins a task and does not wait for it.

        Args:
            what: What it makes, for messages.
            task: A module-level function; it may be run more than once.
            *arguments: What it takes.

        Returns:
            Waits for what the task returns.
        """
        call = partial(task, *arguments)
        future = self._submitted(call)
        return lambda: _finished(future, call, what)

    def _submitted(self, call: Callable[[], R]) -> Future[R] | None:
        try:
            with ctrl_c_held_back():
                return self._executor.submit(call)
        except (BrokenExecutor, OSError, EOFError):  # a worker has just died
            return None


@contextmanager
def beside(engine: Engine | None = None) -> Iterator[Helpers]:
    """Has other processes work while a block runs; what is left over is ended.

    Args:
        engine: Where; None: a process on each core.
    """
    executor = (engine or open_engine()).open()
    try:
        yield Helpers(executor)
    finally:
        with ctrl_c_held_back():
            executor.shutdown(cancel_futures=True)


def _finished(future: Future[R] | None, call: Callable[[], R], what: str) -> R:
    if future is not None:
        try:
            return result_of(future)
        except BrokenExecutor:
            pass
    (outcome,) = run_trials(_called, [call], open_engine(workers=1))
    if isinstance(outcome.error, BrokenExecutor):
        raise ExperimentError(
            f"{what}: the process that makes it dies each time ({outcome.error}). Is "
            "there too little memory?"
        ) from outcome.error
    if outcome.error is not None:
        raise outcome.error
    assert outcome.value is not None
    return outcome.value


def _called(call: Callable[[], R]) -> R:
    return call()
