"""`household reproduce` and `household report`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import PREPARING, new_console
from experiments.errors import ExperimentError, unknown
from experiments.threads import one_thread

if TYPE_CHECKING:
    from rich.console import Console

    from experiments.paper import Experiment
    from experiments.running.engine import Engine
    from experiments.running.study import Study


@dataclass(frozen=True, kw_only=True)
class Reproduce:
    """Run the paper's experiments: claims, figures, replays, report.

    What is stored already is not run again: stop it with Ctrl-C and start it again.
    """

    experiments: Annotated[
        Positional[tuple[str, ...]], arg(metavar="[1..6]", help_behavior_hint="")
    ] = ()
    """Which experiments; all of them if none is named. 6 is not the paper's."""

    seeds: int = 30
    """Trials per condition; their seeds are 0, 1, 2, ..."""

    out: Path = Path("runs/paper")
    """Directory for everything that comes out."""

    factorial: bool = False
    """Also run every learning rate with every credit rule and every analogy."""

    sensitivity: bool = False
    """Also run each experiment with each constant a quarter smaller and larger."""

    sensitivity_seeds: int | None = None
    """Trials per condition there; as many as --seeds if not given, and no more."""

    workers: int | None = None
    """Processes on this machine; one for each core if not given."""

    engine: str = "local"
    """local, dask, dask:ADDRESS, ray or ray:ADDRESS."""

    def run(self) -> None:
        """Runs what is missing, then publishes."""
        one_thread()
        from experiments.report.publish import publish
        from experiments.report.terminal import show
        from experiments.running.engine import open_engine
        from experiments.running.lock import alone_in
        from experiments.running.pulse import pulse

        console = new_console()
        chosen, engine = self._chosen(), open_engine(self.engine, self.workers)
        with pulse(console, "Preparing the experiments"):
            studies = self._studies(chosen)
        with alone_in(self.out):
            self._run_missing(console, studies, engine)
            with pulse(console, "Reading what is stored") as say:
                published = publish(self.out, say)
        show(console, published)

    def _chosen(self) -> tuple[Experiment, ...]:
        """Checks everything that can be checked before anything is run."""
        from experiments.paper import EXPERIMENTS, select

        numbers = [
            _number(word, "experiment", EXPERIMENTS) for word in self.experiments
        ]
        if self.seeds < 1:
            raise ExperimentError(f"--seeds must be at least 1, got {self.seeds}.")
        asked = self.sensitivity_seeds
        if asked is not None and not 1 <= asked <= self.seeds:
            raise ExperimentError(
                f"--sensitivity-seeds must be from 1 to --seeds, got {asked}."
            )
        if self.out.exists() and not self.out.is_dir():
            raise ExperimentError(f"--out {self.out}: is a file, must be a directory.")
        return select(numbers)

    def _studies(self, experiments: tuple[Experiment, ...]) -> list[Study]:
        from experiments.studies import factorial, sensitivity

        seeds = tuple(range(self.seeds))
        studies = [each.study(seeds) for each in experiments]
        of_paper = [each for each in experiments if each.of_paper]
        if self.factorial:
            studies += [factorial.study(each.number, seeds) for each in of_paper]
        if self.sensitivity:
            fewer = seeds[: self.sensitivity_seeds]
            studies += [
                variant.study(fewer)
                for variant in sensitivity.variants(of_paper)
                if variant.conditions
            ]
        return studies

    def _run_missing(
        self, console: Console, studies: Sequence[Study], engine: Engine
    ) -> None:
        from experiments.running.jobs import prepare, run
        from experiments.running.progress import progress
        from experiments.running.pulse import pulse

        with pulse(console, PREPARING):
            jobs = prepare(studies, self.out)
        total = sum(len(study.trials()) for study in studies)
        stored = f"{total - len(jobs)} of {total} trials are stored already."
        console.print(f"{total} trials. {stored if len(jobs) < total else ''}")
        try:
            with progress(console, "trials", len(jobs)) as advance:
                run(jobs, engine, advance)
        except KeyboardInterrupt:
            left = sum(len(job.results.missing([job.trial])) for job in jobs)
            raise KeyboardInterrupt(
                f"Stopped. {total - left} of {total} trials are stored in {self.out}; "
                "the same command goes on from there."
            ) from None


@dataclass(frozen=True, kw_only=True)
class Report:
    """Build claims, figures and report.html again from stored results."""

    directory: Annotated[Positional[Path], arg(metavar="DIR")]
    """What `household reproduce --out` or `household study --out` was given."""

    def run(self) -> None:
        """Publishes what is stored."""
        one_thread()
        from experiments.report.generalization import has_studies, write_page
        from experiments.report.publish import publish
        from experiments.report.terminal import show
        from experiments.running.lock import alone_in
        from experiments.running.pulse import pulse

        if not self.directory.is_dir():
            raise ExperimentError(f"{self.directory}: nothing to report, no directory.")
        with alone_in(self.directory):
            if has_studies(self.directory):
                page = write_page(self.directory)
                new_console().print(str(page), highlight=False, soft_wrap=True)
                return
            console = new_console()
            with pulse(console, "Reading what is stored") as say:
                published = publish(self.directory, say)
        show(console, published)


def _number(word: str, kind: str, allowed: Iterable[int]) -> int:
    named = {str(each): each for each in allowed}
    if word not in named:
        raise unknown(kind, word, allowed)
    return named[word]
