"""The factorial and the sensitivity table, as far as they were run, for the report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from math import isnan
from pathlib import Path
from typing import NamedTuple

import polars as pl

from experiments.analysis.tables import Cell, Table
from experiments.paper import EXPERIMENTS, OF_PAPER
from experiments.report.format import format_number
from experiments.report.records import FactorialSummary, SensitivitySummary
from experiments.running.store import Results
from experiments.studies import contrasts, factorial, sensitivity
from experiments.studies.factorial import Combination
from experiments.studies.sensitivity import Variant


def summarize_factorial(out: Path) -> tuple[FactorialSummary, ...]:
    """Returns every scenario's factorial that is finished.

    Args:
        out: The directory of all results.
    """
    found = []
    for number in OF_PAPER:
        results = Results(out / f"factorial/experiment_{number}")
        if results.study_file.exists():
            seeds = tuple(results.read_study()["seeds"])
            study = factorial.study(number, seeds)
            if not results.missing(study.trials()):
                found.append(_factorial(number, len(seeds), results.read(study)))
    return tuple(found)


def _factorial(number: int, n_seeds: int, frame: pl.DataFrame) -> FactorialSummary:
    finding = contrasts.FINDINGS[number - 1]
    silence = contrasts.against_silence(number)
    return FactorialSummary(
        number=number,
        n_seeds=n_seeds,
        table=_combinations(number, frame),
        findings=tuple(claim.check(frame) for claim in finding.claims()),
        silence=tuple(claim.check(frame) for claim in silence.claims()),
    )


def _combinations(number: int, frame: pl.DataFrame) -> Table:
    """Returns a row for each rate with each credit rule, a column for each analogy."""
    found = factorial.estimates(frame, "right")
    rates, credits, analogies = factorial.FACTORS.values()

    def cell(levels: Combination) -> Cell:
        value = found[levels].value
        return Cell(
            text=format_number(value, is_share=True),
            shade=None if isnan(value) else value,
            marked=levels in factorial.PAPER[number],
        )

    return Table(
        name=f"factorial_{number}",
        title=f"Experiment {number}: {EXPERIMENTS[number].title}",
        header=("rate, credit", *(name.replace("_", " + ") for name in analogies)),
        rows=tuple(
            (
                f"{rate.replace('_', ' ')}, {credit}",
                tuple(
                    cell(Combination(rate, credit, analogy)) for analogy in analogies
                ),
            )
            for rate in rates
            for credit in credits
        ),
        note="Appropriate choices. Framed: what the paper ran in this experiment.",
    )


def summarize_sensitivity(
    out: Path, tables: Mapping[int, pl.DataFrame]
) -> SensitivitySummary | None:
    """Returns the sensitivity table as far as it was run; None if it was not.

    Args:
        out: The directory of all results.
        tables: The finished experiments' tables, by number.
    """
    if not (out / "sensitivity").exists():
        return None
    of_paper = [number for number in tables if number in OF_PAPER]
    every = sensitivity.variants(EXPERIMENTS[number] for number in of_paper)
    changing = [variant for variant in every if variant.conditions]
    held = _Verdicts(out, tables)
    finished = [one for one in changing if held.of(one) is not None]
    if not finished:
        return None
    ids = sorted({c.id for number in of_paper for c in EXPERIMENTS[number].claims})
    flips = Counter(id for variant in finished for id in held.flipped(variant))
    return SensitivitySummary(
        table=_heat_map(every, held, ids),
        firm=tuple(id for id in ids if not flips[id]),
        n_finished=len(finished),
        n_variants=len(changing),
        n_seeds=min(len(held.seeds(variant)) for variant in finished),
    )


class _Verdicts:
    """Which claims hold, with and without a constant changed."""

    def __init__(self, out: Path, tables: Mapping[int, pl.DataFrame]) -> None:
        self._out, self._tables = out, tables
        self._known: dict[str, Mapping[str, bool] | None] = {}
        self._base: dict[tuple[int, tuple[int, ...]], Mapping[str, bool]] = {}

    def seeds(self, variant: Variant) -> tuple[int, ...]:
        """The seeds that a variant was prepared for; none if it was not."""
        results = Results(self._out / variant.name)
        if not results.study_file.exists():
            return ()
        return tuple(results.read_study()["seeds"])

    def of(self, variant: Variant) -> Mapping[str, bool] | None:
        """Which claims hold in a variant; None if its trials are not all there."""
        if variant.name not in self._known:
            seeds = self.seeds(variant)
            table = self._table(variant, seeds)
            self._known[variant.name] = (
                sensitivity.holding(variant, table, self._out, seeds) if seeds else None
            )
        return self._known[variant.name]

    def unchanged(self, variant: Variant) -> Mapping[str, bool]:
        """Which claims hold without the change, with the variant's seeds."""
        seeds = self.seeds(variant)
        key = (variant.experiment.number, seeds)
        if key not in self._base:
            table = self._table(variant, seeds)
            self._base[key] = sensitivity.holds(variant.experiment, table)
        return self._base[key]

    def flipped(self, variant: Variant) -> list[str]:
        """Claims whose verdict a variant changes."""
        found = self.of(variant) or {}
        before = self.unchanged(variant) if found else {}
        return [id for id, holds in found.items() if holds != before[id]]

    def _table(self, variant: Variant, seeds: Sequence[int]) -> pl.DataFrame:
        table = self._tables[variant.experiment.number]
        return table.filter(pl.col("seed").is_in(list(seeds)))


class _Mark(NamedTuple):
    """What became of a claim in a variant."""

    sign: str
    """What stands for it."""

    was_run: bool = False
    """Whether there is a verdict."""

    is_changed: bool = False
    """Whether that is another verdict than without the change."""


def _heat_map(every: Sequence[Variant], held: _Verdicts, ids: Sequence[str]) -> Table:
    rows: dict[str, dict[tuple[str, str], _Mark]] = {}
    for variant in every:
        row = rows.setdefault(variant.constant.name, {})
        for claim in variant.experiment.claims:
            row[claim.id, variant.direction] = _mark(variant, held, claim.id)
    return Table(
        name="sensitivity",
        title="Claims by constants",
        header=("constant", *ids),
        rows=tuple(
            (name, tuple(_both(row, id) for id in ids))
            for name, row in rows.items()
            if any(mark.was_run for mark in row.values())
        ),
        note=(
            "Left of the stroke: the constant a quarter smaller, right of it: a "
            "quarter larger. ✓ holds, ✗ fails; shaded and framed where that is another "
            "verdict than without the change. A dot: the constant has no part in it or "
            "is at its limit; a dash: the changed constant is impossible; a question "
            "mark: not run yet. Constants of which nothing was run are left out."
        ),
    )


def _mark(variant: Variant, held: _Verdicts, id: str) -> _Mark:
    if variant.refusal:
        return _Mark("-")
    if not variant.conditions:
        return _Mark("·")
    found = held.of(variant)
    if found is None:
        return _Mark("?")
    sign = "✓" if found[id] else "✗"
    return _Mark(sign, was_run=True, is_changed=id in held.flipped(variant))


def _both(row: Mapping[tuple[str, str], _Mark], id: str) -> Cell:
    marks = [row[id, direction] for direction in sensitivity.FACTORS]
    changed = any(mark.is_changed for mark in marks)
    return Cell(
        text="|".join(mark.sign for mark in marks),
        shade=0.7 if changed else None,
        marked=changed,
    )
