"""Two commands never work in one directory."""

import os
import signal

import pytest

from experiments.cli import main
from experiments.errors import ExperimentError
from experiments.running.lock import alone_in

HOLDER = """
    import sys
    from pathlib import Path
    from experiments.running.lock import alone_in

    with alone_in(Path(sys.argv[1])):
        print("alone", flush=True)
        sys.stdin.read()
"""


@pytest.fixture
def holder(program, tmp_path):
    """A process that is at work in a directory."""
    process = program(HOLDER, tmp_path / "out")
    assert process.stdout.readline() == "alone\n"
    return process


def test_the_second_is_refused_in_one_line(holder, tmp_path):
    with (
        pytest.raises(ExperimentError, match="another command is at work there"),
        alone_in(tmp_path / "out"),
    ):
        pass
    holder.communicate("go")
    assert holder.returncode == 0


@pytest.mark.parametrize(
    "words",
    [
        ["reproduce", "1", "--seeds", "1"],
        ["train", "experiment_1", "--decisions", "5"],
        ["study", "actors", "--seeds", "1"],
    ],
)
def test_every_command_that_runs_trials_keeps_out(holder, tmp_path, capsys, words):
    out = tmp_path / "out"
    assert main([*words, "--out", str(out)]) == 2
    assert "another command is at work there" in capsys.readouterr().err
    assert [path.name for path in out.iterdir()] == [".lock"]


def test_a_report_waits_for_nobody(holder, tmp_path, capsys):
    assert main(["report", str(tmp_path / "out")]) == 2
    assert "another command is at work there" in capsys.readouterr().err


def test_the_lock_dies_with_its_holder(holder, tmp_path):
    os.kill(holder.pid, signal.SIGKILL)
    holder.wait()
    with alone_in(tmp_path / "out"):
        pass


def test_nothing_is_left_of_the_lock(tmp_path):
    for _ in range(2):
        with alone_in(tmp_path / "out"):
            assert [path.name for path in (tmp_path / "out").iterdir()] == [".lock"]
        assert list((tmp_path / "out").iterdir()) == []


def test_a_lock_that_its_holder_has_just_removed_does_not_count(tmp_path, monkeypatch):
    """Somebody opened the file, and its holder removed it before it was locked."""
    from experiments.running import lock

    real, removed = lock._lock, []

    def late(file):
        if not removed:
            removed.append(True)
            (tmp_path / ".lock").unlink()
        return real(file)

    monkeypatch.setattr(lock, "_lock", late)
    with alone_in(tmp_path):
        assert (tmp_path / ".lock").exists()
        with pytest.raises(ExperimentError), alone_in(tmp_path):
            pass
