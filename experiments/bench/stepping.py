"""Steps of households: how long they take, beside peers, and how that grows."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np

from experiments.bench.homes import (
    BEINGS,
    PatientStepping,
    Stepping,
    evening,
    household,
)
from experiments.bench.inside import ten_ticks
from experiments.bench.measurement import (
    SHORT_TURNS,
    Growth,
    Measurement,
    Settings,
    alternate,
    exponent,
    microseconds,
    ratios,
)
from experiments.bench.peers import installed

if TYPE_CHECKING:
    from household.environment import Household

OURS = "household, 4 people + 2 robots"
RESTLESS = "the same, robots never finish"
MPE2 = "mpe2 simple_spread_v3"


def beside_peers(settings: Settings) -> Iterator[Measurement]:
    """Yields steps of ours and of every peer that is installed, in turn.

    Ours are stepped twice: with robots that finish what they do, as `policies.learning`
    has it, and with robots that begin another behavior in every step, which annoys
    people so much that they walk to the robots all the time.
    """
    peers = {peer.name: peer for peer in installed(BEINGS)}
    calls = {name: peer.step for name, peer in peers.items()}
    ours = {OURS: PatientStepping(evening()), RESTLESS: Stepping(evening())}
    times = alternate({**ours, **calls}, settings.repetitions, settings.steps)
    lasts = dict.fromkeys(ours, 1.0) | {n: peer.period for n, peer in peers.items()}
    for name, seconds in times.items():
        yield Measurement(
            part="step", name=name, unit="us", values=microseconds(seconds)
        )
    for name, seconds in times.items():
        yield Measurement(
            part="agent-seconds per second",
            name=name,
            unit="1/s",
            values=tuple(BEINGS * lasts[name] / each for each in seconds),
        )
    if MPE2 in times:
        for name, what in ((OURS, "ours"), (RESTLESS, "never finishing")):
            yield Measurement(
                part="step",
                name=f"steps per second, {what} / mpe2",
                unit="x",
                values=ratios(times[MPE2], times[name]),
                at_least=10.0,
            )


def recording(settings: Settings) -> Iterator[Measurement]:
    """Yields what a replay file adds to a step, by the clock and in processor time.

    Other threads make columns and write them while the next steps are made. A
    repetition lasts until they are done, so that both times contain all of it; 1000
    steps in a repetition stand for the number after which a recorder writes by default,
    and the writing begins in the middle of a repetition.
    """
    from household.replay.buffer import FLUSH_EVERY
    from household.replay.wrapper import RecordEpisodes

    calls = settings.steps * FLUSH_EVERY // 1000
    with TemporaryDirectory() as folder:
        recorder = RecordEpisodes(evening(), Path(folder), flush_every=calls)
        plain, recorded = PatientStepping(evening()), PatientStepping(recorder)
        for _ in range(calls // 2):
            recorded()
        rounds = [
            _recorded(plain, recorded, recorder.wait, calls)
            for _ in range(1 + settings.repetitions)
        ]
        recorder.close()
    clock, processor = zip(*rounds[1:], strict=True)
    yield Measurement(
        part="recording",
        name="recorded step / plain step",
        unit="x",
        values=clock,
        at_most=1.2,
    )
    yield Measurement(
        part="recording",
        name="the same, with other threads",
        unit="x",
        values=processor,
    )


def _recorded(
    plain: Stepping, recorded: Stepping, wait: Callable[[], None], calls: int
) -> tuple[float, float]:
    """Returns how many times as long recorded steps take, by the clock and processor.

    Args:
        plain: Makes a step that is not recorded.
        recorded: Makes one that is.
        wait: Waits for what still goes on in other threads.
        calls: How many of each.
    """
    spent = np.zeros((2, 2))
    for which, step in enumerate((plain, recorded)):
        begin, busy = time.perf_counter(), time.process_time()
        for _ in range(calls):
            step()
        wait()
        spent[which] = time.perf_counter() - begin, time.process_time() - busy
    clock, processor = (spent[1] / spent[0]).tolist()
    return clock, processor


def growth(settings: Settings) -> Iterator[Measurement]:
    """Yields the time of a step against people, robots and walls."""
    for what, homes, at_most in (
        ("people, with 2 robots", {n: household(n, 2) for n in settings.people}, 2.0),
        ("robots, with 4 people", {n: household(4, n) for n in settings.robots}, 2.0),
        ("walls, with 4 people + 2 robots", _homes(settings), 1.0),
    ):
        found = list(_against(what, homes, settings))
        yield from (*found, exponent(found, at_most))
    yield from _largest(settings)


def _largest(settings: Settings) -> Iterator[Measurement]:
    """Yields the largest household, stepped in both ways.

    Beside it stands the usual one, and T: ten ticks of the engine in a loop.
    """
    n_people, n_robots = max(settings.people), max(settings.robots)
    large = f"{n_people} + {n_robots}"
    for stepping, how, at_most in (
        (PatientStepping, "", 60.0),
        (Stepping, ", never finishing", 85.0),
    ):
        subjects = {
            "large": stepping(household(n_people, n_robots)),
            "small": stepping(household(4, 2)),
        }
        engine = ten_ticks(settings)
        times = alternate(subjects, settings.repetitions, settings.steps, SHORT_TURNS)
        yield Measurement(
            part="largest household",
            name=f"{large}{how}",
            unit="us",
            values=microseconds(times["large"]),
        )
        yield Measurement(
            part="largest household",
            name=f"that / T{how}",
            unit="x",
            values=ratios(times["large"], engine),
            at_most=at_most,
        )
        yield Measurement(
            part="largest household",
            name=f"that / 4 + 2{how}",
            unit="x",
            values=ratios(times["large"], times["small"]),
            at_most=20.0,
        )


def _homes(settings: Settings) -> dict[int, Household]:
    """Households in generated homes, by the number of walls and sides of furniture."""
    from household.home.sources.generator import generate

    plans = [generate(1, rooms=rooms) for rooms in settings.rooms]
    return {len(plan.solid_segments): household(4, 2, plan) for plan in plans}


def _against(
    what: str, homes: dict[int, Household], settings: Settings
) -> Iterator[Measurement]:
    """Yields the time of a step in each of some households, measured in turn."""
    subjects = {str(n): Stepping(env) for n, env in homes.items()}
    times = alternate(subjects, settings.repetitions, settings.steps)
    for n in homes:
        growth = Growth(what="step", against=what, x=n)
        yield Measurement(
            part=growth.part,
            name=str(n),
            unit="us",
            values=microseconds(times[str(n)]),
            growth=growth,
        )
