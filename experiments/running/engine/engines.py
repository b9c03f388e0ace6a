"""Where trials run: a named engine opens `concurrent.futures` executors."""

from __future__ import annotations

import os
import secrets
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass

from experiments.errors import ExperimentError, unknown
from experiments.running.engine.local import Here, local_executor


@dataclass(frozen=True, kw_only=True)
class Engine:
    """How to open an executor, and how much to hand it at a time."""

    open: Callable[[], Executor]
    """Returns a fresh executor; called again when the one before broke."""

    window: int
    """How many trials may be in flight. Bounded, so that little is lost in a crash."""


def open_engine(spec: str = "local", workers: int | None = None) -> Engine:
    """Returns the engine that a text names.

    Args:
        spec: `local`, `dask`, `dask:ADDRESS`, `ray` or `ray:ADDRESS`. With an
            address trials run on that cluster; without one, on this machine. `here`:
            in this process, one after the other.
        workers: Processes on this machine; None: one for each core.

    Raises:
        ExperimentError: If the engine is unknown or not installed, or `workers` < 1.
    """
    kind, _, address = spec.partition(":")
    if kind not in _ENGINES:
        raise unknown("engine", kind, _ENGINES)
    if workers is not None and workers < 1:
        raise ExperimentError(f"--workers must be at least 1, got {workers}.")
    return _ENGINES[kind](address, workers or os.cpu_count() or 1)


def _local(address: str, workers: int) -> Engine:
    if address:
        raise ExperimentError(f"engine 'local' takes no address, got {address!r}.")
    return Engine(open=lambda: local_executor(workers), window=workers)


def _here(address: str, workers: int) -> Engine:
    if address:
        raise ExperimentError(f"engine 'here' takes no address, got {address!r}.")
    return Engine(open=Here, window=1)


def _dask(address: str, workers: int) -> Engine:
    try:
        from experiments.running.engine.dask import DaskExecutor, connect
    except ImportError as error:
        raise _missing("dask", error) from error
    client, slots = connect(address, workers)
    return Engine(open=lambda: DaskExecutor(client), window=2 * slots)


def _ray(address: str, workers: int) -> Engine:
    if not address:
        # Before the import, which reads them: for a cluster of our own a token, and the
        # loopback interface alone, as Ray by itself has it on Windows and macOS only.
        os.environ.setdefault("RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER", "0")
        os.environ.setdefault("RAY_AUTH_MODE", "token")
        os.environ.setdefault("RAY_AUTH_TOKEN", secrets.token_hex(32))
    try:
        from experiments.running.engine.ray import RayExecutor, connect
    except ImportError as error:
        raise _missing("ray", error) from error
    slots = connect(address, workers)
    return Engine(open=RayExecutor, window=2 * slots)


def _missing(extra: str, error: ImportError) -> ExperimentError:
    return ExperimentError(
        f"engine {extra!r} is not installed ({error}): "
        f"pip install 'polite-household[{extra}]'."
    )


_ENGINES: dict[str, Callable[[str, int], Engine]] = {
    "local": _local,
    "here": _here,
    "dask": _dask,
    "ray": _ray,
}
