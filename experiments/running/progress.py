"""How far a long run is: a moving bar in a terminal, plain lines anywhere else."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING

from experiments.running.pulse import Say, pulse
from policies.learning import Home, LearningRobot, Observer

if TYPE_CHECKING:
    from rich.console import Console

Advance = Callable[[], None]
"""Says that one more is done."""

_LINES = 10
"""How many lines with a rate a run writes at most where there is no terminal."""


class Steps(Observer):
    """Counts an episode's steps.

    Args:
        advance: Called after each one.
    """

    def __init__(self, advance: Advance) -> None:
        self._advance = advance

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Counts one."""
        self._advance()


@contextmanager
def progress(console: Console, what: str, total: int) -> Iterator[Advance]:
    """Shows done, rate and time left while a block runs.

    Args:
        console: Where to.
        what: What is counted, e.g. "trials".
        total: How many there are.

    Yields:
        A function to be called after each one.
    """
    if console.is_terminal:
        with _bar(console, what, total) as advance:
            yield advance
    elif total:
        begin = f"0 of {total} {what}; the first run compiles, too"
        with pulse(console, begin) as say:
            yield _lines(say, what, total)
    else:
        yield lambda: None


@contextmanager
def _bar(console: Console, what: str, total: int) -> Iterator[Advance]:
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    columns = (
        BarColumn(bar_width=None),
        MofNCompleteColumn(),
        TextColumn(what),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
        TextColumn("left"),
    )
    begun = time.monotonic()
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=total, rate="starting, compiling")

        def advance() -> None:
            bar.advance(task)
            rate = bar.tasks[0].completed / _since(begun)
            bar.update(task, rate=f"{rate:.1f}/s")

        yield advance


def _since(begun: float) -> float:
    """Time that has passed [s]; never none, whatever the clock says."""
    return max(time.monotonic() - begun, 1e-9)


def _lines(say: Say, what: str, total: int) -> Advance:
    begun = time.monotonic()
    done = 0

    def advance() -> None:
        nonlocal done
        done += 1
        if done * _LINES // total > (done - 1) * _LINES // total:
            rate = done / _since(begun)
            left = (total - done) / rate
            say(f"{done} of {total} {what}, {rate:.1f}/s, {left:.0f} s left")

    return advance
