"""Maps: where claims hold, over two constants at once.

A sensitivity table varies one constant at a time, a little. A map goes far along two.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import product

import polars as pl

from experiments.analysis.claims import Claim, Finding
from experiments.paper import EXPERIMENTS
from experiments.running.study import Condition, Study, Trial
from experiments.running.trial import run_trial
from experiments.studies.varying import (
    ATTENTION,
    HABITUATION,
    NOTICE_DELAY,
    NOTICE_NOISE,
    TEMPERATURE,
    WATCHING,
    Axis,
)

SEEDS = 20
"""Trials of each cell unless said otherwise."""

Levels = tuple[float, float]
"""A cell: a level of the horizontal axis and one of the vertical axis."""


@dataclass(frozen=True, kw_only=True)
class Map:
    """Two axes and the claims that are looked at over both."""

    name: str
    """Of its folder."""

    title: str
    """What is mapped, in a few words."""

    number: int
    """Of the experiment."""

    ids: tuple[str, ...]
    """Of the claims; of several with one id, the first is taken."""

    across: Axis
    """The horizontal axis."""

    up: Axis
    """The vertical axis."""

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What is claimed, in the order of `ids`."""
        claims = EXPERIMENTS[self.number].claims
        return tuple(next(c for c in claims if c.id == id) for id in self.ids)

    @property
    def base(self) -> Condition:
        """The condition that the claims are about."""
        (name,) = {name for claim in self.claims for name in claim.measure.conditions}
        return EXPERIMENTS[self.number].condition(name)

    @property
    def cells(self) -> tuple[Levels, ...]:
        """Every pair of levels."""
        return tuple(product(self.across.levels, self.up.levels))

    @property
    def usual(self) -> Levels:
        """Where the experiment itself lies."""
        return self.across.usual, self.up.usual

    def condition(self, levels: Levels) -> Condition:
        """Returns the condition of a cell."""
        varied = self.up.vary(self.across.vary(self.base, levels[0]), levels[1])
        axes = (self.across.name, self.up.name)
        factors = dict(zip(axes, map(as_text, levels), strict=True))
        name = "+".join(f"{axis}_{level}" for axis, level in factors.items())
        return dataclasses.replace(varied, name=name, factors=factors)

    def study(self, seeds: tuple[int, ...]) -> Study:
        """Returns the trials to run."""
        return Study(
            name=f"maps/{self.name}",
            conditions=tuple(map(self.condition, self.cells)),
            seeds=seeds,
            run=partial(run_cell, name=self.name),
        )

    def findings(self, frame: pl.DataFrame) -> Mapping[tuple[str, Levels], Finding]:
        """Returns what came of each claim in each cell.

        Args:
            frame: The study's table.
        """
        found = {}
        for levels in self.cells:
            name = self.condition(levels).name
            rows = frame.filter(pl.col("condition") == name).sort("seed")
            for claim in self.claims:
                values = rows[claim.id].cast(pl.Float64).to_numpy()
                found[claim.id, levels] = claim.judge(values)
        return found


def as_text(level: float) -> str:
    """Returns a level in two digits, without zeros at the end."""
    return f"{level:.2f}".rstrip("0").rstrip(".")


def run_cell(trial: Trial, name: str) -> pl.DataFrame:
    """Runs a trial and keeps what claims measure of it.

    Args:
        trial: A cell with a seed.
        name: Of the map.

    Returns:
        One row with a column for each claim; NaN where there was nothing to measure.
    """
    mapped = MAPS[name]
    followed = EXPERIMENTS[mapped.number].target_situations
    frame = run_trial(trial, followed=followed).with_columns(
        condition=pl.lit(mapped.base.name), seed=pl.lit(trial.seed)
    )
    found = {claim.id: float(claim.measure.values(frame)[0]) for claim in mapped.claims}
    return pl.DataFrame([found], schema=dict.fromkeys(found, pl.Float64))


MAPS: Mapping[str, Map] = {
    each.name: each
    for each in (
        Map(
            name="attention",
            title="Standard Q-learning: exploration and attention",
            number=1,
            ids=("1a", "1b"),
            across=TEMPERATURE,
            up=ATTENTION,
        ),
        Map(
            name="approach",
            title="Designated credit: how late and how exactly an approach is noticed",
            number=4,
            ids=("4a", "4b"),
            across=NOTICE_DELAY,
            up=NOTICE_NOISE,
        ),
        Map(
            name="watching",
            title="Two people: who watches, and who gets used to politeness",
            number=5,
            ids=("5a", "5b"),
            across=WATCHING,
            up=HABITUATION,
        ),
    )
}
"""By name."""
