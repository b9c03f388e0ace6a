"""A study that is run by one call, in the program's own process."""

import os

import polars as pl
import pytest

from experiments import Condition, Study, run_study
from experiments.errors import ExperimentError

ran = []


def note(trial):
    """A trial that tells where and when it ran."""
    ran.append(trial.seed)
    return pl.DataFrame({"process": [os.getpid()], "reward": [float(trial.seed)]})


def fail(trial):
    raise ZeroDivisionError(trial.seed)


def study_of(run):
    condition = Condition(name="one", scenario="experiment_1", learner="random")
    return Study(name="noted", conditions=(condition,), seeds=(0, 1, 2), run=run)


def test_what_is_stored_is_not_run_again(tmp_path):
    ran.clear()
    table = run_study(study_of(note), tmp_path)
    assert ran == [0, 1, 2]
    assert table["process"].unique().to_list() == [os.getpid()]
    assert table.select("condition", "seed", "reward").rows() == [
        ("one", 0, 0.0),
        ("one", 1, 1.0),
        ("one", 2, 2.0),
    ]
    assert run_study(study_of(note), tmp_path).equals(table)
    assert ran == [0, 1, 2]


def test_a_trial_that_fails_is_told(tmp_path):
    with pytest.raises(ExperimentError, match="3 of 3 trials failed"):
        run_study(study_of(fail), tmp_path)


def test_here_has_no_address(tmp_path):
    with pytest.raises(ExperimentError, match="takes no address"):
        run_study(study_of(note), tmp_path, engine="here:there")
