"""A line between two processes, over which each tells the other that it may go on.

What they tell each other about stands in memory that they share. A line is a pair of
sockets: when one process ends, however it ends, the other reads the end of the stream.
"""

import os
import select
import socket
import time

SPIN = 0.0005
"""How long a process asks again and again before it sleeps [s]: to be woken takes tens
of microseconds, as long as the step of a home."""

GLANCE = 1.0
"""How long it sleeps at most before it looks after the other process [s]."""


class Line:
    """One end of a line.

    Args:
        end: A connected socket.
    """

    def __init__(self, end: socket.socket) -> None:
        end.setblocking(False)
        self._end = end
        self._poll = select.poll()
        self._poll.register(end, select.POLLIN)

    def tell(self, word: bytes) -> None:
        """Sends one byte.

        Raises:
            OSError: If nobody is at the other end.
        """
        self._end.send(word)

    def hear(self) -> bytes:
        """Waits for a byte and returns it; nothing if nobody is at the other end."""
        asleep_from = time.perf_counter() + SPIN
        parent = os.getppid()
        while True:
            try:
                return self._end.recv(1)
            except BlockingIOError:
                if time.perf_counter() < asleep_from:
                    os.sched_yield()
                    continue
            except ConnectionError:
                return b""
            self._poll.poll(1000 * GLANCE)
            if os.getppid() != parent:  # Somebody else may hold the other end open.
                return b""

    def rest(self) -> bytes:
        """Everything until the end of the stream."""
        self._end.setblocking(True)
        with self._end.makefile("rb") as stream:
            return stream.read()

    def say(self, text: bytes) -> None:
        """Sends a text, however long."""
        self._end.setblocking(True)
        self._end.sendall(text)

    def close(self) -> None:
        """Hangs up."""
        self._end.close()
