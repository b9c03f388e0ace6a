"""Workers as their parent sees them: started, set to work, and never left behind."""

import contextlib
import json
import os
import socket
import subprocess
import sys
import tempfile
import weakref
from collections.abc import Iterable, Sequence
from typing import Any

import cloudpickle
from numpy.typing import NDArray

from household.compiled.arrays import Integers
from household.vector.buffers import Size, record_type
from household.vector.homes import Plan
from household.vector.line import PARENT, Line
from household.vector.worker import DONE, FAILED, Job, mapped

START = """
import json, sys
sys.path[:] = json.loads(sys.argv.pop())
from household.vector.worker import main
main()
"""
"""What a worker's interpreter runs. The user's own script is not run again in it."""

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""Each worker is one process on one core: its libraries must not start more threads."""

PATIENCE = 2.0
"""How long a worker may take to end by itself [s]."""


class WorkerError(RuntimeError):
    """A worker failed; the text tells how."""


class Workers:
    """Processes that step their shares of the homes.

    Args:
        size: Of the buffers; for as many processes as it has lines. They get ready
            while this one does something else.

    Attributes:
        record: The record of all buffers, in memory shared with the workers.
    """

    def __init__(self, size: Size) -> None:
        self._size = size
        self._lines: list[Line] = []
        self._processes: list[subprocess.Popen[bytes]] = []
        # However this ends: closed, forgotten, or with the interpreter.
        self.end = weakref.finalize(
            self, _end, self._lines, self._processes, os.getpid()
        )
        try:
            with tempfile.TemporaryFile() as file:  # It has no name to be left behind.
                file.truncate(record_type(size).itemsize)
                self.record: NDArray[Any] = mapped(file.fileno(), size)
                for memory in self.record["lines"]:
                    self._start(file.fileno(), memory)
        except BaseException:
            self.end()
            raise

    def _start(self, file: int, memory: Integers) -> None:
        here, there = socket.socketpair()
        line = there.fileno()
        command = (sys.executable, "-c", START, str(line), str(file))
        try:
            process = subprocess.Popen(
                (*command, json.dumps(sys.path)),
                stdin=subprocess.PIPE,
                pass_fds=(line, file),
                process_group=0,  # Ctrl-C does not reach it, from the first moment on.
                env=dict.fromkeys(ONE_THREAD, "1") | os.environ,
            )
        finally:
            there.close()
        self._lines.append(Line(here, memory, PARENT))
        self._processes.append(process)

    def hand_out(self, plan: Plan, shares: Sequence[Sequence[int]]) -> None:
        """Hands all workers their homes, and waits until they have built them.

        Args:
            plan: What there is.
            shares: The homes of each worker.

        Raises:
            WorkerError: If one failed.
        """
        for number, which in enumerate(shares):
            job = Job(plan, tuple(which), self._size, number)
            _hand(self._processes[number], job)
        self.wait()

    def set_to(self, word: bytes) -> None:
        """Sets all workers to work."""
        for number, line in enumerate(self._lines):
            try:
                line.tell(word)
            except OSError:
                raise self._failure(number) from None

    def wait(self, meanwhile: Iterable[None] = ()) -> None:
        """Waits until all workers are done.

        Args:
            meanwhile: Small pieces of work to do until then.

        Raises:
            WorkerError: If one failed.
        """
        for number, line in enumerate(self._lines):
            word = line.hear(meanwhile)
            if word == FAILED:
                text = line.rest().decode(errors="replace").rstrip()
                raise WorkerError(f"worker {number} failed:\n{text}")
            if word != DONE:
                raise self._failure(number)

    def _failure(self, number: int) -> WorkerError:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._processes[number].wait(PATIENCE)
        status = self._processes[number].returncode
        return WorkerError(f"worker {number} has ended, with status {status}")


def _hand(process: subprocess.Popen[bytes], job: Job) -> None:
    """Hands a worker its job; minds may come from the user's own script."""
    if process.stdin is None:  # It was started with one.
        raise WorkerError("a worker without a standard input")
    with contextlib.suppress(BrokenPipeError), process.stdin as stream:
        stream.write(cloudpickle.dumps(job))


def _end(
    lines: list[Line], processes: list[subprocess.Popen[bytes]], owner: int
) -> None:
    """Ends all workers: they end when their lines do, or else they are killed."""
    if os.getpid() != owner:  # A fork of the parent: they are not its own.
        return
    for line in lines:
        line.close()
    for process in processes:
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if process.stdin is not None:
            with contextlib.suppress(OSError):
                process.stdin.close()
