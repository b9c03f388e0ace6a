"""The commands of `household`: what each takes and what it does.

A command is a record of what was asked, with a method `run`. It imports what it needs
when it runs, so that `--help` is quick.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from experiments.commands.benchmarking import Bench
from experiments.commands.evaluating import Evaluate
from experiments.commands.mapping import Maps
from experiments.commands.recording import Record
from experiments.commands.replaying import Replay
from experiments.commands.reproducing import Report, Reproduce
from experiments.commands.scenarios import Check, Scenarios
from experiments.commands.studying import StudyCommand
from experiments.commands.training import Train
from experiments.commands.validating import Validate
from experiments.commands.warming import WarmUp


class Command(Protocol):
    """Something that can be run once its words are read."""

    def run(self) -> None:
        """Does it."""


COMMANDS: Mapping[str, Callable[..., Command]] = {
    "reproduce": Reproduce,
    "report": Report,
    "train": Train,
    "evaluate": Evaluate,
    "maps": Maps,
    "study": StudyCommand,
    "validate": Validate,
    "replay": Replay,
    "record": Record,
    "scenarios": Scenarios,
    "check": Check,
    "bench": Bench,
    "warm-up": WarmUp,
}
"""Every command that there is, in the order of `--help`."""
