"""`household bench`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from experiments.bench.measurement import Measurement, Settings


@dataclass(frozen=True, kw_only=True)
class Bench:
    """Measure how fast everything is, beside the peers that are installed.

    Takes some minutes; the peers come with the extra `bench`.
    """

    out: Path = Path("runs/bench")
    """Directory for bench.json, bench.md (the table) and bench.svg (the growth)."""

    repetitions: int = 7
    """Of every measurement; the median counts."""

    steps: int = 1000
    """Environment steps in a repetition."""

    def run(self) -> None:
        """Measures everything, writes it down and shows it."""
        from experiments.bench.measurement import Settings
        from experiments.running.files import make_directory

        for name in ("repetitions", "steps"):
            if getattr(self, name) < 1:
                raise ExperimentError(
                    f"--{name} must be at least 1, got {getattr(self, name)}."
                )
        make_directory(self.out)
        measure_all(Settings(repetitions=self.repetitions, steps=self.steps), self.out)


def measure_all(settings: Settings, out: Path) -> None:
    """Measures everything, writes it down and shows the table."""
    from experiments.bench import report

    console = new_console()
    measurements: list[Measurement] = []
    for name, part in _parts().items():
        with console.status(f"Measuring {name}"):
            measurements += part(settings)
    report.write(measurements, settings, out)
    console.print(report.tables(measurements))
    for name, value in report.machine().items():
        console.print(f"{name}: {value}")
    console.print(f"{out}: bench.json, bench.md, bench.svg")


def _parts() -> Mapping[str, Callable[[Settings], Iterable[Measurement]]]:
    from experiments.bench import (
        inside,
        learning,
        processes,
        stepping,
        vectors,
        whole_trials,
    )

    return {
        "steps beside peers": stepping.beside_peers,
        "physics": inside.physics,
        "the parts of a step": inside.parts,
        "growth": stepping.growth,
        "many homes": vectors.many_homes,
        "recording": stepping.recording,
        "whole trials": whole_trials.beside_steps,
        "learners": learning.updates,
        "learners by views": learning.people,
        "learners' memory": learning.visited,
        "start": processes.starting,
        "trials": processes.trials,
    }
