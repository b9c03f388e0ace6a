"""Many homes at once: our vector environment beside a plain loop and other libraries'.

All of them step the same homes with the same random actions, a new one for every robot
in every step. By the clock, as several processes take part; and each is opened for its
turn alone, as the workers of some never sleep.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from experiments.bench.homes import FOREVER
from experiments.bench.measurement import Measurement, Settings, ratios

if TYPE_CHECKING:
    from household.environment import Household

PART = "many homes, agent-decisions"
SCENARIO, ROBOTS = "evening", 2
DRAWN = 256
"""Steps for which actions are drawn; afterwards the same actions come again."""

Step = Callable[[Any], object]
Method = Callable[[int], AbstractContextManager[Step]]
"""Opens so many homes; what it gives takes the actions of all robots."""

LOOP, ALONE, WORKER = "plain loop", "household.vector", "household.vector, 1 worker"


def many_homes(settings: Settings) -> Iterator[Measurement]:
    """Yields agent-decisions per second for growing numbers of homes."""
    others, missing = _others()
    for n in settings.homes:
        methods = {LOOP: _loop, ALONE: _ours(0)}
        methods |= {WORKER: _ours(1)} if n > 1 else {}
        methods |= {k: other for k, other in others.items() if n > 1 or ", 2" not in k}
        rates: dict[str, list[float]] = {name: [] for name in methods}
        for _ in range(settings.repetitions):
            for name, method in methods.items():
                with method(n) as step:
                    rates[name].append(_rate(step, n, settings.steps))
        for name, found in rates.items():
            yield _measured(n, name, "1/s", tuple(found))
        yield from _compared(n, rates, others)
    for name, hint in missing.items():
        yield Measurement(part=PART, name=name, unit="1/s", values=(), hint=hint)


def _rate(step: Step, homes: int, steps: int) -> float:
    """Agent-decisions per second; four times as many steps of a home as asked for.

    Half as many come before, to warm up. All together take some tenths of a second, so
    that it hardly matters on which core a process happens to begin.
    """
    rng = np.random.default_rng(0)
    n_actions = len(_home().behaviors)
    actions = rng.integers(n_actions, size=(DRAWN, homes * ROBOTS))
    calls = max(4, 4 * steps // homes)
    for call in range(calls // 2):
        step(actions[call % DRAWN])
    begin = time.perf_counter()
    for call in range(calls):
        step(actions[call % DRAWN])
    return calls * homes * ROBOTS / (time.perf_counter() - begin)


def _compared(
    n: int, rates: Mapping[str, list[float]], others: Mapping[str, Method]
) -> Iterator[Measurement]:
    alone = ratios(rates[ALONE], rates[LOOP])
    yield _measured(n, "one process / plain loop", "x", alone, at_least=1.0)
    if WORKER not in rates:
        return
    for name, other in (("plain loop", LOOP), ("without", ALONE)):
        more = ratios(rates[WORKER], rates[other])
        yield _measured(n, f"with a worker / {name}", "x", more, at_least=1.8)
    if others:
        best = [max(each) for each in zip(*(rates[k] for k in others), strict=True)]
        ahead = ratios(rates[WORKER], best)
        name = "with a worker / best of the others"
        yield _measured(n, name, "x", ahead, at_least=2.5)


def _measured(
    n: int,
    name: str,
    unit: str,
    values: tuple[float, ...],
    at_least: float | None = None,
) -> Measurement:
    name = f"{n}: {name}"
    return Measurement(
        part=PART, name=name, unit=unit, values=values, at_least=at_least
    )


def _home() -> Household:
    from household import household_v0

    return household_v0.parallel_env(SCENARIO, max_cycles=FOREVER)


@contextmanager
def _loop(n: int) -> Iterator[Step]:
    """One environment after the other, as PettingZoo has it."""
    homes = [_home() for _ in range(n)]
    for seed, home in enumerate(homes):
        home.reset(seed=seed)
    agents = homes[0].possible_agents

    def step(actions: Any) -> None:  # noqa: ANN401 - as for all methods
        rows = actions.reshape(n, ROBOTS).tolist()
        for home, row in zip(homes, rows, strict=True):
            home.step(dict(zip(agents, row, strict=True)))

    yield step


def _ours(workers: int) -> Method:
    @contextmanager
    def opened(n: int) -> Iterator[Step]:
        from household import vector

        envs = vector.make(
            SCENARIO, homes=n, workers=workers, seed=1, max_cycles=FOREVER
        )
        envs.reset()
        yield envs.step
        envs.close()

    return opened


def _others() -> tuple[dict[str, Method], dict[str, str]]:
    """What other libraries offer, if they are installed, and else how to get them."""
    found: dict[str, Method] = {}
    missing: dict[str, str] = {}
    try:
        import supersuit  # noqa: F401

        found |= {"SuperSuit": _supersuit(0), "SuperSuit, 2 workers": _supersuit(2)}
    except ImportError:
        missing["SuperSuit"] = "pip install supersuit"
    try:
        import pufferlib.vector  # noqa: F401

        found |= {"PufferLib": _pufferlib(1), "PufferLib, 2 workers": _pufferlib(2)}
    except ImportError:
        missing["PufferLib"] = "pip install pufferlib-core"
    return found, missing


def _supersuit(workers: int) -> Method:
    @contextmanager
    def opened(n: int) -> Iterator[Step]:
        import supersuit

        one = supersuit.pettingzoo_env_to_vec_env_v1(_home())
        envs = supersuit.concat_vec_envs_v1(
            one, n, num_cpus=workers, base_class="gymnasium"
        )
        envs.reset(seed=1)
        yield envs.step
        envs.close()

    return opened


def _puffer_home(buf: Any = None, seed: int = 0) -> Any:  # noqa: ANN401 - PufferLib's
    """A home as PufferLib wants it."""
    from pufferlib.emulation import PettingZooPufferEnv

    return PettingZooPufferEnv(env=_home(), buf=buf, seed=seed)


def _pufferlib(workers: int) -> Method:
    @contextmanager
    def opened(n: int) -> Iterator[Step]:
        from pufferlib import vector

        alone = workers == 1
        backend = vector.Serial if alone else vector.Multiprocessing
        options = {} if alone else {"num_workers": workers}
        envs = vector.make(_puffer_home, num_envs=n, backend=backend, **options)
        envs.reset(seed=1)

        def step(actions: Any) -> None:  # noqa: ANN401 - as for all methods
            envs.send(actions)
            envs.recv()

        yield step
        envs.close()

    return opened
