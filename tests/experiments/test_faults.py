"""Whatever goes wrong on the way: the same command again finishes, with equal results.

Every test compares all result files, byte for byte, with those of an undisturbed run.
"""

import contextlib
import os
import random
import resource
import runpy
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

from experiments.cli import main

DRIVER = """
    import os, sys, time
    from pathlib import Path
    import numpy as np
    import polars as pl
    from experiments.running.engine import open_engine
    from experiments.running.jobs import prepare, run
    from experiments.running.lock import alone_in
    from experiments.running.study import Condition, Study

    def trial(trial):
        doomed = Path(os.environ.get("MARKERS", "/nowhere")) / str(trial)
        if doomed.exists():
            doomed.unlink()
            os._exit(9)
        time.sleep(float(os.environ.get("TAKES", 0.02)))
        rng = np.random.default_rng([trial.seed, trial.condition.name == "b"])
        return pl.DataFrame({"x": rng.random(9000), "seed": trial.seed})

    def study(seeds):
        conditions = tuple(
            Condition(name=name, scenario="experiment_1", learner="q_social")
            for name in ("a", "b")
        )
        return Study(name="toy", conditions=conditions, seeds=seeds, run=trial)

    if __name__ == "__main__":
        from experiments.errors import ExperimentError
        out, seeds, engine, workers = sys.argv[1:5]
        try:
            with alone_in(Path(out)):
                jobs = prepare([study(tuple(range(int(seeds))))], Path(out))
                print("jobs", len(jobs), flush=True)
                run(
                    jobs, open_engine(engine, int(workers)),
                    lambda: print("stored", flush=True)
                )
        except (ExperimentError, OSError) as error:
            sys.exit(f"refused: {error}")
"""

SEEDS, TRIALS = 10, 20


@pytest.fixture
def drive(program):
    """Starts the driver of a study of 20 trials."""

    def start(out, engine="local", workers=2):
        return program(DRIVER, out, SEEDS, engine, workers)

    return start


@pytest.fixture
def go_on(tmp_path, monkeypatch, capsys):
    """Runs the driver to its end in this process; returns how many trials it ran."""
    script = tmp_path / "driver.py"
    script.write_text(textwrap.dedent(DRIVER))

    def run(out):
        words = [str(script), str(out), str(SEEDS), "here", "1"]
        monkeypatch.setattr(sys, "argv", words)
        capsys.readouterr()
        runpy.run_path(str(script), run_name="__main__")
        return int(capsys.readouterr().out.split()[1])

    return run


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """The directory of a run that nothing happened to."""
    folder = tmp_path_factory.mktemp("undisturbed")
    script, out = folder / "script.py", folder / "out"
    script.write_text(textwrap.dedent(DRIVER))
    command = [sys.executable, script, out, str(SEEDS), "local", "1"]
    subprocess.run(command, check=True, capture_output=True)
    return out


@pytest.fixture(scope="module")
def undisturbed(finished):
    """The files of that run."""
    return results(finished)


def results(out):
    """The content of every result by its path; nothing else may lie there."""
    files = {
        str(path.relative_to(out)): path.read_bytes()
        for path in Path(out).rglob("*")
        if path.is_file() and path.name != "study.json"
    }
    assert all(name.endswith(".parquet") for name in files), list(files)
    return files


def finish(drive, out, **options):
    """Runs the driver to its end; returns how many trials it had to run."""
    process = drive(out, **options)
    said, complaint = process.communicate(timeout=120)
    assert process.returncode == 0, complaint
    return int(said.split()[1])


def wait_for(process, lines):
    for _ in range(lines + 1):
        assert process.stdout.readline()


def test_an_undisturbed_run_stores_every_trial(undisturbed):
    assert len(undisturbed) == TRIALS


def test_after_kill_9_of_the_driver_the_same_command_finishes(
    drive, go_on, tmp_path, undisturbed
):
    out = tmp_path / "out"
    process = drive(out)
    wait_for(process, 4)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert go_on(out) <= TRIALS - 4
    assert results(out) == undisturbed


@pytest.mark.slow
def test_after_24_kills_at_any_moment_the_same_command_finishes(
    drive, tmp_path, undisturbed
):
    rng, out = random.Random(1), tmp_path / "out"
    for _ in range(24):
        process = drive(out)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=rng.uniform(0.0, 2.5))
        whom = os.kill if rng.random() < 0.5 else os.killpg
        with contextlib.suppress(ProcessLookupError):
            whom(process.pid, signal.SIGKILL)
        process.wait()
    finish(drive, out)
    assert results(out) == undisturbed


