"""The same files, whoever runs the trials, how many at once and in which order."""

import pytest

REAL_TRIALS = """
    import sys
    from pathlib import Path
    from experiments.running.engine import open_engine
    from experiments.running.jobs import prepare, run
    from experiments.running.study import Condition, Study
    from experiments.running.trial import run_trial

    def study(seeds):
        conditions = tuple(
            Condition(
                name=learner,
                scenario=scenario,
                learner=learner,
                scenario_overrides={"max_cycles": 150},
            )
            for scenario, learner in (
                ("experiment_5", "designated_swap"), ("evening", "views")
            )
        )
        return Study(name="real", conditions=conditions, seeds=seeds, run=run_trial)

    if __name__ == "__main__":
        out, seeds, engine, workers = sys.argv[1:5]
        jobs = prepare([study(tuple(map(int, seeds.split(","))))], Path(out))
        run(jobs, open_engine(engine, int(workers)), lambda: None)
"""


@pytest.fixture
def files_of(program, tmp_path):
    """Runs a study of real trials; returns what its result files hold, by path."""

    def run(engine, workers, seeds):
        out = tmp_path / f"{engine}_{workers}_{seeds}"
        process = program(REAL_TRIALS, out, seeds, engine, workers)
        _, complaint = process.communicate(timeout=300)
        assert process.returncode == 0, complaint
        found = sorted(out.rglob("*.parquet"))
        return {str(path.relative_to(out)): path.read_bytes() for path in found}

    return run


@pytest.mark.slow
def test_results_are_the_same_bytes_for_any_number_of_workers_in_any_order(files_of):
    one = files_of("local", 1, "0,1,2")
    assert len(one) == 6
    for workers, seeds in ((1, "2,0,1"), (2, "0,1,2"), (3, "2,1,0"), (5, "1,2,0")):
        assert files_of("local", workers, seeds) == one


@pytest.mark.slow
@pytest.mark.parametrize(("engine", "package"), [("dask", "distributed"), ("ray",) * 2])
def test_results_are_the_same_bytes_on_a_cluster(files_of, engine, package):
    pytest.importorskip(package)
    assert files_of(engine, 2, "1,0") == files_of("local", 1, "0,1")
