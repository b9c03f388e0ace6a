"""Processes: how long starting takes, and trials per minute with several workers."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator

from experiments.bench.measure import Measure, Settings

IMPORT = "import household"
ENVIRONMENT = "import household.household_v0"
HELP = """
import contextlib, io
from experiments.cli import main
with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit):
    main(["--help"])
"""

DECISIONS = 1500
"""In each of the trials."""


def starting(settings: Settings) -> Iterator[Measure]:
    """Yields the processor's time of fresh processes, the interpreter's included."""
    for name, code, most in (
        ("import household", IMPORT, 1.0),
        ("import household.household_v0", ENVIRONMENT, None),
        ("household --help", HELP, 0.5),
    ):
        yield Measure(
            part="start",
            name=name,
            unit="s",
            values=tuple(_spent(code) for _ in range(settings.repetitions)),
            at_most=most,
        )


def _spent(code: str) -> float:
    told = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport time; print(time.process_time())"],
        check=True,
        capture_output=True,
        text=True,
    )
    return float(told.stdout)


def trials(settings: Settings) -> Iterator[Measure]:
    """Yields trials per minute with one and with two workers, by the clock."""
    rates = {workers: _per_minute(workers, settings.trials) for workers in (1, 2)}
    for workers, rate in rates.items():
        yield Measure(
            part="trials",
            name=f"per minute, {workers} worker{'s' if workers > 1 else ''}",
            unit="1/min",
            values=(rate,),
        )
    yield Measure(
        part="trials",
        name="2 workers / 1 worker",
        unit="x",
        values=(rates[2] / rates[1],),
        at_least=1.8,
    )


def _per_minute(workers: int, n: int) -> float:
    """Counts from when every worker has finished its first trial, and so has begun."""
    from experiments.engine import open_engine, run_trials
    from experiments.runner import run_trial
    from experiments.trial import Condition, Trial

    condition = Condition(
        name="bench",
        scenario="experiment_2",
        learner="q_social",
        scenario_overrides={"max_cycles": DECISIONS},
    )
    todo = [Trial(condition=condition, seed=seed) for seed in range(n + workers)]
    ends = []
    for outcome in run_trials(run_trial, todo, open_engine("local", workers)):
        if outcome.error:
            raise outcome.error
        ends.append(time.perf_counter())
    return 60.0 * n / (ends[-1] - ends[workers - 1])
