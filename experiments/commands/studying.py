"""`household study`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError, unknown

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.table import Table

    from experiments.running.engine import Engine
    from experiments.running.study import Study
    from experiments.studies.findings import Finding


@dataclass(frozen=True, kw_only=True)
class StudyCommand:
    """Run a generalization study; what is stored already is not run again."""

    name: Annotated[Positional[str], arg(metavar="NAME")]
    """actors, plenty or newcomers."""

    seeds: int = 10
    """Households of each condition."""

    engine: str = "local"
    """local, dask, dask:ADDRESS, ray or ray:ADDRESS."""

    workers: int | None = None
    """Processes on this machine; as many as there are cores unless said otherwise."""

    out: Path = Path("runs/studies")
    """Directory for the trials and findings.json."""

    def run(self) -> None:
        """Runs what is missing, then shows and stores what was found."""
        from experiments.running.engine import open_engine
        from experiments.running.files import to_json, write_text
        from experiments.running.lock import alone_in
        from experiments.running.store import Results
        from experiments.studies.findings import findings
        from experiments.studies.people import STUDIES

        if self.name not in STUDIES:
            raise unknown("study", self.name, STUDIES)
        if self.seeds < 1:
            raise ExperimentError(f"--seeds must be at least 1, got {self.seeds}.")
        studies = STUDIES[self.name](tuple(range(self.seeds)))
        engine, console = open_engine(self.engine, self.workers), new_console()
        file = self.out / self.name / "findings.json"
        with alone_in(self.out):
            self._run_missing(studies, engine, console)
            found = [
                finding
                for study in studies
                for finding in findings(
                    study, Results(self.out / study.name).read(study)
                )
            ]
            document = {"format": 1, "study": self.name, "findings": found}
            write_text(file, to_json(document))
        console.print(_table(found))
        console.print(f"findings: {file}", highlight=False, soft_wrap=True)

    def _run_missing(
        self, studies: Sequence[Study], engine: Engine, console: Console
    ) -> None:
        from experiments.running.jobs import prepare, run
        from experiments.running.progress import progress

        jobs = prepare(studies, self.out)
        with progress(console, "trials", len(jobs)) as advance:
            run(jobs, engine, advance)


def _table(found: list[Finding]) -> Table:
    """Returns one row per finding."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from experiments.report.format import format_interval, format_number

    table = Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for heading in (*found[0].factors, "greedy", "95 %", "best constant", "touches"):
        table.add_column(heading)
    for one in found:
        table.add_row(
            *one.factors.values(),
            format_number(one.greedy.value, is_share=False),
            format_interval(one.greedy, is_share=False),
            format_number(one.best_constant.value, is_share=False),
            format_number(one.touches.value, is_share=False),
        )
    return table
