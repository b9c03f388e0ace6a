"""How long a study takes, said before it is run: from a timed sample."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean

from experiments.running.jobs import Job

SAMPLE = 12
"""Trials that are timed, spread evenly over the conditions (our choice)."""


@dataclass(frozen=True, kw_only=True)
class Plan:
    """What is to be run, and how long that takes."""

    trials: int
    """In all."""

    stored: int
    """That are there already."""

    timed: int
    """Trials that were timed."""

    seconds: float
    """Mean processor time of a trial [s]; 0 if nothing is left."""

    def hours(self, cores: int) -> float:
        """Returns how long the rest takes on so many cores like those here [h]."""
        return (self.trials - self.stored) * self.seconds / cores / 3600.0


def plan(trials: int, jobs: Sequence[Job], sample: int = SAMPLE) -> Plan:
    """Times some trials in this process, and throws their results away.

    What counts is processor time, so that others on the machine do not matter.

    The first one is run twice, and counts only the second time: what is compiled or
    read at first use is not a trial's price.

    Args:
        trials: How many there are, stored ones included.
        jobs: What is missing. Those that start from stored trials are run from the
            beginning, so that the plan never promises too little.
        sample: How many are timed at most.
    """
    n = min(sample, len(jobs))
    chosen = _spread(jobs, n)
    for job in chosen[:1]:
        job.run(job.trial)
    times = []
    for job in chosen:
        begun = time.process_time()
        job.run(job.trial)
        times.append(time.process_time() - begun)
    return Plan(
        trials=trials,
        stored=trials - len(jobs),
        timed=n,
        seconds=fmean(times) if times else 0.0,
    )


def _spread(jobs: Sequence[Job], n: int) -> list[Job]:
    """Returns some jobs, of as many conditions as there can be.

    They come seed by seed, and some learners take a hundred times as long as others.
    """
    places: dict[str, int] = {}
    for job in jobs:
        places.setdefault(job.trial.condition.name, len(places))
    ordered = sorted(jobs, key=lambda job: places[job.trial.condition.name])
    return [ordered[index * len(jobs) // n] for index in range(n)]
