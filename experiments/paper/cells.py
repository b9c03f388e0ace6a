"""The 28 situations of experiment 5, counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import NamedTuple

import polars as pl

from experiments.analysis.tables import Entry, Table

ACTIVITIES = (
    "entering",
    "working",
    "sleeping",
    "reading",
    "calling",
    "playing",
    "unknown",
)
"""The five of the script, then the two that are passed through."""

PEOPLE = ("ann", "bob")
"""In phase 1 the first is to read, in phase 2 the second."""


class Cell(NamedTuple):
    """One of the 28 situations."""

    reader: str
    """Who reads."""

    activity: str
    """What the other does."""

    attends: bool
    """Whether the other attends to the robot."""


CELLS = tuple(
    Cell(reader, activity, attends)
    for reader in PEOPLE
    for activity in ACTIVITIES
    for attends in (True, False)
)


def reached(frame: pl.DataFrame, phase: float) -> Mapping[Cell, int]:
    """Returns how many history entries lie in each of the 28 situations.

    Args:
        frame: The table of some trials of experiment 5.
        phase: When the roles are inverted [s]. Where both read, the task of the phase
            tells who is meant as the reader.
    """
    counts: Counter[Cell] = Counter()
    first = pl.col("time") < phase
    grouped = frame.group_by("situation", first.alias("first")).len()
    for situation, is_first, count in grouped.iter_rows():
        cell = _cell(situation, PEOPLE[0] if is_first else PEOPLE[1])
        if cell is not None:
            counts[cell] += count
    return counts


def seeds_reaching(frame: pl.DataFrame, phase: float) -> Mapping[Cell, int]:
    """Returns in how many seeds each of the 28 situations is reached at all."""
    counts: Counter[Cell] = Counter()
    for trial in frame.partition_by("seed"):
        counts.update(reached(trial, phase).keys())
    return counts


def table(frame: pl.DataFrame, phase: float) -> Table:
    """Returns how often each of the 28 situations was reached.

    Args:
        frame: The table of a study, of one condition.
        phase: When the roles are inverted. [s]
    """
    counts, seeds = reached(frame, phase), seeds_reaching(frame, phase)
    n = frame["seed"].n_unique()
    columns = [(reader, attends) for reader in PEOPLE for attends in (True, False)]

    def entry(cell: Cell) -> Entry:
        said = f"{counts.get(cell, 0) / n:.1f} ({seeds.get(cell, 0)})"
        return Entry(text=said, shade=seeds.get(cell, 0) / n)

    return Table(
        name="situations",
        title="The 28 situations: how often each is reached",
        header=(
            "the other is",
            *(
                f"{reader} reads, the other {'attends' if attends else 'does not'}"
                for reader, attends in columns
            ),
        ),
        rows=tuple(
            (
                activity,
                tuple(entry(Cell(one, activity, looks)) for one, looks in columns),
            )
            for activity in ACTIVITIES
        ),
        note=(
            "History entries per seed, and in brackets in how many seeds the situation "
            f"is reached at all (of {n})."
        ),
    )


def _cell(situation: str, asked: str) -> Cell | None:
    """Returns the cell that a situation, as text, lies in; None if nobody reads."""
    facts = situation.split(", ")
    roles = dict(fact.split() for fact in facts if ">" not in fact)
    reading = [person for person in PEOPLE if roles[person] == "reading"]
    if not reading:
        return None
    reader = asked if asked in reading else reading[0]
    other = PEOPLE[1 - PEOPLE.index(reader)]
    attends = any(fact.startswith(f"{other} > robot") for fact in facts)
    return Cell(reader, roles[other], attends)
