"""A long run is never silent for long."""

import io
import threading

import pytest
from rich.console import Console

from experiments.running import pulse as pulsing
from experiments.running.progress import progress
from experiments.running.pulse import pulse


class Log(io.StringIO):
    """Notes when something was said often enough."""

    def __init__(self, enough):
        super().__init__()
        self._left, self.over = enough, threading.Event()

    def write(self, text):
        self._left -= text.count("\n")
        if self._left <= 0:
            self.over.set()
        return super().write(text)


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    monkeypatch.setattr(pulsing, "SILENT", 0.01)


def test_what_goes_on_is_said_again_with_the_time_that_it_takes():
    log = Log(enough=3)
    with pulse(Console(file=log), "Reading"):
        assert log.over.wait(60)
    lines = log.getvalue().splitlines()
    assert lines[0] == "Reading"
    assert lines[1] == "Reading (0 s)"


def test_what_is_done_next_is_said_at_once():
    log = Log(enough=1)
    with pulse(Console(file=log), "Reading") as say:
        say("Drawing")
    assert "Drawing" in log.getvalue().splitlines()


def test_an_error_ends_it():
    before = threading.active_count()
    with (
        pytest.raises(ZeroDivisionError),
        pulse(Console(file=io.StringIO()), "Reading"),
    ):
        _ = 1 / 0
    assert threading.active_count() == before


def test_before_the_first_trial_a_log_says_that_compiling_takes_its_time():
    log = Log(enough=3)
    with progress(Console(file=log, width=200), "trials", 5) as advance:
        assert log.over.wait(60)
        advance()
    text = log.getvalue()
    assert "0 of 5 trials; the first run compiles, too" in text
    assert "1 of 5 trials" in text
