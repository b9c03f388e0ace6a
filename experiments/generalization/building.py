"""Builds the conditions of a study: learners times what is varied."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

from experiments.generalization.learners import REFERENCES, settings, slug
from experiments.phases.records import Phases, Probing, Training

Levels = TypeVar("Levels", bound=tuple[str, ...])
"""One level of each factor."""


def every(
    learners: Iterable[str],
    cases: Mapping[Levels, tuple[Training, Probing]],
    factors: tuple[str, ...],
    references: Iterable[str] = REFERENCES,
) -> tuple[Phases, ...]:
    """Returns a condition for each learner in each case.

    Args:
        learners: Names in `learners.LEARNERS` and `learners.NETWORKS`.
        cases: Levels of the factors -> what is trained and what is probed.
        factors: Their names; the learner is a further one.
        references: Policies that are probed beside them, without training. They do not
            learn, so they are probed once only.
    """
    known = settings(learners)
    beside = {name: (name, dict[str, object]()) for name in references}
    return tuple(
        Phases(
            name="-".join(map(slug, (name, *levels))),
            learner=learner,
            learner_overrides=overrides,
            factors={"learner": name, **dict(zip(factors, levels, strict=True))},
            training=training,
            probing=_once(probing) if name in beside else probing,
        )
        for levels, (training, probing) in cases.items()
        for name, (learner, overrides) in (known | beside).items()
    )


def with_plenty(training: Training) -> Training:
    """Returns a training that is ten times as long as others, in more households."""
    return replace(training, households=8, decisions=4_000)


def _once(probing: Probing) -> Probing:
    return replace(probing, touches=probing.touches[:1])
