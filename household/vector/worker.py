"""A worker: a process that steps its share of the homes, and ends with its parent."""

import contextlib
import mmap
import os
import pickle
import signal
import socket
import sys
import traceback
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.vector.buffers import Size, buffers_in, record_type
from household.vector.homes import Plan, Share
from household.vector.line import WORKER, Line

BEGIN, STEP, DONE, FAILED = b"b", b"s", b".", b"!"
"""What is said over a line."""


class Job(NamedTuple):
    """What a worker does.

    Attributes:
        plan: What the vector environment consists of.
        which: The worker's homes.
        size: Of the buffers.
        number: The worker's own.
    """

    plan: Plan
    which: tuple[int, ...]
    size: Size
    number: int


def mapped(memory: int, size: Size) -> NDArray[Any]:
    """The record of all buffers in memory that several processes share.

    Args:
        memory: File descriptor.
        size: Of the buffers.
    """
    kind = record_type(size)
    return np.ndarray((), kind, mmap.mmap(memory, kind.itemsize))


def main() -> None:
    """Lives a worker's life; what its job is stands in the standard input."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's business.
    end, memory = socket.socket(fileno=int(sys.argv[1])), int(sys.argv[2])
    with contextlib.suppress(OSError):  # The parent has hung up.
        try:
            job: Job = pickle.load(sys.stdin.buffer)
            _work(job, end, memory)
        except EOFError:  # The parent has ended before it said what to do.
            return
        except Exception:
            end.setblocking(True)
            end.sendall(FAILED + traceback.format_exc().encode())


def _work(job: Job, end: socket.socket, memory: int) -> None:
    record = mapped(memory, job.size)
    os.close(memory)
    share = Share(job.plan, job.which, buffers_in(record))
    line = Line(end, record["lines"][job.number], WORKER)
    line.tell(DONE)
    while word := line.hear(share.chores()):
        (share.step if word == STEP else share.begin)()
        line.tell(DONE)
