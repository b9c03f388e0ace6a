"""What was learned is stored before its replay is finished, and goes before it."""

import numpy as np
import polars as pl
import pytest

from experiments.errors import ExperimentError
from experiments.running import keeping
from experiments.running.keeping import Keeper
from experiments.running.trial_table import TrialTable
from learners.catalog import make_learner
from learners.saving import load
from policies.learning import LearningRobot, Observer, run_episode


@pytest.fixture
def episode(play_home, tmp_path):
    """Runs an episode whose replay is broken off at its end."""
    table, replay = TrialTable(), tmp_path / "replay.rrd"
    keeper = Keeper(table, tmp_path, replay)

    class Breaks(Observer):
        def reset(self, env, robots):
            replay.write_bytes(b"x" * 1000)

        def finished(self, env, robots):
            raise OSError("the replay cannot be finished")

    def run():
        learner = make_learner("q_social", 2, np.random.default_rng(0))
        robots = {"robot_0": LearningRobot(learner)}
        with pytest.raises((OSError, ExperimentError)):
            run_episode(
                play_home(60), robots, seed=1, observers=[table, keeper, Breaks()]
            )
        return keeper

    return run


def test_results_are_there_although_the_replay_could_not_be_finished(episode, tmp_path):
    assert episode().done
    assert len(pl.read_parquet(tmp_path / "trial.parquet")) > 5
    assert load(tmp_path / "robot_0.json").n_behaviors == 2
    assert (tmp_path / "replay.rrd").exists()


def test_the_replay_makes_room_for_results(episode, tmp_path, monkeypatch):
    """A disk that has room for one of the two."""
    write = keeping.write_whole

    def full(path, content):
        if (tmp_path / "replay.rrd").exists():
            raise ExperimentError(f"{path}: the disk is full")
        write(path, content)

    monkeypatch.setattr(keeping, "write_whole", full)
    assert episode().done
    assert (tmp_path / "trial.parquet").exists()
    assert not (tmp_path / "replay.rrd").exists()


def test_a_disk_that_is_full_without_the_replay_is_not_hidden(episode, monkeypatch):
    def full(path, content):
        raise ExperimentError(f"{path}: the disk is full")

    monkeypatch.setattr(keeping, "write_whole", full)
    assert not episode().done
