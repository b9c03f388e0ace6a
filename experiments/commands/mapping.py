"""`household maps`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import PREPARING, new_console
from experiments.errors import ExperimentError, unknown

if TYPE_CHECKING:
    from experiments.running.study import Study


@dataclass(frozen=True, kw_only=True)
class Maps:
    """Map where claims hold: over two constants, with other people, ideas apart.

    What is stored already is not run again. `household report DIR` shows them with the
    experiments, if DIR holds both.
    """

    names: Annotated[
        Positional[tuple[str, ...]], arg(metavar="[NAME]", help_behavior_hint="")
    ] = ()
    """attention, approach, watching, teachers_1 (to 5), rate_representation,
    rate_silence_1 (to 5); all of them if none is named."""

    seeds: int = 20
    """Trials of each cell; their seeds are 0, 1, 2, ..."""

    out: Path = Path("runs/paper")
    """Directory for maps/NAME and figures/map_NAME.svg."""

    workers: int | None = None
    """Processes on this machine; one for each core if not given."""

    engine: str = "local"
    """local, dask, dask:ADDRESS, ray or ray:ADDRESS."""

    def run(self) -> None:
        """Runs what is missing, draws the maps and says what they show."""
        from experiments.report.maps import ablation_tables, drawn_maps, teacher_table
        from experiments.running.engine import open_engine
        from experiments.running.jobs import prepare, run
        from experiments.running.lock import alone_in
        from experiments.running.progress import progress
        from experiments.running.pulse import pulse

        studies, console = self._studies(), new_console()
        engine = open_engine(self.engine, self.workers)
        with alone_in(self.out):
            with pulse(console, PREPARING):
                jobs = prepare(studies, self.out)
            total = sum(len(study.trials()) for study in studies)
            console.print(f"{total} trials, {total - len(jobs)} are stored.")
            with progress(console, "trials", len(jobs)) as advance:
                run(jobs, engine, advance)
            with console.status("Drawing"):
                maps, ablations = drawn_maps(self.out), ablation_tables(self.out)
                by_teacher = teacher_table(self.out)
        for one in maps:
            console.print(f"{one.mapped.title}: {one.figure.files[0]}", soft_wrap=True)
            for sentence in one.sentences:
                console.print(f"- {sentence}")
        if by_teacher is not None:
            console.print(f"{by_teacher.title}: {', '.join(by_teacher.header[1:])}")
            for claim, cells in by_teacher.rows:
                console.print(f"- {claim}: {', '.join(cell.text for cell in cells)}")
        for summary in ablations:
            console.print(f"{summary.table.title}: what each adds to")
            outcomes = summary.effects.header[1:]
            for difference, cells in summary.effects.rows:
                console.print(f"- {difference}")
                for outcome, cell in zip(outcomes, cells, strict=True):
                    console.print(f"    {outcome}: {cell.text}")

    def _studies(self) -> list[Study]:
        """Checks what was asked for before anything is run."""
        from experiments.paper import OF_PAPER
        from experiments.studies import teachers
        from experiments.studies.ablations import ABLATIONS
        from experiments.studies.maps import MAPS

        if self.seeds < 1:
            raise ExperimentError(f"--seeds must be at least 1, got {self.seeds}.")
        seeds = tuple(range(self.seeds))
        known = {
            **{name: one.study(seeds) for name, one in MAPS.items()},
            **{f"teachers_{n}": teachers.study(n, seeds) for n in OF_PAPER},
            **{name: one.study(seeds) for name, one in ABLATIONS.items()},
        }
        for name in self.names:
            if name not in known:
                raise unknown("map", name, known)
        return [known[name] for name in self.names or known]
