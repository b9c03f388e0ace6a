"""The loop that keeps an executor busy and survives dead workers.

Rules: a bounded number of trials in flight; results as they come, in any order; a
trial's own exception is reported, not tried again; when a worker dies, every trial in
flight is a suspect and is run again alone, so that the blame is certain; leaving the
loop in whatever way leaves no process behind.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future
from dataclasses import dataclass
from itertools import islice
from typing import Generic, TypeVar

from experiments.running.engine.engines import Engine
from experiments.running.engine.interrupts import Finished, ctrl_c_held_back

T = TypeVar("T")
R = TypeVar("R")

MAX_ATTEMPTS = 3
"""How often a trial that kills its worker is tried in all (our choice)."""

MAX_REOPENED = 3
"""How many executors may break in a row before a trial is even handed out."""


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
        loop.close()


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
        self._finished = Finished()
        self._executor: Executor = engine.open()

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
        with ctrl_c_held_back():
            future = self._hand_out(attempt.trial)
        self._live[future] = attempt
        self._finished.watch(future)

    def _hand_out(self, trial: T) -> Future[R]:
        """Submits a trial; opens another executor if this one has broken meanwhile."""
        for _ in range(MAX_REOPENED):
            try:
                return self._executor.submit(self._run, trial)
            except (BrokenExecutor, OSError, EOFError):
                # A worker died while idle, or just now: a pool that is taking itself
                # down closes the pipes that a worker being started is handed.
                # Suspects in flight come back from `collect`; this trial is none.
                self._reopen()
        return self._executor.submit(self._run, trial)

    def _reopen(self) -> None:
        self.close()
        self._executor = self._engine.open()

    def close(self) -> None:
        """Ends what still runs."""
        with ctrl_c_held_back():
            self._executor.shutdown(wait=False, cancel_futures=True)

    def collect(self) -> Iterator[Outcome[T, R]]:
        """Waits for a trial to finish and yields what has finished."""
        done = [self._finished.get()]
        if isinstance(_error(done[0]), BrokenExecutor):
            # A broken pool ends every trial in flight.
            done += [self._finished.get() for _ in range(len(self._live) - 1)]
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
