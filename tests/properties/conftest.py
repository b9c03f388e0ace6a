import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis.strategies import SearchStrategy

from experiments.commands.warming import WarmUp

from .living import no_hanging

AT_LENGTH = 100
"""Times as many inputs are tried where there is time."""

SLOWEST = 1.0
"""Of a step, where there is time to measure [s of the processor]."""

TRIED = "tried"


@dataclass
class Explorer:
    """Tries inputs of a kind, and counts what came of them.

    Attributes:
        at_length: Whether there is time for many.
        record: Told the counts in the end; its first argument is their name.
        counts: How many inputs were refused, lived in, ...
    """

    at_length: bool
    record: Callable[[str, object], None]
    counts: Counter[str] = field(default_factory=Counter)

    def __call__(
        self, inputs: SearchStrategy[Any], check: Callable[[Any], str], few: int
    ) -> None:
        """Tries so many inputs; the check says in a word what came of each."""

        def tried(data: Any) -> None:
            with no_hanging():
                self.counts[check(data)] += 1

        settings(
            max_examples=few * AT_LENGTH if self.at_length else few,
            derandomize=not self.at_length,
            database=None,
            deadline=None,
            suppress_health_check=list(HealthCheck),
        )(given(inputs)(tried))()
        self.record(TRIED, dict(self.counts))

    @property
    def slowest(self) -> float:
        """How long a step may take [s]; where time is short, nobody measures."""
        return SLOWEST if self.at_length else math.inf


@pytest.fixture(scope="session")
def all_compiled():
    """No step that is timed waits for the compiler."""
    WarmUp().run()


@pytest.fixture(
    params=[False, pytest.param(True, marks=pytest.mark.slow)],
    ids=["briefly", "at_length"],
)
def explore(request, record_property):
    """Tries inputs: a few, always the same; or many, others each time."""
    if request.param:
        request.getfixturevalue("all_compiled")
    return Explorer(request.param, record_property)


def pytest_terminal_summary(terminalreporter):
    """Tells how many inputs were accepted and refused, by entry point."""
    for report in terminalreporter.getreports("passed"):
        for name, counts in report.user_properties:
            if name == TRIED and report.when == "call":
                told = ", ".join(f"{n} {what}" for what, n in sorted(counts.items()))
                test = report.nodeid.rpartition("::")[2]
                terminalreporter.write_line(f"{test}: {told}")
