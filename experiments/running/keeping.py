"""Results go before replays: what was learned is stored as soon as an episode ends."""

from __future__ import annotations

import io
import os
from collections.abc import Mapping
from pathlib import Path

from experiments.errors import ExperimentError
from experiments.running.files import write_whole
from experiments.running.trial_table import TrialTable
from policies.learning import Home, LearningRobot, Observer


class Keeper(Observer):
    """Stores the table and the learners of an episode; watches before its recorder.

    Args:
        table: Of the episode; it watches before this.
        out: Directory for `trial.parquet` and a file for each robot.
        replay: The replay that is being recorded. It makes room where the disk is full,
            since what was learned cannot be had from the same seed any sooner.
    """

    def __init__(self, table: TrialTable, out: Path, replay: Path) -> None:
        self._table, self._out, self._replay = table, out, replay
        self.done = False
        """Whether everything is stored."""

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Stores everything.

        Raises:
            ExperimentError: If the disk is full even without the replay.
            OSError: Likewise.
        """
        try:
            self._store(robots)
        except (ExperimentError, OSError):
            if not self._replay.exists():
                raise
            os.truncate(self._replay, 0)  # its writer may still hold it open
            self._replay.unlink()
            self._store(robots)
        self.done = True

    def _store(self, robots: Mapping[str, LearningRobot]) -> None:
        table = io.BytesIO()  # Polars would not say that the disk is full
        self._table.frame().write_parquet(table)
        write_whole(
            self._out / "trial.parquet",
            lambda temporary: temporary.write_bytes(table.getbuffer()),
        )
        for agent, robot in robots.items():
            robot.learner.save(self._out / f"{agent}.json")
