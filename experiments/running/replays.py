"""Replay files of trials."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from experiments.running.study import Trial
from experiments.running.trial import play
from policies.recording import RecordingObserver


def record(trial: Trial, path: Path) -> None:
    """Runs a trial once more and writes it as a replay.

    Args:
        trial: The trial; the same seed gives the same episode.
        path: The file to write; there only once it is whole.
    """
    # The file's name is also what the viewer calls it, hence a folder of its own.
    with TemporaryDirectory(dir=path.parent, prefix=".", suffix=".tmp") as folder:
        temporary = Path(folder) / path.name
        play(trial, [RecordingObserver(temporary)])
        temporary.replace(path)
