"""Sensitivity: which claims still hold if a constant is a quarter smaller or larger."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import polars as pl

from experiments.analysis.claims import Claim, verdicts
from experiments.paper.experiment import Experiment
from experiments.running.files import to_json, write_text
from experiments.running.store import Results
from experiments.running.study import Condition, Study
from experiments.running.trial import describe_condition
from experiments.studies.constants import Constant, constants

FACTORS: Mapping[str, float] = {"down": 0.75, "up": 1.25}
"""Direction -> what a constant is multiplied by."""


@dataclass(frozen=True, kw_only=True)
class Variant:
    """An experiment with one constant changed."""

    experiment: Experiment
    """What is varied."""

    constant: Constant
    """What is changed."""

    direction: str
    """A key of `FACTORS`."""

    conditions: tuple[Condition, ...]
    """The conditions that change by it; the others need not be run again."""

    refusal: str | None = None
    """Why the changed constant is impossible; None if it is not."""

    @property
    def name(self) -> str:
        """Name of its folder."""
        folder = f"{self.constant.slug}_{self.direction}"
        return f"sensitivity/{folder}/{self.experiment.name}"

    def study(self, seeds: tuple[int, ...]) -> Study:
        """Returns the trials to run; only for a variant that has conditions."""
        return Study(
            name=self.name,
            conditions=self.conditions,
            seeds=seeds,
            run=self.experiment.run,
        )


def variants(experiments: Iterable[Experiment]) -> tuple[Variant, ...]:
    """Returns every variant of some experiments, constant by constant.

    Args:
        experiments: Of which the conditions that a claim is about are varied.
    """
    chosen = {each.number: (each, claimed(each)) for each in experiments}
    every = [condition for _, found in chosen.values() for condition in found]
    return tuple(
        _variant(experiment, found, constant, direction)
        for constant in constants(every)
        for direction in FACTORS
        for experiment, found in chosen.values()
    )


def claimed(experiment: Experiment) -> tuple[Condition, ...]:
    """Returns the conditions that a claim is about, without mere controls."""
    named = {name for claim in experiment.claims for name in claim.measure.conditions}
    return tuple(c for c in experiment.conditions if c.name in named)


def _variant(
    experiment: Experiment,
    conditions: Sequence[Condition],
    constant: Constant,
    direction: str,
) -> Variant:
    scaled = [constant.scaled(c, FACTORS[direction]) for c in conditions]
    changed = tuple(condition for condition in scaled if condition is not None)
    refusal = next(filter(None, map(_refusal, changed)), None)
    return Variant(
        experiment=experiment,
        constant=constant,
        direction=direction,
        conditions=() if refusal else changed,
        refusal=refusal,
    )


def _refusal(condition: Condition) -> str | None:
    try:
        describe_condition(condition)
    except ValueError as error:  # what learners and households refuse
        return str(error)
    return None


def holding(
    variant: Variant, base: pl.DataFrame, out: Path, seeds: tuple[int, ...]
) -> Mapping[str, bool] | None:
    """Returns which claims hold in a variant; None if it is not finished.

    What was worked out once is kept beside the trials and worked out anew only if the
    seeds or the claims have changed.

    Args:
        variant: With its trials stored.
        base: The unchanged experiment's table, with the same seeds.
        out: The directory of all results.
        seeds: Which trials count.
    """
    if not variant.conditions:
        return holds(variant.experiment, base) if variant.refusal is None else {}
    results = Results(out / variant.name)
    study = variant.study(seeds)
    if not results.study_file.exists() or results.missing(study.trials()):
        return None
    kept = results.directory / "verdicts.json"
    fingerprint = _fingerprint(variant.experiment, seeds)
    known = _read(kept)
    if known.get("fingerprint") != fingerprint:
        changed = [condition.name for condition in variant.conditions]
        rest = base.filter(~pl.col("condition").is_in(changed))
        found = holds(variant.experiment, pl.concat([rest, results.read(study)]))
        known = {"fingerprint": fingerprint, "holds": found}
        write_text(kept, to_json(known))
    held: Mapping[str, bool] = known["holds"]
    return held


def holds(experiment: Experiment, frame: pl.DataFrame) -> dict[str, bool]:
    """Returns for each claim of an experiment whether it holds in a table."""
    return verdicts(_alone(claim).check(frame) for claim in experiment.claims)


def _alone(claim: Claim) -> Claim:
    return dataclasses.replace(claim, compared=(), reference=None)


def _fingerprint(experiment: Experiment, seeds: tuple[int, ...]) -> str:
    stated = [
        (c.id, c.condition, c.reading, c.rule, c.threshold, c.least)
        for c in experiment.claims
    ]
    return hashlib.sha256(repr((stated, seeds)).encode()).hexdigest()


def _read(path: Path) -> dict[str, Any]:
    if not path.exists():
        return {}
    known: dict[str, Any] = msgspec.json.decode(path.read_bytes())
    return known
