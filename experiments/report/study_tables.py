"""The factorial and the sensitivity table, as far as they were run, for the report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import polars as pl

from experiments.analysis.claims import Finding
from experiments.analysis.tables import Entry, Table
from experiments.paper import EXPERIMENTS
from experiments.report import format as wording
from experiments.running.store import Results
from experiments.studies import factorial, sensitivity
from experiments.studies.sensitivity import Variant


@dataclass(frozen=True, kw_only=True)
class FactorialShown:
    """The factorial on one experiment's scenario."""

    number: int
    n_seeds: int
    table: Table
    findings: tuple[Finding, ...]
    """The paper's finding: at its own levels, and averaged over all others."""

    silence: tuple[Finding, ...]
    """Whether the social rate beats not learning from silence, in the same way."""


@dataclass(frozen=True, kw_only=True)
class SensitivityShown:
    """The sensitivity table."""

    table: Table
    firm: tuple[str, ...]
    """Claims whose verdict no constant changes."""

    n_finished: int
    n_variants: int
    n_seeds: int


def shown_factorial(out: Path) -> tuple[FactorialShown, ...]:
    """Returns every scenario's factorial that is finished.

    Args:
        out: The directory of all results.
    """
    found = []
    for number in EXPERIMENTS:
        results = Results(out / f"factorial/experiment_{number}")
        if results.study_file.exists():
            seeds = tuple(results.read_study()["seeds"])
            study = factorial.study(number, seeds)
            if not results.missing(study.trials()):
                found.append(_factorial(number, len(seeds), results.read(study)))
    return tuple(found)


def _factorial(number: int, n_seeds: int, frame: pl.DataFrame) -> FactorialShown:
    finding = factorial.FINDINGS[number - 1]
    silence = factorial.against_silence(number)
    return FactorialShown(
        number=number,
        n_seeds=n_seeds,
        table=_cells(number, frame),
        findings=tuple(claim.check(frame) for claim in finding.claims()),
        silence=tuple(claim.check(frame) for claim in silence.claims()),
    )


def _cells(number: int, frame: pl.DataFrame) -> Table:
    found = factorial.cells(frame, "right")
    rates, credits, analogies = factorial.FACTORS.values()

    def entry(name: str) -> Entry:
        value = found[name].value
        return Entry(
            text=wording.number(value, is_share=True),
            shade=value if value == value else None,
            marked=name in factorial.PAPER[number],
        )

    return Table(
        name=f"factorial_{number}",
        title=f"Experiment {number}: {EXPERIMENTS[number].title}",
        header=("rate, credit", *(name.replace("_", " + ") for name in analogies)),
        rows=tuple(
            (
                f"{rate.replace('_', ' ')}, {credit}",
                tuple(entry(f"{rate}+{credit}+{analogy}") for analogy in analogies),
            )
            for rate in rates
            for credit in credits
        ),
        note="Appropriate choices. Framed: what the paper ran in this experiment.",
    )


def shown_sensitivity(
    out: Path, tables: Mapping[int, pl.DataFrame]
) -> SensitivityShown | None:
    """Returns the sensitivity table as far as it was run; None if it was not.

    Args:
        out: The directory of all results.
        tables: The finished experiments' tables, by number.
    """
    if not (out / "sensitivity").exists():
        return None
    every = sensitivity.variants(EXPERIMENTS[number] for number in tables)
    changing = [variant for variant in every if variant.conditions]
    held = _Verdicts(out, tables)
    finished = [one for one in changing if held.of(one) is not None]
    if not finished:
        return None
    ids = sorted({c.id for number in tables for c in EXPERIMENTS[number].claims})
    flips = Counter(id for variant in finished for id in held.flipped(variant))
    return SensitivityShown(
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


def _heat_map(every: Sequence[Variant], held: _Verdicts, ids: Sequence[str]) -> Table:
    rows: dict[str, dict[tuple[str, str], tuple[str, bool]]] = {}
    for variant in every:
        row = rows.setdefault(variant.constant.name, {})
        for claim in variant.experiment.claims:
            row[claim.id, variant.direction] = _sign(variant, held, claim.id)
    return Table(
        name="sensitivity",
        title="Claims by constants",
        header=("constant", *ids),
        rows=tuple(
            (name, tuple(_both(row, id) for id in ids))
            for name, row in rows.items()
            if any(sign in "✓✗" for sign, _ in row.values())
        ),
        note=(
            "Left of the stroke: the constant a quarter smaller, right of it: a "
            "quarter larger. ✓ holds, ✗ fails; shaded and framed where that is another "
            "verdict than without the change. A dot: the constant has no part in it or "
            "is at its limit; a dash: the changed constant is impossible; a question "
            "mark: not run yet. Constants of which nothing was run are left out."
        ),
    )


def _sign(variant: Variant, held: _Verdicts, id: str) -> tuple[str, bool]:
    """A sign, and whether it is another verdict than without the change."""
    if variant.refusal:
        return "-", False
    if not variant.conditions:
        return "·", False
    found = held.of(variant)
    if found is None:
        return "?", False
    return "✓" if found[id] else "✗", id in held.flipped(variant)


def _both(row: Mapping[tuple[str, str], tuple[str, bool]], id: str) -> Entry:
    signs = [row[id, direction] for direction in sensitivity.FACTORS]
    changed = any(flipped for _, flipped in signs)
    return Entry(
        text="|".join(sign for sign, _ in signs),
        shade=0.7 if changed else None,
        marked=changed,
    )
