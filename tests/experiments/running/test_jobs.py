import os
import signal
import time

import polars as pl
import pytest

from experiments.errors import ExperimentError
from experiments.running import jobs as reproduce
from experiments.running.store import Results
from experiments.running.study import Condition, Study


def fine(trial):
    return pl.DataFrame({"x": [trial.seed]})


def picky(trial):
    if trial.seed == 1:
        raise ValueError("one is\nnot enough")
    return fine(trial)


def study(run=fine, seeds=(0, 1, 2), scenario="experiment_1"):
    condition = Condition(name="a", scenario=scenario, learner="q_social")
    return Study(name="toy", conditions=(condition,), seeds=seeds, run=run)


@pytest.fixture
def in_threads(monkeypatch):
    """Runs jobs in this process, so that trial functions need not be importable."""
    from concurrent.futures import ThreadPoolExecutor

    from experiments.running.engine import Engine

    return Engine(open=lambda: ThreadPoolExecutor(1), window=1)


def test_what_is_stored_is_not_run_again(tmp_path, in_threads):
    counted = []
    jobs = reproduce.prepare([study(seeds=(0, 1))], tmp_path)
    reproduce.run(jobs, in_threads, lambda: counted.append(1))
    jobs = reproduce.prepare([study(seeds=(0, 1, 2, 3))], tmp_path)
    assert [job.trial.seed for job in jobs] == [2, 3]
    reproduce.run(jobs, in_threads, lambda: counted.append(1))
    assert len(counted) == 4
    frame = Results(tmp_path / "toy").read(study(seeds=(0, 1, 2, 3)))
    assert frame["x"].to_list() == [0, 1, 2, 3]


def test_a_trial_that_fails_is_named_and_the_others_are_stored(tmp_path, in_threads):
    wanted = study(picky)
    jobs = reproduce.prepare([wanted], tmp_path)
    with pytest.raises(ExperimentError) as caught:
        reproduce.run(jobs, in_threads, lambda: None)
    said = str(caught.value)
    assert "1 of 3 trials failed" in said
    assert "a, seed 1: ValueError: one is" in said
    assert "\n" not in said
    missing = Results(tmp_path / "toy").missing(wanted.trials())
    assert [trial.seed for trial in missing] == [1]
    errors = list(tmp_path.rglob("*.error.txt"))
    assert "not enough" in errors[0].read_text()


def test_another_configuration_is_refused_before_any_study_is_touched(tmp_path):
    reproduce.prepare([study()], tmp_path)
    other = study(scenario="experiment_2")
    fresh = Study(name="new", conditions=other.conditions, seeds=(0,), run=fine)
    with pytest.raises(ExperimentError, match="another configuration"):
        reproduce.prepare([fresh, other], tmp_path)
    assert not (tmp_path / "new").exists()


def test_an_unknown_scenario_is_refused_before_anything_is_made(tmp_path):
    with pytest.raises(ValueError, match="unknown scenario 'experiment_l'"):
        reproduce.prepare([study(scenario="experiment_l")], tmp_path / "out")
    assert not (tmp_path / "out").exists()


COMMAND = """
    import os, sys, time
    import polars as pl
    from experiments import paper
    from experiments.paper import experiment
    from experiments.running.study import Study

    def slow(trial):
        if trial.seed >= 2:
            time.sleep(600)
        return pl.DataFrame({"x": [trial.seed]})

    def study(self, seeds):
        return Study(name=self.name, conditions=self.conditions, seeds=seeds, run=slow)

    if __name__ == "__main__":
        experiment.Experiment.study = study
        from experiments.cli import main
        sys.exit(main(["reproduce", "1", "--seeds", "4", "--workers", "2",
                       "--out", sys.argv[1]]))
"""


def stored(out):
    return sorted(path.name for path in out.rglob("*.parquet"))


def started(program, out):
    """Starts the command and waits until four trials are stored."""
    process = program(COMMAND, out)
    deadline = time.monotonic() + 60
    while len(stored(out)) < 4:
        assert process.poll() is None, process.stderr.read()
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return process


def check_stored(out):
    """Of each condition both trials that can end are there, whole."""
    assert stored(out) == ["seed_0000.parquet"] * 2 + ["seed_0001.parquet"] * 2
    for path in out.rglob("*.parquet"):
        assert len(pl.read_parquet(path)) == 1


def test_a_stopped_command_keeps_what_is_done_and_leaves_no_process(
    program, group_is_empty, tmp_path
):
    process = started(program, tmp_path / "out")
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    _, said = process.communicate(timeout=30)
    assert group_is_empty(process.pid)
    check_stored(tmp_path / "out")
    assert process.returncode == 130
    assert said.startswith("Stopped. 4 of 8 trials are stored")
    assert "Traceback" not in said


def test_a_killed_one_does_too_and_the_same_command_goes_on_with_what_is_missing(
    program, group_is_empty, tmp_path
):
    out = tmp_path / "out"
    process = started(program, out)
    os.kill(process.pid, signal.SIGKILL)
    process.communicate(timeout=30)
    assert group_is_empty(process.pid)
    check_stored(out)
    before = {path: path.stat().st_mtime_ns for path in out.rglob("*.parquet")}
    again = program(COMMAND, out)
    said = ""
    while said == "" or said.startswith("Preparing"):
        said = again.stdout.readline()
        assert said
    os.killpg(again.pid, signal.SIGINT)
    again.wait(timeout=30)
    assert said == "8 trials. 4 of 8 trials are stored already.\n"
    assert {path: path.stat().st_mtime_ns for path in before} == before


def doubled(trial, before=None):
    """Twice its seed, from what is stored or from the beginning."""
    doubled.given.append(before is not None)
    start = fine(trial) if before is None else before
    return pl.DataFrame({"x": [2 * start["x"][0]]})


def test_a_trial_is_given_the_stored_one_that_it_starts_from(tmp_path, in_threads):
    doubled.given = []
    first = study()
    second = Study(
        name="second",
        conditions=first.conditions,
        seeds=first.seeds,
        run=doubled,
        start=lambda trial: ("toy", trial) if trial.seed else None,
    )
    reproduce.run(reproduce.prepare([first], tmp_path), in_threads, lambda: None)
    reproduce.run(reproduce.prepare([second], tmp_path), in_threads, lambda: None)
    assert sorted(doubled.given) == [False, True, True]
    assert Results(tmp_path / "second").read(second)["x"].to_list() == [0, 2, 4]


def test_a_trial_whose_start_is_missing_says_which(tmp_path, in_threads):
    second = Study(
        name="second",
        conditions=study().conditions,
        seeds=(1,),
        run=doubled,
        start=lambda trial: ("toy", trial),
    )
    jobs = reproduce.prepare([second], tmp_path)
    with pytest.raises(ExperimentError, match="toy"):
        reproduce.run(jobs, in_threads, lambda: None)
