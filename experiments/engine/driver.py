"""The loop that keeps an executor busy and survives dead workers.

Rules: a bounded number of trials in flight; results as they come, in any order; a
trial's own exception is reported, not tried again; when a worker dies, every trial in
flight is a suspect and is run again alone, so that the blame is certain; leaving the
loop in whatever way leaves no process behind.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass
from itertools import islice
from typing import Generic, TypeVar

from experiments.engine.engines import Engine

T = TypeVar("T")
R = TypeVar("R")

MAX_ATTEMPTS = 3
"""How often a trial that kills its worker is tried in all (our choice)."""

AWAKE = 0.5
"""How long to wait at a stretch [s]. The system may hand Ctrl-C to any thread; the main
thread notices only when it wakes up."""


@dataclass(frozen=True, kw_only=True)
class Outcome(Generic[T, R]):
    """What became of one trial: its value, or the error that ended it."""

    trial: T
    """The trial as it was handed in."""

    value: R | None = None
    """What it returned; None after an error."""

    error: BaseException | None = None
    """The trial's own exception, or `BrokenExecutor` if it kept killing its worker."""

    attempts: int = 1
    """How often it was started."""


@dataclass(frozen=True)
class _Attempt(Generic[T]):
    trial: T
    number: int = 1


def run_trials(
    run: Callable[[T], R], trials: Iterable[T], engine: Engine
) -> Iterator[Outcome[T, R]]:
    """Runs every trial and yields what became of it, in the order of finishing.

    Args:
        run: A module-level function of one trial, without effects of its own.
        trials: What to run; read lazily.
        engine: Where to run it, from `open_engine`.

    Yields:
        One outcome for each trial.
    """
    loop = _Loop(run, trials, engine)
    try:
        while loop.fill():
            yield from loop.collect()
    finally:
        loop.executor.shutdown(wait=False, cancel_futures=True)


class _Loop(Generic[T, R]):
    """What waits, what runs, and what is suspected of killing workers."""

    def __init__(
        self, run: Callable[[T], R], trials: Iterable[T], engine: Engine
    ) -> None:
        self._run = run
        self._engine = engine
        self._waiting = (_Attempt(trial) for trial in trials)
        self._suspects: deque[_Attempt[T]] = deque()
        self._live: dict[Future[R], _Attempt[T]] = {}
        self.executor: Executor = engine.open()

    def fill(self) -> bool:
        """Hands out trials up to the window; False once nothing is left to do."""
        if self._suspects and not self._live:
            # Alone, so that the blame is certain.
            self._submit(self._suspects.popleft())
        elif not self._suspects:
            room = self._engine.window - len(self._live)
            for attempt in islice(self._waiting, room):
                self._submit(attempt)
        return bool(self._live)

    def _submit(self, attempt: _Attempt[T]) -> None:
        try:
            future = self.executor.submit(self._run, attempt.trial)
        except BrokenExecutor:  # an idle worker died: nothing in flight is to blame
            self._reopen()
            future = self.executor.submit(self._run, attempt.trial)
        self._live[future] = attempt

    def _reopen(self) -> None:
        self.executor.shutdown(wait=False, cancel_futures=True)
        self.executor = self._engine.open()

    def collect(self) -> Iterator[Outcome[T, R]]:
        """Waits for a trial to finish and yields what has finished."""
        done: set[Future[R]] = set()
        while not done:
            done, _ = wait(self._live, AWAKE, FIRST_COMPLETED)
        if any(isinstance(_error(future), BrokenExecutor) for future in done):
            done, _ = wait(self._live)  # a broken pool ends every trial in flight
            self._reopen()
        for future in done:
            attempt = self._live.pop(future)
            outcome = _outcome(attempt, future)
            if isinstance(outcome.error, BrokenExecutor) and (
                attempt.number < MAX_ATTEMPTS
            ):
                self._suspects.append(_Attempt(attempt.trial, attempt.number + 1))
            else:
                yield outcome


def _outcome(attempt: _Attempt[T], future: Future[R]) -> Outcome[T, R]:
    error = _error(future)
    return Outcome(
        trial=attempt.trial,
        value=future.result() if error is None else None,
        error=error,
        attempts=attempt.number,
    )


def _error(future: Future[R]) -> BaseException | None:
    if future.cancelled():  # its executor went away before it was started
        return BrokenExecutor("the trial was cancelled")
    return future.exception()
