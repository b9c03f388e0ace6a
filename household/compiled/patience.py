"""Patience: who waits for the compiler at first use is told why, once, in one line."""

import sys

ENOUGH = 1.0
"""Time in the compiler after which it is told that there is more to come [s]."""

NOTICE = (
    "household: compiling for this machine; takes about half a minute, once "
    "(`household warm-up` does it beforehand)"
)


class Patience:
    """Adds up the time that was waited for the compiler, and tells when it is long.

    Attributes:
        waited: For what was really compiled in this process [s].
    """

    def __init__(self) -> None:
        self.waited = 0.0
        self._told = False

    def add(self, took: float) -> None:
        """Adds what the compiler took for one function [s]."""
        self.waited += took
        if self.waited > ENOUGH and not self._told:
            self._told = True
            print(NOTICE, file=sys.stderr, flush=True)


PATIENCE = Patience()
"""That of this process."""
