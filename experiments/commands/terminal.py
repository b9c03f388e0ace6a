"""Where commands write to."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

PREPARING = "Preparing the homes; the first run compiles"
"""What is said while directories and scenarios of studies are made ready."""


def new_console() -> Console:
    """Returns a console on stdout; plain lines where that is no terminal.

    What stdout's encoding lacks (a check mark in Latin-1) is shown as a question mark.
    Square brackets and colons are what they are: paths may hold them. When nobody reads
    any more (`| head -1`), the work goes on, in silence.
    """
    import io
    import os
    import sys

    from rich.console import Console

    class Unread(Console):
        """Does not end the program where its output goes nowhere."""

        def on_broken_pipe(self) -> None:
            self.quiet = True
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, sys.stdout.fileno())
            os.close(nowhere)

    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    return Unread(highlight=False, markup=False, emoji=False)
