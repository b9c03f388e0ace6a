"""Teachers of several kinds: under which of them the paper's claims hold.

The paper's people sanction faults and hardly praise; those of other studies did the
opposite (docs/people.md). Here each experiment is run with people who give feedback
like one of the shipped teachers. Where they go and where they look stays as it was.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import msgspec
import polars as pl

from experiments.analysis.claims import Claim, Finding
from experiments.paper import EXPERIMENTS, Experiment
from experiments.running.study import Condition, Study
from experiments.studies.sensitivity import claimed
from experiments.studies.varying import people_of, with_people
from household.scenario.persona import load_persona

OWN = "own"
"""The experiment's own people."""

TEACHERS = (OWN, "praising", "fading", "mistaken", "skipping", "noisy", "myopic")
"""Whose feedback people give."""

FEEDBACK = (
    *("praise", "sanction", "habituation", "recovery", "contrast"),
    *("tolerance", "mistakes", "doubt", "myopia", "irritability"),
)
"""What makes a teacher, of all that makes a persona."""


def taught(condition: Condition, teacher: str) -> Condition:
    """Returns a condition whose people give feedback like a teacher.

    Args:
        condition: Of an experiment.
        teacher: One of `TEACHERS`.
    """
    factors = {"teacher": teacher, "of": condition.name}
    name = f"{teacher}+{condition.name}"
    if teacher != OWN:
        like = msgspec.to_builtins(load_persona(teacher))
        people = people_of(condition)
        for person in people:
            person["persona"] |= {trait: like[trait] for trait in FEEDBACK}
        condition = with_people(condition, people)
    return dataclasses.replace(condition, name=name, factors=factors)


def study(number: int, seeds: tuple[int, ...]) -> Study:
    """Returns the trials of an experiment's claims with every teacher.

    Args:
        number: Of the experiment.
        seeds: The same for all.
    """
    experiment = EXPERIMENTS[number]
    return Study(
        name=f"maps/teachers_{number}",
        conditions=tuple(
            taught(condition, teacher)
            for teacher in TEACHERS
            for condition in claimed(experiment)
        ),
        seeds=seeds,
        run=experiment.run,
    )


def mapped(experiment: Experiment) -> tuple[Claim, ...]:
    """Returns the claims that people have a part in; 4c needs no trials."""
    return tuple(claim for claim in experiment.claims if claim.measure.conditions)


def findings(number: int, frame: pl.DataFrame) -> Mapping[str, tuple[Finding, ...]]:
    """Returns what came of an experiment's claims, by teacher.

    Args:
        number: Of the experiment.
        frame: The study's table.
    """
    alone = [
        dataclasses.replace(claim, compared=(), reference=None)
        for claim in mapped(EXPERIMENTS[number])
    ]
    found = {}
    for teacher in TEACHERS:
        trials = frame.filter(teacher=teacher).with_columns(condition=pl.col("of"))
        found[teacher] = tuple(claim.check(trials) for claim in alone)
    return found
