"""`household validate`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.commands.terminal import new_console

if TYPE_CHECKING:
    from rich.table import Table

    from experiments.validation.figures import Finding
    from experiments.validation.results import Found


@dataclass(frozen=True, kw_only=True)
class Validate:
    """Hold simulated people against published figures of real ones.

    Delays, praise and silence, gaze, distances and speeds, and tests of pedestrian
    simulators (RiMEA). What is off is said to be off.
    """

    out: Path = Path("runs/validation")
    """Directory for validation.json."""

    workers: int | None = None
    """Processes on this machine; as many as there are cores unless said otherwise."""

    def run(self) -> None:
        """Watches everything, stores what was found and shows it."""
        from experiments.running.engine import open_engine
        from experiments.running.files import make_directory
        from experiments.running.progress import progress
        from experiments.validation.results import how_many, store, validate

        make_directory(self.out)
        engine, console = open_engine("local", self.workers), new_console()
        with progress(console, "scenes", how_many()) as advance:
            found = validate(engine, advance)
        console.print(_differences(found))
        console.print(_counts(found))
        console.print(f"all figures: {store(found, self.out)}", soft_wrap=True)


def _differences(found: Found) -> Table:
    """Returns one row for each figure that is simulated and not as published."""
    table = _new_table("scene", "figure", "people", "simulated", "verdict")
    for group in found.values():
        for one in group:
            if one.verdict in ("off", "undecided"):
                known = one.published
                row = (one.where, known.name, known.said, _number(one), one.verdict)
                table.add_row(*row)
    return table


def _counts(found: Found) -> Table:
    """Returns one row for each group: how many figures have each verdict."""
    from typing import get_args

    from experiments.validation.figures import Verdict
    from experiments.validation.results import count

    verdicts = get_args(Verdict)
    table = _new_table("figures", *verdicts)
    for name, group in found.items():
        table.add_row(name, *(str(count(group, verdict)) for verdict in verdicts))
    return table


def _number(one: Finding) -> str:
    """Returns what was simulated, with its interval if there is one."""
    import math

    simulated = one.simulated
    if simulated is None or math.isnan(simulated.value):
        return "-"
    if math.isnan(simulated.low):
        return f"{simulated.value:.2f}"
    return f"{simulated.value:.2f} ({simulated.low:.2f} to {simulated.high:.2f})"


def _new_table(*headings: str) -> Table:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    table = Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for heading in headings:
        table.add_column(heading)
    return table
