"""What is run: conditions, trials and the study they belong to, as plain records."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from experiments.errors import ExperimentError

if TYPE_CHECKING:
    import polars

LONGEST_NAME = 200
"""Of a condition [characters]: file systems have names of up to 255."""

_NAME = re.compile(rf"[a-z0-9][a-z0-9._+-]{{0,{LONGEST_NAME - 1}}}")


@dataclass(frozen=True, kw_only=True)
class Condition:
    """One cell of a study: which robots learn how, and in which home.

    Every value must be plain data (numbers, texts, lists, mappings), because the
    condition is written to `study.json` and sent to other processes.
    """

    name: str
    """Name within the study; also the name of its folder (a-z, 0-9, `._+-`)."""

    scenario: str
    """A built-in scenario's name or a path to a TOML file."""

    learner: str
    """A name from the learners' catalog."""

    scenario_overrides: Mapping[str, Any] = field(default_factory=dict)
    """Top-level scenario fields that differ from the scenario's own."""

    learner_overrides: Mapping[str, Any] = field(default_factory=dict)
    """Settings of the learner that differ from the catalog's; parts by name, as in
    `learners.components`."""

    factors: Mapping[str, str] = field(default_factory=dict)
    """Factor -> level, in a study that combines the levels of several factors; each
    factor is a column of the study's table."""

    def __post_init__(self) -> None:
        """Checks that the name can be a folder on every system, and what is text."""
        from household.errors import shown

        if not (isinstance(self.name, str) and _NAME.fullmatch(self.name)):
            raise ExperimentError(
                f"condition name {shown(self.name)}: use up to {LONGEST_NAME} of a-z, "
                "0-9, '.', '_', '+' and '-'."
            )
        for name in ("scenario", "learner"):
            if not isinstance(getattr(self, name), str):
                raise ExperimentError(
                    f"condition {self.name}: {name} {shown(getattr(self, name))} is no "
                    "name."
                )
        for name in ("scenario_overrides", "learner_overrides", "factors"):
            given = getattr(self, name)
            if not (
                isinstance(given, Mapping) and all(isinstance(k, str) for k in given)
            ):
                raise ExperimentError(
                    f"condition {self.name}: {name} {shown(given)} is no mapping from "
                    "names."
                )
        for name, level in self.factors.items():
            if not isinstance(level, str | int | float):
                raise ExperimentError(
                    f"condition {self.name}: level {shown(level)} of factor "
                    f"{shown(name)} is neither text nor a number."
                )


@dataclass(frozen=True, kw_only=True)
class Trial:
    """One condition run with one seed: the unit that is run, stored and resumed."""

    condition: Condition
    """What is run."""

    seed: int
    """Gives every random stream of the trial; the same seed pairs conditions."""

    def __str__(self) -> str:
        """Returns e.g. `asynchronous, seed 7`."""
        return f"{self.condition.name}, seed {self.seed}"


@dataclass(frozen=True, kw_only=True)
class Study:
    """A set of conditions, each run with each seed.

    The paper's experiments, the factorial, the sensitivity table and the
    generalization studies differ only in what they put here.
    """

    name: str
    """Name of the study; also the name of its folder."""

    conditions: tuple[Condition, ...]
    """What is compared, in the order of presentation."""

    seeds: tuple[int, ...]
    """The seeds that each condition is run with."""

    run: Callable[..., polars.DataFrame]
    """Runs one trial; at the top of a module, so that other processes can import it."""

    start: Callable[[Trial], tuple[str, Trial] | None] | None = None
    """Says which trial of which study a trial starts from; `run` then gets that one's
    table as well. What comes out must be the same without it."""

    describe: Callable[[Condition], Mapping[str, Any]] | None = None
    """Everything that a condition fixes, as plain data; None: its learner and its
    scenario."""

    columns: tuple[str, ...] = ()
    """Columns that every trial's table has, among others; checked when it is read."""

    def __post_init__(self) -> None:
        """Checks names and seeds."""
        names = [condition.name for condition in self.conditions]
        if not names or len(set(names)) < len(names):
            raise ExperimentError(
                f"study {self.name!r}: conditions need different names, got {names}."
            )
        if (
            not self.seeds
            or not all(type(seed) is int and seed >= 0 for seed in self.seeds)
            or len(set(self.seeds)) < len(self.seeds)
        ):
            raise ExperimentError(
                f"study {self.name!r} needs different seeds, 0 or larger, at least one."
            )

    def trials(self) -> tuple[Trial, ...]:
        """Returns every trial, seed by seed, so that conditions fill up together."""
        return tuple(
            Trial(condition=condition, seed=seed)
            for seed in self.seeds
            for condition in self.conditions
        )
