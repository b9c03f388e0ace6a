"""A line between two processes, over which each tells the other that it may go on.

What they tell each other about stands in memory that they share, and so does the last
word of each: to read it there takes a tenth of a microsecond, while to be woken by a
socket takes tens of them, as long as the step of a home. Who has waited for a while
goes to sleep at a socket, and is woken there. When one process ends, however it ends,
the other reads the end of the stream.
"""

import os
import platform
import select
import socket
import time
from collections.abc import Iterable
from itertools import chain

from household.compiled.arrays import Integers

PARENT, WORKER = 0, 1
"""The sides of a line."""

LAST_WORD, ASLEEP = 0, 1
"""What each side has in the shared memory; columns of `Line`'s ``memory``."""

ORDERED = platform.machine() in ("x86_64", "AMD64")
"""Whether other processes see what one has written in the order in which it wrote.
Elsewhere both sides use the socket for each word, as the system's calls keep order."""

SPIN = 0.0005
"""How long a process looks again and again before it sleeps [s]."""

LOOKS = 50
"""How often it looks at once: for a few microseconds."""

NAP = 50
"""How long it sleeps at most before it looks again [ms]: whoever goes to sleep at the
moment when it is told something may not be woken."""

WAKE, GONE = b"\0", b""


class Line:
    """One end of a line.

    Args:
        end: A connected socket.
        memory: Shared with the other side, and zero at first, shape (2, 2): for each
            side its last word and whether it sleeps.
        side: Which one this is.
    """

    def __init__(self, end: socket.socket, memory: Integers, side: int) -> None:
        end.setblocking(False)
        self._end = end
        self._poll = select.poll()
        self._poll.register(end, select.POLLIN)
        # Python's own numbers: NumPy takes three times as long to read one.
        self._mine, self._theirs = memory[side].data, memory[1 - side].data
        self._told = self._heard = 0
        self._parent = os.getppid() if side == WORKER else None

    def tell(self, word: bytes) -> None:
        """Says one byte.

        Raises:
            OSError: If nobody is at the other end; but often that is only heard.
        """
        self._told += 1
        self._mine[LAST_WORD] = self._told << 8 | word[0]
        if self._theirs[ASLEEP] or not ORDERED:
            self._end.send(WAKE)

    def hear(self, meanwhile: Iterable[None] = ()) -> bytes:
        """Waits for a byte and returns it; nothing if nobody is at the other end.

        Args:
            meanwhile: Small pieces of work to do while nothing is heard.
        """
        # One look at once, and one after each piece of work.
        for _ in chain((None,), meanwhile):
            if ORDERED and self._theirs[LAST_WORD] != self._heard:
                return self._word()
        return self._word() if self._spin() else self._sleep()

    def _spin(self) -> bool:
        """Looks again and again for a while; returns whether anything was said."""
        theirs, heard = self._theirs, self._heard
        until = time.perf_counter() + SPIN
        while ORDERED and time.perf_counter() < until:
            for _ in range(LOOKS):
                if theirs[LAST_WORD] != heard:
                    return True
            os.sched_yield()
        return False

    def _sleep(self) -> bytes:
        """Sleeps until something is said, and returns it, or that nobody is there."""
        while (word := self._woken()) == WAKE:
            if self._theirs[LAST_WORD] != self._heard:
                return self._word()
        return word

    def _word(self) -> bytes:
        self._heard = self._theirs[LAST_WORD]
        return bytes([self._heard & 0xFF])

    def _woken(self) -> bytes:
        """Sleeps for a nap at most; returns what is heard over the socket, if anything.

        Nothing else is said there than that this side is to wake, and texts.
        """
        self._mine[ASLEEP] = True
        if not ORDERED or self._theirs[LAST_WORD] == self._heard:
            self._poll.poll(NAP)
        self._mine[ASLEEP] = False
        if self._parent not in (None, os.getppid()):
            return GONE  # Somebody else may hold the other end open.
        try:
            return self._end.recv(1)
        except BlockingIOError:
            return WAKE
        except ConnectionError:
            return GONE

    def rest(self) -> bytes:
        """Everything until the end of the stream."""
        self._end.setblocking(True)
        with self._end.makefile("rb") as stream:
            return stream.read()

    def close(self) -> None:
        """Hangs up."""
        self._end.close()
