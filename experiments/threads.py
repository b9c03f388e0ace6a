"""One thread for each process, where there is a process on each core."""

from __future__ import annotations

import os

_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "POLARS_MAX_THREADS")


def one_thread() -> None:
    """Keeps libraries that are imported from now on from starting more threads.

    They would take cores from other processes, and for tables of a trial, which are
    small, they would wait for each other longer than they work.
    """
    for variable in _VARIABLES:
        os.environ.setdefault(variable, "1")
