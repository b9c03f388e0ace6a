import time

import polars as pl
import pytest

from experiments.running import planning
from experiments.running.jobs import missing, prepare, run
from experiments.running.study import Condition, Study


def busy(trial):
    """Keeps the processor busy for a hundredth of a second."""
    begun = time.process_time()
    while time.process_time() - begun < 0.01:
        pass
    return pl.DataFrame({"x": [trial.seed]})


def study(n, names="a", run=busy):
    conditions = tuple(
        Condition(name=name, scenario="experiment_1", learner="q_social")
        for name in names
    )
    return Study(name="toy", conditions=conditions, seeds=tuple(range(n)), run=run)


@pytest.fixture
def in_threads():
    from concurrent.futures import ThreadPoolExecutor

    from experiments.running.engine import Engine

    return Engine(open=lambda: ThreadPoolExecutor(1), window=1)


def test_a_plan_counts_what_is_there_and_times_what_is_not(tmp_path, in_threads):
    run(prepare([study(2)], tmp_path), in_threads, lambda: None)
    wanted = study(8)
    planned = planning.plan(8, missing(wanted, tmp_path), sample=3)
    assert (planned.trials, planned.stored, planned.timed) == (8, 2, 3)
    assert planned.seconds >= 0.01
    assert planned.hours(1) == pytest.approx(6 * planned.seconds / 3600)
    assert planned.hours(3) == pytest.approx(planned.hours(1) / 3)


def test_a_plan_of_a_finished_study_takes_no_time(tmp_path, in_threads):
    run(prepare([study(1)], tmp_path), in_threads, lambda: None)
    planned = planning.plan(1, missing(study(1), tmp_path))
    assert (planned.stored, planned.timed, planned.hours(1)) == (1, 0, 0.0)


def test_a_plan_times_as_many_conditions_as_it_can(tmp_path):
    timed = []

    def noted(trial):
        timed.append(trial.condition.name)
        return busy(trial)

    planning.plan(64, missing(study(8, "abcdefgh", noted), tmp_path), sample=4)
    assert timed == ["a", "a", "c", "e", "g"]  # the first one twice


def test_a_plan_changes_nothing(tmp_path):
    planning.plan(2, missing(study(2), tmp_path / "new"))
    assert not (tmp_path / "new").exists()
