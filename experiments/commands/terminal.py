"""Where commands write to."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console


def new_console() -> Console:
    """Returns a console on stdout; plain lines where that is no terminal."""
    from rich.console import Console

    return Console(highlight=False)
