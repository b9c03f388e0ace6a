"""Whole trials, with learners and their table, beside as many bare steps."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping

from experiments.bench.homes import PatientStepping, evening
from experiments.bench.measurement import Measurement, Settings, ratios

PART = "trial of evening"

WARM_UP = 100
"""Decisions of a trial of each learner before the first that is measured."""

AT_MOST: Mapping[str, float] = {
    "random": 4.0,
    "designated": 4.0,
    "designated_canonical": 12.0,
    "designated_adaptive": 12.0,
    "full_sharing": 12.0,
    "hierarchical_thompson": 12.0,
}
"""Learner -> how many times as long as the bare steps a trial may take. The last one is
the dearest of the catalog."""


def beside_steps(settings: Settings) -> Iterator[Measurement]:
    """Yields the time of trials and of as many bare steps with random actions, in turn.

    The robots of the bare steps finish what they do, as those of the trials.
    """
    step = PatientStepping(evening())
    _steps(step, settings.trial_decisions)
    for learner in AT_MOST:
        _trial(learner, 0, min(settings.trial_decisions, WARM_UP))
    bare: list[float] = []
    trials: dict[str, list[float]] = {learner: [] for learner in AT_MOST}
    for seed in range(settings.repetitions):
        bare.append(_steps(step, settings.trial_decisions))
        for learner, seconds in trials.items():
            seconds.append(_trial(learner, seed, settings.trial_decisions))
    yield Measurement(
        part=PART,
        name="bare steps, random actions",
        unit="ms",
        values=tuple(1e3 * seconds for seconds in bare),
    )
    for learner, at_most in AT_MOST.items():
        yield Measurement(
            part=PART,
            name=f"{learner} / bare",
            unit="x",
            values=ratios(trials[learner], bare),
            at_most=at_most,
        )


def _steps(step: PatientStepping, steps: int) -> float:
    begin = time.process_time()
    for _ in range(steps):
        step()
    return time.process_time() - begin


def _trial(learner: str, seed: int, decisions: int) -> float:
    from experiments.running.study import Condition, Trial
    from experiments.running.trial import run_trial

    condition = Condition(
        name="bench",
        scenario="evening",
        learner=learner,
        scenario_overrides={"max_cycles": decisions},
    )
    begin = time.process_time()
    run_trial(Trial(condition=condition, seed=seed))
    return time.process_time() - begin
