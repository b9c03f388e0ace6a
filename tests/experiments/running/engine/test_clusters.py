"""What Dask and Ray have to keep, each on a cluster of its own on this machine."""

import json

import pytest

MODULES = {"dask": "distributed", "ray": "ray"}

TROUBLED = """
    import json, os, sys
    from pathlib import Path
    from experiments.running.engine import open_engine, run_trials

    def trial(number):
        marker = Path(os.environ["MARKERS"]) / f"ran_{number}"
        first = not marker.exists()
        marker.touch()
        if number == 3 and first:
            os._exit(9)
        if number == 5:
            raise ValueError("five")
        return number * number

    if __name__ == "__main__":
        rows = [
            f"{o.trial} {o.value} {isinstance(o.error, ValueError)}"
            for o in run_trials(trial, range(8), open_engine(sys.argv[1], 2))
        ]
        # Not printed: Ray writes into the output, from a thread, that a worker died.
        Path(os.environ["ROWS"]).write_text(json.dumps(sorted(rows)))
"""

TWICE_THE_SAME = """
    import os, sys, tempfile
    from experiments.running.engine import open_engine, run_trials

    def trial(folder):
        tempfile.mkstemp(dir=folder)
        return True

    if __name__ == "__main__":
        folder = os.environ["MARKERS"]
        outcomes = run_trials(trial, [folder, folder], open_engine(sys.argv[1], 2))
        print([o.value for o in outcomes], len(os.listdir(folder)), flush=True)
"""

JOINED_BY_ADDRESS = """
    import os
    from distributed import LocalCluster
    from experiments.running.engine import open_engine, run_trials

    def trial(number):
        return os.getpid()

    if __name__ == "__main__":
        with LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster:
            there = {worker.pid for worker in cluster.workers.values()}
            engine = open_engine(f"dask:{cluster.scheduler_address}")
            did = {o.value for o in run_trials(trial, range(8), engine)}
            print(did <= there, engine.window, flush=True)
"""


OF_OUR_OWN = """
    from distributed import default_client
    from experiments.running.engine import open_engine

    if __name__ == "__main__":
        open_engine("dask", 1)
        print(default_client().scheduler.address.rpartition(":")[0], flush=True)
"""

OF_OUR_OWN_BY_RAY = """
    import os
    from experiments.running.engine import open_engine

    if __name__ == "__main__":
        open_engine("ray", 1)  # which sets the token before Ray is imported
        import ray
        where = {node["NodeManagerAddress"] for node in ray.nodes()}
        print(where, os.environ["RAY_AUTH_MODE"], flush=True)
"""


@pytest.fixture(params=MODULES)
def cluster(request, tmp_path, monkeypatch):
    """Name of an engine that is installed; its trials leave markers in a folder."""
    pytest.importorskip(MODULES[request.param])
    (tmp_path / "markers").mkdir()
    monkeypatch.setenv("MARKERS", str(tmp_path / "markers"))
    return request.param


def test_a_dead_worker_costs_nothing_and_a_trials_own_exception_is_reported(
    cluster, program, group_is_empty, tmp_path, monkeypatch
):
    monkeypatch.setenv("ROWS", str(tmp_path / "rows.json"))
    process = program(TROUBLED, cluster)
    out, err = process.communicate(timeout=100)
    assert process.returncode == 0, out + err
    expected = [f"{n} {n * n} False" for n in range(8) if n != 5]
    rows = json.loads((tmp_path / "rows.json").read_text())
    assert rows == sorted([*expected, "5 None True"]), err
    assert group_is_empty(process.pid)


def test_two_equal_trials_are_both_run(cluster, program):
    out, err = program(TWICE_THE_SAME, cluster).communicate(timeout=100)
    assert out == "[True, True] 2\n", err


def test_trials_run_on_the_workers_of_a_dask_cluster_joined_by_its_address(program):
    pytest.importorskip("distributed")
    out, err = program(JOINED_BY_ADDRESS).communicate(timeout=100)
    assert out == "True 4\n", err


def test_a_dask_cluster_of_our_own_has_keys_and_no_public_address(program):
    pytest.importorskip("distributed")
    out, err = program(OF_OUR_OWN).communicate(timeout=100)
    assert out == "tls://127.0.0.1\n", err


def test_a_ray_cluster_of_our_own_has_a_token_and_no_public_address(program):
    pytest.importorskip("ray")
    out, err = program(OF_OUR_OWN_BY_RAY).communicate(timeout=100)
    assert "{'127.0.0.1'} token" in out, err
