"""`household study`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import PREPARING, new_console
from experiments.errors import ExperimentError, unknown

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.table import Table

    from experiments.generalization.findings import Findings
    from experiments.generalization.inquiry import Inquiry
    from experiments.running.engine import Engine
    from experiments.running.study import Study
    from experiments.studies.findings import Finding


@dataclass(frozen=True, kw_only=True)
class StudyCommand:
    """Run a generalization study; what is stored already is not run again."""

    name: Annotated[Positional[str], arg(metavar="NAME")]
    """transfer, heterogeneity, actors, newcomers, homes, teachers, drift, robots,
    cross_play, suite, deep, tuning; crowd, plenty, strangers; or my_study.py."""

    seeds: int | None = None
    """Seeds of each condition; as many as the study wants unless said otherwise."""

    engine: str = "local"
    """local, dask, dask:ADDRESS, ray or ray:ADDRESS."""

    workers: int | None = None
    """Processes on this machine; as many as there are cores unless said otherwise."""

    out: Path = Path("runs/studies")
    """Directory for the trials, findings.json and the figure."""

    plan: bool = False
    """Only say how many trials there are and how long they take, from a sample."""

    cores: tuple[int, ...] = (8, 64)
    """With --plan: for how many cores, beside those here."""

    def run(self) -> None:
        """Runs what is missing, then shows and stores what was found."""
        from experiments.generalization.extras import runnable
        from experiments.generalization.names import NAMES, inquiry
        from experiments.studies.people import STUDIES

        if self.seeds is not None and self.seeds < 1:
            raise ExperimentError(f"--seeds must be at least 1, got {self.seeds}.")
        if min(self.cores, default=1) < 1:
            raise ExperimentError(f"--cores must be at least 1, got {self.cores}.")
        if self.name in STUDIES:
            self._many_people(tuple(range(self.seeds or 10)))
            return
        if self.name not in NAMES and not self.name.endswith(".py"):
            raise unknown("study", self.name, (*NAMES, *STUDIES, "FILE.py"))
        asked, left_out = runnable(inquiry(self.name))
        if left_out:
            new_console().print(left_out, highlight=False)
        self._generalization(asked, tuple(range(self.seeds or asked.seeds)))

    def _generalization(self, asked: Inquiry, seeds: tuple[int, ...]) -> None:
        from experiments.generalization.inquiry import studies
        from experiments.generalization.results import store
        from experiments.running.lock import alone_in

        wanted, console = studies(asked, seeds), new_console()
        if self.plan:
            self._plan(wanted, console)
            return
        engine = self._engine()
        with alone_in(self.out):
            for study in wanted:  # trainings first: the others start from them
                self._run_missing([study], engine, console)
            found, files = store(asked, wanted[-1], self.out)
        if found.conditions:
            console.print(_conditions_table(found))
        for sentence in found.sentences:
            console.print(f"- {sentence}", highlight=False)
        for file in files:
            console.print(str(file), highlight=False, soft_wrap=True)

    def _many_people(self, seeds: tuple[int, ...]) -> None:
        from experiments.running.files import to_json, write_text
        from experiments.running.lock import alone_in
        from experiments.running.store import Results
        from experiments.studies.findings import findings
        from experiments.studies.people import STUDIES

        studies, console = STUDIES[self.name](seeds), new_console()
        if self.plan:
            self._plan(studies, console)
            return
        engine = self._engine()
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

    def _engine(self) -> Engine:
        from experiments.running.engine import open_engine

        return open_engine(self.engine, self.workers)

    def _plan(self, studies: Sequence[Study], console: Console) -> None:
        """Says how long everything takes; nothing is stored."""
        import os

        from experiments.running.jobs import missing
        from experiments.running.planning import plan

        here = self.workers or os.cpu_count() or 1
        for study in studies:
            planned = plan(len(study.trials()), missing(study, self.out))
            console.print(
                f"{study.name}: {planned.trials} trials, {planned.stored} are stored "
                f"already. {planned.seconds:.2f} s for each, by {planned.timed} that "
                "were timed.",
                highlight=False,
            )
            for cores in (here, *self.cores):
                where = "here" if cores == here else f"on {cores} cores"
                console.print(
                    f"  {where}: {planned.hours(cores):.2f} h", highlight=False
                )

    def _run_missing(
        self, studies: Sequence[Study], engine: Engine, console: Console
    ) -> None:
        from experiments.running.jobs import prepare, run
        from experiments.running.progress import progress
        from experiments.running.pulse import pulse

        with pulse(console, PREPARING):
            jobs = prepare(studies, self.out)
        total = sum(len(study.trials()) for study in studies)
        console.print(
            f"{studies[0].name}: {total} trials, {total - len(jobs)} are stored.",
            highlight=False,
        )
        with progress(console, "trials", len(jobs)) as advance:
            run(jobs, engine, advance)


def _conditions_table(found: Findings) -> Table:
    """Returns one row for each condition and number of touches."""
    from experiments.generalization.findings import interval_of

    table = _new_table()
    headings = ("touches", "greedy", "deployed", "best constant", "worst people")
    for heading in (*found.conditions[0].factors, *headings):
        table.add_column(heading)
    for one in found.conditions:
        table.add_row(
            *one.factors.values(),
            str(one.touches),
            interval_of(one.greedy),
            interval_of(one.deployed),
            f"{one.best_constant:z.2f}",
            f"{one.worst_people:z.2f}",
        )
    return table


def _table(found: list[Finding]) -> Table:
    """Returns one row per finding."""
    from experiments.report.format import format_interval, format_number

    table = _new_table()
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


def _new_table() -> Table:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    return Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
