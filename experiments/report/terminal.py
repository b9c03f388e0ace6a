"""What the terminal shows at the end: the claims table and where everything lies."""

from __future__ import annotations

from typing import TYPE_CHECKING

from experiments.analysis.deciding import FAILS, HOLDS, UNDECIDED
from experiments.report.format import (
    VERDICTS,
    finding_interval,
    finding_references,
    finding_remarks,
    finding_threshold,
    finding_value,
    tally,
)
from experiments.report.records import Published

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

ROOM = 110
"""Width of a terminal in which claims fit on few lines [characters]."""

NARROW = {
    "claim": 11,
    "condition": 10,
    "95 %": 8,
    "random, persona": 7,
    "holds if": 8,
}
"""Columns that wrap between words where there is less room, and how wide they are."""

_STYLES = {HOLDS: "green", FAILS: "bold red", UNDECIDED: "yellow"}


def show(console: Console, published: Published) -> None:
    """Prints the claims table and where everything lies.

    Args:
        console: Where to.
        published: What came out.
    """
    _show_claims(console, published)
    _show_places(console, published)


def _show_claims(console: Console, published: Published) -> None:
    console.print(claims_table(published, narrow=console.width < ROOM))
    own = published.findings_of(paper=False)
    if of_paper := published.findings_of(paper=True):
        console.print(f"{tally(of_paper)}.")
    if own:
        console.print(f"Experiment 6 is ours: {tally(own)}.")
    console.print()
    for finding in published.findings:
        for remark in finding_remarks(finding):
            where = f"{finding.claim.id} ({finding.claim.condition})"
            console.print(f"{where}: {remark}", highlight=False)
    for sentence in published.unfinished:
        console.print(sentence, highlight=False)


def _show_places(console: Console, published: Published) -> None:
    out = published.report_file.parent
    places = {
        "report": published.report_file,
        "claims": published.claims_file,
        "figures": out / "figures",
        **{
            f"trials of experiment {part.experiment.number}": out / part.experiment.name
            for part in published.reproduced
        },
    }
    for what, path in places.items():
        console.print(f"{what}: {path}", highlight=False, soft_wrap=True)
    for part in published.reproduced:
        played = part.played
        console.print(f"replay: {played.page}", highlight=False, soft_wrap=True)
        command = f"household replay {played.recording}"
        console.print(f"  or: {command}", highlight=False, soft_wrap=True)
    if any(part.played.film is None for part in published.reproduced):
        console.print("no films: pip install 'polite-household[render]'")


def claims_table(published: Published, *, narrow: bool = False) -> Table:
    """Returns one row per claim and condition.

    Args:
        published: What came out.
        narrow: Wraps texts so that 80 characters are wide enough.
    """
    from rich.box import SIMPLE_HEAD
    from rich.table import Table
    from rich.text import Text

    table = Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for heading in (
        "",
        "claim",
        "condition",
        "value",
        "95 %",
        "random, persona",
        "holds if",
        "",
    ):
        width = NARROW.get(heading)
        table.add_column(
            heading, no_wrap=width is None, width=width if narrow else None
        )
    before = ""
    for finding in sorted(published.findings, key=lambda one: one.claim.id):
        claim = finding.claim
        new = claim.id != before
        table.add_row(
            claim.id if new else "",
            claim.text if new else "",
            claim.condition,
            finding_value(finding),
            finding_interval(finding),
            finding_references(finding),
            finding_threshold(finding),
            Text(VERDICTS[finding.verdict], style=_STYLES[finding.verdict]),
        )
        before = claim.id
    return table