def test_of_two_drivers_one_is_refused_and_the_other_finishes(
    drive, tmp_path, monkeypatch, undisturbed
):
    out = tmp_path / "out"
    monkeypatch.setenv("TAKES", "0.4")
    first = drive(out)
    wait_for(first, 1)
    second = drive(out)
    _, complaint = second.communicate(timeout=60)
    assert second.returncode == 1
    assert complaint.startswith("refused: --out ")
    assert "another command is at work there" in complaint
    first.communicate(timeout=60)
    assert first.returncode == 0
    assert results(out) == undisturbed


@pytest.mark.slow
def test_of_many_drivers_that_start_at_once_one_finishes(drive, tmp_path, undisturbed):
    for attempt in range(5):
        out = tmp_path / f"out_{attempt}"
        processes = [drive(out) for _ in range(4)]
        ends = [process.wait(timeout=120) for process in processes]
        assert 0 in ends
        assert results(out) == undisturbed


def test_a_result_cut_at_every_tenth_byte_is_run_again(
    go_on, tmp_path, finished, undisturbed
):
    """All trials but two, each elsewhere; `test_trial_files` cuts at every place."""
    out = shutil.copytree(finished, tmp_path / "out")
    cut = sorted(undisturbed)[:-2]
    for place, name in enumerate(cut):
        length = len(undisturbed[name]) * place // len(cut)
        (out / name).write_bytes(undisturbed[name][:length])
    assert go_on(out) == TRIALS - 2
    assert results(out) == undisturbed


def doomed(tmp_path, monkeypatch, *trials):
    """Trials that kill the worker that runs them for the first time."""
    markers = tmp_path / "markers"
    markers.mkdir()
    for trial in trials:
        (markers / trial).touch()
    monkeypatch.setenv("MARKERS", str(markers))
    return markers


def test_workers_that_die_cost_nothing(drive, tmp_path, monkeypatch, undisturbed):
    markers = doomed(tmp_path, monkeypatch, "a, seed 2", "b, seed 7")
    assert finish(drive, tmp_path / "out") == TRIALS
    assert list(markers.iterdir()) == []
    assert results(tmp_path / "out") == undisturbed


@pytest.mark.slow
@pytest.mark.parametrize(("engine", "package"), [("dask", "distributed"), ("ray",) * 2])
def test_workers_of_a_cluster_that_die_cost_nothing(
    drive, tmp_path, monkeypatch, undisturbed, engine, package
):
    pytest.importorskip(package)
    markers = doomed(tmp_path, monkeypatch, "a, seed 2", "b, seed 7")
    finish(drive, tmp_path / "out", engine=engine)
    assert list(markers.iterdir()) == []
    assert results(tmp_path / "out") == undisturbed


def children(pid):
    """Processes below a process, the deepest last."""
    found = []
    for thread in Path(f"/proc/{pid}/task").glob("*/children"):
        with contextlib.suppress(OSError):
            for child in map(int, thread.read_text().split()):
                found += [child, *children(child)]
    return found


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self").exists(), reason="Linux's list of processes")
def test_workers_killed_from_outside_cost_nothing(drive, tmp_path, undisturbed):
    out, rng = tmp_path / "out", random.Random(2)
    process = drive(out)
    wait_for(process, 1)
    for _ in range(3):
        time.sleep(rng.uniform(0.0, 0.3))
        below = [
            pid
            for pid in children(process.pid)
            if b"forkserver" in Path(f"/proc/{pid}/cmdline").read_bytes()
            and not children(pid)
        ]
        if below:
            os.kill(rng.choice(below), signal.SIGKILL)
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 0, complaint
    assert results(out) == undisturbed


def test_results_too_large_for_the_disk_are_one_line_and_a_later_run_goes_on(
    drive, go_on, tmp_path, undisturbed
):
    """The system refuses files of more than 40 kB, as a full disk would."""
    out, before = tmp_path / "out", resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, before[1]))
    try:
        process = drive(out)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 1
    assert complaint.startswith(f"refused: {out}/toy/trials/")
    assert "the disk is full (it needs more than" in complaint
    assert complaint.count("\n") == 1
    assert results(out) == {}
    go_on(out)
    assert results(out) == undisturbed


def test_files_from_the_future_and_the_past_are_results_all_the_same(
    go_on, tmp_path, finished, undisturbed
):
    """A clock that goes backwards dates files anyhow; nothing looks at that."""
    out = shutil.copytree(finished, tmp_path / "out")
    for place, name in enumerate(undisturbed):
        moment = 0 if place % 2 else 4e9
        os.utime(out / name, (moment, moment))
    assert go_on(out) == 0
    assert results(out) == undisturbed


