"""`household scenarios` and `household check`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from household.scenario.scenario import Scenario


@dataclass(frozen=True, kw_only=True)
class Scenarios:
    """List the scenarios that come with the package."""

    def run(self) -> None:
        """Prints each scenario's name, size and story."""
        from rich.box import SIMPLE_HEAD
        from rich.table import Table

        from household.config.toml import shipped
        from household.scenario.scenario import read_scenario

        table = Table("name", "who", "what", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
        for name in shipped("scenario"):
            scenario = read_scenario(name)
            table.add_row(name, _size(scenario), scenario.description)
        new_console().print(table)


@dataclass(frozen=True, kw_only=True)
class Check:
    """Check a scenario file and point at every fault in it."""

    file: Annotated[Positional[str], arg(metavar="FILE.toml")]
    """A TOML file, or the name of a shipped scenario."""

    def run(self) -> None:
        """Prints every fault on stderr, or what the scenario is."""
        import sys

        from household.scenario.scenario import read_scenario
        from household.scenario.validation import check_file

        faults = check_file(self.file)
        if faults:
            print(*faults[:-1], sep="\n", end="\n" * (len(faults) > 1), file=sys.stderr)
            raise ExperimentError(faults[-1])
        scenario = read_scenario(self.file)
        new_console().print(f"{self.file}: correct; {_size(scenario)}.")


def _size(scenario: Scenario) -> str:
    people, robots = len(scenario.people), len(scenario.robots)
    return ", ".join(
        f"{n} {one if n == 1 else many}"
        for n, one, many in (
            (people, "person", "people"),
            (robots, "robot", "robots"),
        )
    )
