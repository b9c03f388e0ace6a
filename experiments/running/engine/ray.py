"""Trials on a Ray cluster; imported only when asked for."""

from __future__ import annotations

import atexit
from collections.abc import Callable
from concurrent.futures import Executor, Future, wait
from typing import Any, ParamSpec, TypeVar

import ray

P = ParamSpec("P")
T = TypeVar("T")


def connect(address: str, workers: int) -> int:
    """Connects this process and returns how many trials can run at once.

    Args:
        address: Address of a cluster; empty: a cluster of its own on this machine
            ("local", so that a cluster left over from elsewhere is not picked up),
            which nobody can reach from elsewhere, and only with its token from here.
        workers: Cores of that cluster of its own.
    """
    if not ray.is_initialized():
        own: dict[str, Any] = {}
        if not address:
            own = {"num_cpus": workers, "include_dashboard": False}
        ray.init(
            address=address or "local",
            log_to_driver=False,
            logging_level="ERROR",
            **own,
        )
        atexit.register(ray.shutdown)
    return int(ray.cluster_resources().get("CPU", workers))


def _call(
    function: Callable[..., T], args: tuple[object, ...], kwargs: dict[str, object]
) -> T:
    return function(*args, **kwargs)


class RayExecutor(Executor):
    """`concurrent.futures` over Ray tasks; Ray ships none.

    Ray runs again by itself what a dead worker held, twice at most.
    """

    def __init__(self) -> None:
        self._remote = ray.remote(num_cpus=1, max_retries=2)(_call)
        self._references: dict[Future[Any], Any] = {}

    def submit(
        self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs
    ) -> Future[T]:
        """Hands one call to the cluster."""
        reference = self._remote.remote(fn, args, kwargs)
        future: Future[T] = reference.future()
        self._references[future] = reference
        future.add_done_callback(lambda done: self._references.pop(done, None))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Waits for what still runs, or ends it."""
        if cancel_futures:
            for reference in list(self._references.values()):
                ray.cancel(reference, force=True)
        elif wait:
            _wait_for(list(self._references))


def _wait_for(futures: list[Future[Any]]) -> None:
    wait(futures)