@pytest.fixture
def mounted(tmp_path):
    """Mounts a small disk of its own, which only the superuser may."""
    where = tmp_path / "disk"
    where.mkdir()

    def mount(options):
        command = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(where)]
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        except OSError as error:
            pytest.skip(f"no mount here: {error}")
        if done.returncode:
            pytest.skip(f"mounting needs the superuser: {done.stderr.strip()}")
        return where

    yield mount
    subprocess.run(["umount", str(where)], capture_output=True, check=False)


TINY_DEMANDS = """
    import sys
    from experiments.commands import training
    from experiments.running import jobs
    training.SPACE = training.SPACE_PER_BEING = jobs.SPACE = jobs.SPACE_PER_TRIAL = 0
    from experiments.cli import main
    sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.slow
def test_on_a_small_disk_space_is_asked_for_at_once(mounted, capsys):
    out = mounted("size=1m") / "out"
    for words in (
        ["train", "evening", "--decisions", "3000"],
        ["reproduce", "1", "--seeds", "2"],
    ):
        assert main([*words, "--out", str(out)]) == 2
        said = capsys.readouterr().err
        assert said.startswith(f"household: --out {out}: 1.")
        assert "MB are free" in said
        assert said.count("\n") == 1


@pytest.mark.slow
def test_a_disk_that_fills_while_training_keeps_results_before_the_replay(
    mounted, program
):
    out = mounted("size=1500k") / "out"
    words = ["train", "evening", "--decisions", "3000", "--out", out]
    process = program(TINY_DEMANDS, *words)
    _, said = process.communicate(timeout=300)
    last = [line for line in said.splitlines() if line.startswith("household: ")]
    assert process.returncode == 2
    assert len(last) == 1
    assert str(out) in last[0]
    assert "Traceback" not in said
    names = sorted(path.name for path in out.iterdir())
    assert set(names) >= {"trial.parquet", "robot_0.json", "robot_1.json"}


@pytest.mark.slow
@pytest.mark.parametrize("size", ["8k", "64k", "120k", "160k", "200k"])
def test_on_a_disk_too_small_for_a_replays_beginning_nothing_waits(
    mounted, program, size
):
    """Rerun did, at the end of the process, in one of two runs."""
    out = mounted(f"size={size}") / "out"
    words = ["train", "evening", "--decisions", "300", "--out", out]
    process = program(TINY_DEMANDS, *words)
    _, said = process.communicate(timeout=120)
    last = [line for line in said.splitlines() if line.startswith("household: ")]
    assert process.returncode == 2
    assert "cannot be written to its end; the disk may be full" in last[-1]
    assert "Traceback" not in said


@pytest.mark.slow
def test_on_a_disk_that_cannot_be_written_to_every_command_is_one_line(mounted, capsys):
    out = mounted("size=1m,ro") / "out"
    for words in (
        ["train", "experiment_1", "--decisions", "5"],
        ["reproduce", "1", "--seeds", "1"],
        ["study", "actors", "--seeds", "1"],
        ["evaluate", "random", "--suite", "phone", "--seeds", "1"],
        ["bench"],
    ):
        assert main([*words, "--out", str(out)]) == 2
        said = capsys.readouterr().err
        assert f"--out {out}: cannot be written to (Read-only file system)" in said
        assert said.count("\n") == 1


def test_after_kill_9_of_a_training_the_same_command_gives_the_same(tmp_path):
    words = ["train", "experiment_1", "--decisions", "1500", "--out"]
    command = [sys.executable, "-m", "experiments", *words, str(tmp_path / "killed")]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    said = process.stdout.readline()
    while said.startswith("0 of 1500"):  # again and again, if it has to compile
        said = process.stdout.readline()
    assert said.startswith("150 of 1500")
    process.kill()
    process.communicate()
    left = {path.name for path in (tmp_path / "killed").iterdir()}
    assert left <= {".lock", "replay.rrd"}
    for name in ("killed", "fresh"):
        assert main([*words, str(tmp_path / name)]) == 0
    names = ("robot_0.json", "trial.parquet")
    one, other = (
        [(tmp_path / folder / name).read_bytes() for name in names]
        for folder in ("killed", "fresh")
    )
    assert one == other
    assert {path.name for path in (tmp_path / "killed").iterdir()} == {
        *names,
        "replay.rrd",
    }
