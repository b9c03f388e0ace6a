"""The 28 situations of experiment 5, in which somebody reads, counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import NamedTuple

import polars as pl

from experiments.analysis.tables import Cell, Table

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
"""In phase 1 it is the task of the first to read, in phase 2 of the second."""


class ReadingSituation(NamedTuple):
    """One of the 28 situations."""

    reader: str
    """Who reads."""

    activity: str
    """What the other does."""

    attends: bool
    """Whether the other attends to the robot."""


SITUATIONS = tuple(
    ReadingSituation(reader, activity, attends)
    for reader in PEOPLE
    for activity in ACTIVITIES
    for attends in (True, False)
)


def reached(frame: pl.DataFrame, phase: float) -> Mapping[ReadingSituation, int]:
    """Returns how many history entries lie in each of the 28 situations.

    Args:
        frame: The table of some trials of experiment 5.
        phase: When the roles are inverted [s]. Where both read, the task of the phase
            decides who counts as the reader.
    """
    counts: Counter[ReadingSituation] = Counter()
    grouped = frame.group_by("situation", pl.col("time") < phase).agg(
        pl.col("roles", "attention").first(), pl.len().alias("entries")
    )
    for _, is_first, roles, attention, entries in grouped.iter_rows():
        plays = {one["actor"]: one["role"] for one in roles}
        watching = {a["observer"] for a in attention if a["target"] not in plays}
        found = _situation(plays, watching, PEOPLE[0] if is_first else PEOPLE[1])
        if found is not None:
            counts[found] += entries
    return counts


def seeds_reaching(frame: pl.DataFrame, phase: float) -> Mapping[ReadingSituation, int]:
    """Returns in how many seeds each of the 28 situations is reached at all."""
    counts: Counter[ReadingSituation] = Counter()
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

    def cell(situation: ReadingSituation) -> Cell:
        in_seeds = seeds.get(situation, 0)
        text = f"{counts.get(situation, 0) / n:.1f} ({in_seeds})"
        return Cell(text=text, shade=in_seeds / n)

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
                tuple(
                    cell(ReadingSituation(reader, activity, attends))
                    for reader, attends in columns
                ),
            )
            for activity in ACTIVITIES
        ),
        note=(
            "History entries per seed, and in brackets in how many seeds the situation "
            f"is reached at all (of {n})."
        ),
    )


def _situation(
    plays: Mapping[str, str], watching: set[str], asked: str
) -> ReadingSituation | None:
    """Returns which of the 28 situations it is; None if nobody reads.

    Args:
        plays: Role by person.
        watching: Who attends to the robot.
        asked: Whose task it is to read.
    """
    readers = [person for person in PEOPLE if plays[person] == "reading"]
    if not readers:
        return None
    reader = asked if asked in readers else readers[0]
    other = PEOPLE[1 - PEOPLE.index(reader)]
    return ReadingSituation(reader, plays[other], other in watching)
