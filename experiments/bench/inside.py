"""Inside a step: how much the physics engine takes, and which part takes how much."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from itertools import cycle
from operator import attrgetter
from typing import TYPE_CHECKING

from experiments.bench.homes import BEINGS, PatientStepping, Stepping, evening
from experiments.bench.measurement import Measurement, Settings, microseconds, ratios

if TYPE_CHECKING:
    from household.environment import Household

PARTS = {
    "robots set out": "simulation.move_robots",
    "paths are found": "simulation.find_paths",
    "everybody walks, people touch": "simulation.walk_and_touch",
    "heads turn": "simulation.turn_heads",
    "everybody perceives": "simulation.perceive",
    "people appraise": "simulation.appraise",
    "people decide and set out": "simulation.decide",
    "observations, infos": "_results",
}
"""The parts of a step, and the methods of the environment that do them."""

PACE = 1.0
"""At which everybody walks where the engine is measured alone [m/s]."""


def physics(settings: Settings) -> Iterator[Measurement]:
    """Yields how a step compares to the engine's own work in as many ticks.

    The engine is measured in ten ticks in which all six bodies walk: in a loop, where
    the processor's caches hold all that it needs, and once after each step, where they
    hold what the step left, as they would if steps called it. A step itself calls it
    for encounters only.
    """
    step, walk = PatientStepping(evening()), _walk(evening())
    for _ in range(settings.steps):
        step()
    loops, steps, walks = list[float](), list[float](), list[float]()
    for _ in range(settings.repetitions):
        loops.append(_in_a_loop(walk, settings))
        each = [(_timed_step(step), walk()) for _ in range(settings.steps)]
        in_steps, in_walks = zip(*each, strict=True)
        steps.append(sum(in_steps) / settings.steps)
        walks.append(sum(in_walks) / settings.steps)
    for name, values in (
        ("10 x Space.step, in a loop", loops),
        ("10 x Space.step, after a step", walks),
    ):
        yield Measurement(
            part="physics", name=name, unit="us", values=microseconds(values)
        )
    yield Measurement(
        part="physics",
        name="step / 10 x Space.step",
        unit="x",
        values=ratios(steps, walks),
        at_most=3.0,
    )
    yield Measurement(
        part="physics",
        name="the same, beside the loop",
        unit="x",
        values=ratios(steps, loops),
        at_most=3.0,
    )


def ten_ticks(settings: Settings) -> list[float]:
    """Times ten ticks of the engine in which six bodies walk, in a loop [s].

    The unit of the budgets, which follows the speed of the machine.
    """
    walk = _walk(evening())
    return [_in_a_loop(walk, settings) for _ in range(settings.repetitions)]


def _in_a_loop(walk: Callable[[], float], settings: Settings) -> float:
    # The median, since other work on the machine may interrupt a few.
    return statistics.median(walk() for _ in range(settings.steps))


def _timed_step(step: Stepping) -> float:
    """Makes a step and returns how long it took [s]."""
    begin = time.perf_counter()
    step()
    return time.perf_counter() - begin


def _walk(env: Household) -> Callable[[], float]:
    """Returns a function that times the engine while all walk for a decision period.

    All walk in different directions, and back in the next period.
    """
    env.reset(seed=0)
    space, scenario = env.simulation.crowd.space, env.scenario
    ticks = range(round(scenario.decision_period / scenario.physics_period))
    angles = [2 * math.pi * i / BEINGS for i in range(BEINGS)]
    signs = cycle((PACE, -PACE))

    def walk() -> float:
        pace = next(signs)
        for body, angle in zip(space.bodies, angles, strict=True):
            body.velocity = pace * math.cos(angle), pace * math.sin(angle)
        begin = time.perf_counter()
        for _ in ticks:
            space.step(scenario.physics_period)
        return time.perf_counter() - begin

    return walk


def parts(settings: Settings) -> Iterator[Measurement]:
    """Yields the share of each part of a step."""
    env = evening()
    spent: dict[str, list[float]] = {name: [] for name in PARTS}
    with ExitStack() as timers:
        for name, path in PARTS.items():
            owner, _, method = path.rpartition(".")
            part_of = attrgetter(owner)(env) if owner else env
            timers.enter_context(_timed(part_of, method, spent[name]))
        step = PatientStepping(env)
        rounds = [
            _shares(step, settings.steps, spent) for _ in range(settings.repetitions)
        ]
    for name in rounds[0]:
        yield Measurement(
            part="where a step goes",
            name=name,
            unit="%",
            values=tuple(100.0 * shares[name] for shares in rounds),
        )


def _shares(
    step: Stepping, steps: int, spent: dict[str, list[float]]
) -> dict[str, float]:
    """Makes some steps and returns which share of them each part took."""
    for each in spent.values():
        each.clear()
    begin = time.perf_counter()
    for _ in range(steps):
        step()
    whole = time.perf_counter() - begin
    shares = {name: sum(each) / whole for name, each in spent.items()}
    return shares | {"all else": 1.0 - sum(shares.values())}


@contextmanager
def _timed(owner: object, method: str, spent: list[float]) -> Iterator[None]:
    """Notes how long each call of a method takes, in wall time: the cheapest clock."""
    call: Callable[..., object] = getattr(owner, method)

    def timed(*args: object, **named: object) -> object:
        begin = time.perf_counter()
        answer = call(*args, **named)
        spent.append(time.perf_counter() - begin)
        return answer

    setattr(owner, method, timed)
    try:
        yield
    finally:
        delattr(owner, method)
