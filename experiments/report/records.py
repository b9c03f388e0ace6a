"""What the report is made of: records that are published, shown and written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import polars as pl

from experiments.analysis.claims import Finding
from experiments.analysis.deciding import HOLDS
from experiments.analysis.evaluation import Evaluation
from experiments.analysis.tables import Table
from experiments.paper import Experiment
from experiments.running.study import Study
from experiments.studies.maps import Levels, Map


@dataclass(frozen=True, kw_only=True)
class DrawnFigure:
    """A figure: its files, and what the report shows of it."""

    name: str
    """File name without suffix."""

    caption: str
    """What the figure shows."""

    svgs: tuple[str, ...]
    """One SVG element per column, to be set in a page."""

    files: tuple[Path, ...]
    """The figure as SVG and as PNG."""


@dataclass(frozen=True, kw_only=True)
class Played:
    """A trial to be looked at."""

    recording: Path
    """For the Rerun viewer."""

    page: Path
    """Shows the recording in a browser, without installation."""

    film: Path | None
    """The same as a film; None where the extra ``render`` is missing."""

    picture: Path
    """A moment of it, as SVG."""


@dataclass(frozen=True, kw_only=True)
class Reproduced:
    """An experiment with all that came out of it."""

    experiment: Experiment
    """What was asked."""

    study: Study
    """What was run."""

    document: dict[str, Any]
    """The content of `study.json`."""

    frame: pl.DataFrame
    """The study's table."""

    findings: tuple[Finding, ...]
    """What came out of each claim."""

    evaluations: tuple[Evaluation, ...]
    """How well each condition did, by the paper's four methods and ours."""

    figures: tuple[DrawnFigure, ...]
    """The counterparts of the paper's figures, then all conditions in one."""

    tables: tuple[Table, ...]
    """What else is shown."""

    typical_seed: int
    """The seed whose trial is recorded."""

    played: Played
    """Its trial to be looked at."""


@dataclass(frozen=True, kw_only=True)
class FactorialSummary:
    """The factorial on one experiment's scenario."""

    number: int
    """Of the experiment."""

    n_seeds: int
    """Trials per combination."""

    table: Table
    """Appropriate choices of every combination."""

    findings: tuple[Finding, ...]
    """The paper's finding: at its own levels, and averaged over all others."""

    silence: tuple[Finding, ...]
    """Whether the social rate beats not learning from silence, in the same way."""


@dataclass(frozen=True, kw_only=True)
class SensitivitySummary:
    """The sensitivity table, as far as it was run."""

    table: Table
    """Claims by constants."""

    firm: tuple[str, ...]
    """Claims whose verdict no constant changes."""

    n_finished: int
    """Variants whose trials are all there."""

    n_variants: int
    """Variants that change something."""

    n_seeds: int
    """Trials per condition, at least."""


FindingsOfMap = Mapping[tuple[str, Levels], Finding]
"""What came of each claim in each cell."""


@dataclass(frozen=True, kw_only=True)
class DrawnMap:
    """A map as it is shown."""

    mapped: Map
    """What was mapped."""

    found: FindingsOfMap
    """What came out."""

    n_seeds: int
    """Trials of each cell."""

    figure: DrawnFigure
    """All of its claims side by side."""

    @property
    def sentences(self) -> tuple[str, ...]:
        """Says of each claim, and of all together, in how many cells they hold."""
        together = sum(
            all(self.found[id, levels].verdict == HOLDS for id in self.mapped.ids)
            for levels in self.mapped.cells
        )
        ids = " and ".join(self.mapped.ids)
        return (
            *map(self._sentence, self.mapped.ids),
            f"{ids} hold together in {together} of {len(self.mapped.cells)} cells.",
        )

    def _sentence(self, id: str) -> str:
        found = [one for (claim, _), one in self.found.items() if claim == id]
        holding = sum(one.verdict == HOLDS for one in found)
        usual = self.found[id, self.mapped.usual].verdict
        return (
            f"{id} ({found[0].claim.text.rstrip('.')}) holds in {holding} of "
            f"{len(found)} cells; where the experiment itself lies: {usual}."
        )


@dataclass(frozen=True, kw_only=True)
class AblationSummary:
    """Four conditions, and what each of two ideas adds."""

    table: Table
    """A row for each pair of levels, a column for each outcome."""

    effects: Table
    """A row for each idea and for both together, a column for each outcome."""


@dataclass(frozen=True, kw_only=True)
class Published:
    """Everything that came out, and where it lies."""

    reproduced: tuple[Reproduced, ...]
    """The finished experiments, in the paper's order."""

    unfinished: tuple[str, ...]
    """A sentence about each experiment that is left out."""

    factorial: tuple[FactorialSummary, ...]
    """The factorial, on each scenario where it is finished."""

    sensitivity: SensitivitySummary | None
    """None if nothing of it was run."""

    maps: tuple[DrawnMap, ...]
    """Where claims hold, of each map that was run."""

    ablations: tuple[AblationSummary, ...]
    """Each ablation that was run."""

    teachers: Table | None
    """Claims under several kinds of teachers; None if they were not run."""

    claims_file: Path
    """Every claim and what came of it."""

    report_file: Path
    """All of it, in one file."""

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Every finding of every experiment."""
        return tuple(one for part in self.reproduced for one in part.findings)

    def findings_of(self, *, paper: bool) -> tuple[Finding, ...]:
        """The findings on the paper's claims, or those on ours."""
        return tuple(
            one
            for part in self.reproduced
            if part.experiment.of_paper == paper
            for one in part.findings
        )
