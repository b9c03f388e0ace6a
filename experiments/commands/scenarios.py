"""`household scenarios` and `household check`."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.table import Table

    from experiments.scoring.suite import Admission
    from household.scenario.scenario import Scenario

DEMONSTRATION = "demonstration"
"""What a shipped scenario is that no family stands for: good to look at, not to learn
in, since one constant behavior is nearly right in it all the time."""


@dataclass(frozen=True, kw_only=True)
class Scenarios:
    """List the scenarios and the scenario families that come with the package."""

    def run(self) -> None:
        """Prints each scenario's name, size and story, and each family's demand."""
        from rich.box import SIMPLE_HEAD
        from rich.table import Table

        from household.config.toml import shipped
        from household.scenario.family import load_family
        from household.scenario.reading import read_scenario

        console = new_console()
        table = Table("name", "who", "what", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
        for name in shipped("scenario"):
            scenario = read_scenario(name)
            what = scenario.description
            if not name.startswith("experiment_"):
                what = f"{DEMONSTRATION}: {what}"
            table.add_row(name, _size(scenario), what)
        console.print(table)
        table = Table("family", "demands", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
        for name in shipped("family"):
            table.add_row(name, load_family(name).demand)
        console.print(table)


@dataclass(frozen=True, kw_only=True)
class Check:
    """Check a file of ours and point at every fault in it, or check the suite."""

    file: Annotated[Positional[str], arg(metavar="[FILE.toml|DIR]")] = ""
    """A scenario, a home, a persona or a family: a TOML file, or a shipped name; or a
    directory of results: every study below it, with its trials."""

    suite: bool = False
    """Hold every shipped scenario family against the admission rule."""

    households: int = 8
    """With --suite: households of each family."""

    workers: int | None = None
    """With --suite: processes; as many as there are cores unless said otherwise."""

    out: Path | None = None
    """With --suite: directory for suite.json, the figures."""

    def run(self) -> None:
        """Prints every fault on stderr, or what was checked.

        Raises:
            ExperimentError: The last fault; those before it are printed.
        """
        if self.suite == bool(self.file):
            raise ExperimentError("check: name a file, or give --suite.")
        faults = self._faults_of_suite() if self.suite else self._faults_of_file()
        if faults:
            print(*faults[:-1], sep="\n", end="\n" * (len(faults) > 1), file=sys.stderr)
            raise ExperimentError(faults[-1])

    def _faults_of_file(self) -> Sequence[str]:
        from experiments.running.checking import (
            STUDY_FILE,
            faults_of,
            size_of,
            studies_at,
        )
        from household.scenario.files import check_file, size_of_file

        path = Path(self.file)
        if path.name == STUDY_FILE or path.is_dir():
            studies = studies_at(path)
            faults = faults_of(studies)
            if not faults:
                self._tell(size_of(studies))
            return faults
        faults = check_file(self.file)
        if not faults:
            self._tell(size_of_file(self.file))
        return faults

    def _tell(self, size: str) -> None:
        console = new_console()
        console.print(f"{self.file}: correct; {size}.", soft_wrap=True)

    def _faults_of_suite(self) -> Sequence[str]:
        from experiments.running.engine import open_engine
        from experiments.running.files import make_directory, to_json, write_text
        from experiments.running.progress import progress
        from experiments.running.store import commit, versions
        from experiments.scoring.suite import check_suite, shipped_families

        if self.households < 2:
            raise ExperimentError(
                f"--households must be at least 2, got {self.households}."
            )
        names, console = shipped_families(), new_console()
        engine = open_engine("local", self.workers)
        with progress(console, "households", len(names) * self.households) as advance:
            admissions = check_suite(names, self.households, engine, advance)
        console.print(_suite_table(admissions))
        if self.out is not None:
            make_directory(self.out)
            document = {
                "format": 1,
                "versions": versions(),
                "commit": commit(),
                "households": self.households,
                "families": admissions,
            }
            write_text(self.out / "suite.json", to_json(document))
        return [f"{a.family}: {fault}" for a in admissions for fault in a.faults]


def _suite_table(admissions: Sequence[Admission]) -> Table:
    """Returns one row per family with the figures of the admission rule."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from experiments.report.format import format_interval, format_number

    table = Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for heading in ("family", "best constant", "95 %", "table", "95 %", "moments"):
        table.add_column(heading)
    table.add_column("touches a minute")
    table.add_column("admitted")
    for one in admissions:
        table.add_row(
            one.family,
            f"{one.best_constant} {format_number(one.constant.value, is_share=False)}",
            format_interval(one.constant, is_share=False),
            format_number(one.table.value, is_share=False),
            format_interval(one.table, is_share=False),
            format_number(one.share.value, is_share=True),
            format_number(one.touches.value, is_share=False),
            "no" if one.faults else "yes",
        )
    return table


def _size(scenario: Scenario) -> str:
    people, robots = len(scenario.people), len(scenario.robots)
    return ", ".join(
        f"{n} {one if n == 1 else many}"
        for n, one, many in (
            (people, "person", "people"),
            (robots, "robot", "robots"),
        )
    )
