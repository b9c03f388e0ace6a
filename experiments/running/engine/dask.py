"""Trials on a Dask cluster; imported only when asked for."""

from __future__ import annotations

import atexit
import logging

from distributed import Client, LocalCluster, Security
from distributed.cfexecutor import ClientExecutor


def connect(address: str, workers: int) -> tuple[Client, int]:
    """Returns a client and the number of trials the cluster can run at once.

    Args:
        address: Address of a scheduler; empty: a cluster of its own on this machine,
            which nobody can reach from elsewhere, nor anybody else here: its keys are
            made for it alone and never written down. For an address that begins with
            `tls://` the keys are those of Dask's configuration.
        workers: Processes of that cluster of its own.
    """
    if address:
        client = Client(address)
    else:
        keys = Security.temporary()
        cluster = LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            dashboard_address=None,
            host="tls://127.0.0.1",
            protocol="tls",
            security=keys,
            silence_logs=logging.ERROR,
        )
        client = Client(cluster, security=keys)
        atexit.register(cluster.close)
    atexit.register(client.close)
    return client, sum(client.nthreads().values()) or workers


class DaskExecutor(ClientExecutor):
    """Dask's own executor; Dask runs again by itself what a dead worker held."""

    def __init__(self, client: Client) -> None:
        # Not pure: otherwise two equal calls share one result.
        super().__init__(client, pure=False)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Waits for what still runs, or drops it."""
        super().shutdown(wait=wait and not cancel_futures)
