"""Says at least every few seconds what a long run is doing, also in a log."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

SILENT = 2.5
"""How long nothing is said at most [s]."""

Say = Callable[[str], None]


@contextmanager
def pulse(console: Console, first: str) -> Iterator[Say]:
    """Tells what is being done while a block runs, and for how long.

    Args:
        console: Where to: a line that moves in a terminal; plain lines anywhere else.
        first: What is done first, in a few words.

    Yields:
        A function to be told what is done now.
    """
    teller = _Teller(console, first)
    if console.is_terminal:
        with console.status(first) as status, teller.running(status.update, 0.5):
            yield teller.say
    else:
        console.print(first)
        with teller.running(console.print, SILENT):
            yield teller.say


class _Teller:
    """What is being done, and since when."""

    def __init__(self, console: Console, first: str) -> None:
        self._console, self._doing, self._since = console, first, time.monotonic()

    def say(self, doing: str) -> None:
        """Notes what is done now, and says so where lines stay."""
        self._doing, self._since = doing, time.monotonic()
        if not self._console.is_terminal:
            self._console.print(doing)

    @contextmanager
    def running(self, show: Say, every: float) -> Iterator[None]:
        """Shows it again and again, with the time that it has taken."""
        over = threading.Event()

        def repeat() -> None:
            while not over.wait(every):
                show(f"{self._doing} ({time.monotonic() - self._since:.0f} s)")

        thread = threading.Thread(target=repeat, name="pulse", daemon=True)
        thread.start()
        try:
            yield
        finally:
            over.set()
            thread.join()
