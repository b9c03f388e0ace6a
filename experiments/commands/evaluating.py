"""`household evaluate`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from rich.table import Table

    from experiments.scoring.evaluate import Evaluation, FamilyEvaluation

SHOWN = ("policy", "random", "best constant", "population", "persona", "lookahead")
"""Rows of the tables in the terminal; evaluation.json has every constant, too."""


@dataclass(frozen=True, kw_only=True)
class Evaluate:
    """Score a policy on households drawn by seed, references beside it."""

    policy: Annotated[Positional[str], arg(metavar="POLICY")]
    """random, constant:BEHAVIOR, a learner's name, LEARNER.json or module:function."""

    suite: str = "all"
    """A scenario family, its TOML file, or all that are shipped."""

    seeds: int = 30
    """Households of each family."""

    training: int = 1_800
    """Decisions that a named learner learns for in each household."""

    workers: int | None = None
    """Processes; as many as there are cores unless said otherwise."""

    out: Path = Path("runs/evaluation")
    """Directory for evaluation.json."""

    def run(self) -> None:
        """Scores the policy, writes evaluation.json and shows a table per family."""
        from experiments.running.engine import open_engine
        from experiments.running.files import make_directory, to_json, write_text
        from experiments.running.progress import progress
        from experiments.running.store import commit, versions
        from experiments.scoring.evaluate import evaluate, families_of
        from experiments.scoring.policies import specification

        for name, least in (("seeds", 1), ("training", 0)):
            if getattr(self, name) < least:
                raise ExperimentError(
                    f"--{name} must be at least {least}, got {getattr(self, name)}."
                )
        families = families_of(self.suite)
        specification(self.policy)  # what is wrong with it is said before anything runs
        make_directory(self.out)
        console = new_console()
        with progress(console, "households", self.seeds * len(families)) as advance:
            evaluation = evaluate(
                self.policy,
                families,
                self.seeds,
                training=self.training,
                engine=open_engine("local", self.workers),
                advance=advance,
            )
        file = self.out / "evaluation.json"
        made_with = {"format": 1, "versions": versions(), "commit": commit()}
        write_text(file, to_json(made_with | {"evaluation": evaluation}))
        for family in evaluation.families:
            console.print(_table(evaluation, family))
        console.print(f"evaluation: {file}", highlight=False, soft_wrap=True)


def _table(evaluation: Evaluation, family: FamilyEvaluation) -> Table:
    """Returns one row for the policy and for each reference."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from experiments.report.format import format_interval, format_number

    table = Table(
        title=f"{family.family}: {family.demand}",
        title_justify="left",
        box=SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for heading in ("", "probe", "95 %", "lived", "a minute", "caresses", "taps"):
        table.add_column(heading)
    for name in SHOWN:
        row, called = family.scores[name], name
        if name == "policy":
            called = evaluation.policy
        if name == "best constant":
            called = f"always {family.best_constant}"
        table.add_row(
            called,
            format_number(row.probe_greedy.value, is_share=False),
            format_interval(row.probe_greedy, is_share=False),
            format_number(row.share_per_minute, is_share=False),
            format_number(row.verdicts_per_minute.value, is_share=False),
            format_number(row.caresses_per_minute.value, is_share=False),
            format_number(row.taps_per_minute.value, is_share=False),
        )
    return table
