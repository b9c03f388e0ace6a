"""Trials on a Dask cluster; imported only when asked for."""

from __future__ import annotations

import atexit
from concurrent.futures import Executor

from distributed import Client


def connect(address: str, workers: int) -> tuple[Client, int]:
    """Returns a client and the number of trials the cluster can run at once.

    Args:
        address: Address of a scheduler; empty: a cluster of its own on this machine.
        workers: Processes of that cluster of its own.
    """
    if address:
        client = Client(address)
    else:
        client = Client(n_workers=workers, threads_per_worker=1, dashboard_address=None)
    atexit.register(client.close)
    return client, sum(client.nthreads().values()) or workers


def dask_executor(client: Client) -> Executor:
    """Returns an executor over the client.

    Dask runs again by itself what a dead worker held. `pure=False`: otherwise two
    equal calls share one result.
    """
    executor: Executor = client.get_executor(pure=False)
    return executor
