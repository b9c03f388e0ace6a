"""Processes: how long starting takes, and trials per minute with several workers."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator

from experiments.bench.measurement import Measurement, Settings, ratios

IMPORT = "import household"
ENVIRONMENT = "import household.household_v0"
HELP = """
import contextlib, io
from experiments.cli import main
with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit):
    main(["--help"])
"""


def starting(settings: Settings) -> Iterator[Measurement]:
    """Yields the processor's time of fresh processes, the interpreter's included."""
    for name, code, most in (
        ("import household", IMPORT, 1.0),
        ("import household.household_v0", ENVIRONMENT, None),
        ("household --help", HELP, 0.5),
    ):
        yield Measurement(
            part="start",
            name=name,
            unit="s",
            values=tuple(_spent(code) for _ in range(settings.repetitions)),
            at_most=most,
        )


def _spent(code: str) -> float:
    process = subprocess.run(
        [sys.executable, "-c", f"{code}\nimport time; print(time.process_time())"],
        check=True,
        capture_output=True,
        text=True,
    )
    return float(process.stdout)


def trials(settings: Settings) -> Iterator[Measurement]:
    """Yields trials per minute with one and with two workers, in turn, by the clock."""
    rounds = [
        [_per_minute(workers, settings) for workers in (1, 2)]
        for _ in range(settings.repetitions)
    ]
    one, two = (list(rates) for rates in zip(*rounds, strict=True))
    for name, rates in (("1 worker", one), ("2 workers", two)):
        yield Measurement(
            part="trials", name=f"per minute, {name}", unit="1/min", values=tuple(rates)
        )
    yield Measurement(
        part="trials",
        name="2 workers / 1 worker",
        unit="x",
        values=ratios(two, one),
        at_least=1.8,
    )


def _per_minute(workers: int, settings: Settings) -> float:
    """Times some trials while every worker is busy.

    The time goes from when every worker has finished a trial, and so has begun, to
    when as many more as are counted are done, while every worker is still busy.
    """
    from experiments.running.engine import open_engine, run_trials
    from experiments.running.study import Condition, Trial
    from experiments.running.trial import run_trial

    condition = Condition(
        name="bench",
        scenario="experiment_2",
        learner="q_social",
        scenario_overrides={"max_cycles": settings.decisions},
    )
    n = settings.trials
    todo = [Trial(condition=condition, seed=seed) for seed in range(n + 2 * workers)]
    ends = []
    for outcome in run_trials(run_trial, todo, open_engine("local", workers)):
        if outcome.error:
            raise outcome.error
        ends.append(time.perf_counter())
    first = workers - 1
    return 60.0 * n / (ends[first + n] - ends[first])
