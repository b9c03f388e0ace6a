"""Steps of households: what they take, beside physics and peers, and how it grows."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from experiments.bench.homes import FOREVER, Stepping, household
from experiments.bench.measure import (
    Measure,
    Settings,
    alternate,
    microseconds,
    ratios,
)
from experiments.bench.peers import installed

if TYPE_CHECKING:
    from household.environment import Household

BEINGS = 6
"""Four people and two robots, as many as the peers move."""

STEPS_PER_WRITE = 2000
"""Steps between writes to a replay file, for 100 steps in a repetition."""

OURS = "household, 4 people + 2 robots"
MPE2 = "mpe2 simple_spread_v3"


def beside_physics(settings: Settings) -> Iterator[Measure]:
    """Yields the share of a step that the physics engine takes."""
    env = _evening()
    spent: list[float] = []
    with _timed_physics(env, spent):
        step = Stepping(env)
        rounds = []
        for _ in range(settings.repetitions):
            spent.clear()
            begin = time.process_time()
            for _ in range(settings.steps):
                step()
            # The median call, since other work on the machine may interrupt a few.
            inside = statistics.median(spent) * len(spent) if spent else math.nan
            rounds.append((time.process_time() - begin, inside))
    physics = [inside / settings.steps for _, inside in rounds]
    whole = [total / settings.steps for total, _ in rounds]
    yield Measure(
        part="physics",
        name="the calls of Space.step in one step",
        unit="us",
        values=microseconds(physics),
    )
    yield Measure(
        part="physics",
        name="step / Space.step",
        unit="x",
        values=ratios(whole, physics),
        at_most=3.0,
    )


@contextmanager
def _timed_physics(env: Household, spent: list[float]) -> Iterator[None]:
    """Notes what each call of the engine takes; wall time, which costs least to ask."""
    space = env.life.crowd.space
    step = space.step

    def timed(tick: float) -> None:
        begin = time.perf_counter()
        step(tick)
        spent.append(time.perf_counter() - begin)

    space.step = timed  # type: ignore[assignment, method-assign] # only while it is measured
    try:
        yield
    finally:
        del space.step


def beside_peers(settings: Settings) -> Iterator[Measure]:
    """Yields steps of ours and of every peer that is installed, in turn."""
    peers = {peer.name: peer for peer in installed(BEINGS)}
    calls = {name: peer.step for name, peer in peers.items()}
    times = alternate(
        {OURS: Stepping(_evening()), **calls}, settings.repetitions, settings.steps
    )
    lasts = {OURS: 1.0} | {name: peer.period for name, peer in peers.items()}
    for name, seconds in times.items():
        yield Measure(part="step", name=name, unit="us", values=microseconds(seconds))
    for name, seconds in times.items():
        yield Measure(
            part="agent-seconds per second",
            name=name,
            unit="1/s",
            values=tuple(BEINGS * lasts[name] / each for each in seconds),
        )
    if MPE2 in times:
        yield Measure(
            part="step",
            name=f"steps per second, ours / {MPE2}",
            unit="x",
            values=ratios(times[MPE2], times[OURS]),
            at_least=10.0,
        )


def recording(settings: Settings) -> Iterator[Measure]:
    """Yields what a replay file adds to a step."""
    from household.replay.wrapper import RecordEpisodes

    calls = settings.steps * STEPS_PER_WRITE // 100
    with TemporaryDirectory() as folder:
        recorder = RecordEpisodes(_evening(), Path(folder), flush_every=calls)
        subjects = {"plain": Stepping(_evening()), "recorded": Stepping(recorder)}
        times = alternate(subjects, settings.repetitions, calls)
        recorder.close()
    yield Measure(
        part="recording",
        name="recorded step / plain step",
        unit="x",
        values=ratios(times["recorded"], times["plain"]),
        at_most=1.2,
    )


def growth(settings: Settings) -> Iterator[Measure]:
    """Yields the time of a step against people, robots and walls."""
    people = {n: household(n, 2) for n in settings.people}
    yield from _against("people, with 2 robots", people, settings)
    robots = {n: household(4, n) for n in settings.robots}
    yield from _against("robots, with 4 people", robots, settings)
    yield from _against("walls, with 4 people + 2 robots", _homes(settings), settings)
    most = household(max(settings.people), max(settings.robots))
    subjects = {"large": Stepping(most), "small": Stepping(household(4, 2))}
    times = alternate(subjects, settings.repetitions, settings.steps)
    large = f"{max(settings.people)} people + {max(settings.robots)} robots"
    yield Measure(
        part="growth", name=large, unit="us", values=microseconds(times["large"])
    )
    yield Measure(
        part="growth",
        name=f"{large} / 4 people + 2 robots",
        unit="x",
        values=ratios(times["large"], times["small"]),
        at_most=20.0,
    )


def _homes(settings: Settings) -> dict[int, Household]:
    """Households in generated homes, by the number of walls and sides of furniture."""
    from household.home.generator import generate

    plans = [generate(1, rooms=rooms) for rooms in settings.rooms]
    return {len(plan.solid_segments): household(4, 2, plan) for plan in plans}


def _against(
    what: str, homes: dict[int, Household], settings: Settings
) -> Iterable[Measure]:
    subjects = {str(n): Stepping(env) for n, env in homes.items()}
    times = alternate(subjects, settings.repetitions, settings.steps)
    for n in homes:
        yield Measure(
            part=f"step against {what}",
            name=str(n),
            unit="us",
            values=microseconds(times[str(n)]),
            x=n,
        )


def _evening() -> Household:
    from household import household_v0

    return household_v0.parallel_env("evening", max_cycles=FOREVER)
