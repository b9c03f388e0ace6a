"""Where commands write to: paths stay what they are, and nobody has to read."""

import os
import subprocess
import sys

import pytest

from experiments.cli import main

ODD = "out [b] :smile: [x"
"""A name that rich would read as markup."""


def test_square_brackets_in_a_path_are_no_markup(capsys, tmp_path):
    out = tmp_path / ODD
    words = ["train", "experiment_1", "--decisions", "20", "--out", str(out)]
    assert main(words) == 0
    said = capsys.readouterr().out.splitlines()
    assert len([line for line in said if ODD in line]) == 3
    assert sorted(path.name for path in out.iterdir()) == [
        "replay.rrd",
        "robot_0.json",
        "trial.parquet",
    ]


@pytest.mark.parametrize("name", ["[b].toml", ":smile:.toml"])
def test_square_brackets_in_a_message_are_no_markup(capsys, tmp_path, name):
    file = tmp_path / name
    file.write_text('nmae = "mine"\n')
    assert main(["check", str(file)]) == 2
    assert str(file) in capsys.readouterr().err


def test_a_reader_who_leaves_does_not_end_the_work(tmp_path):
    """As `household train ... | head -1` does."""
    command = [sys.executable, "-m", "experiments", "train", "experiment_1"]
    process = subprocess.Popen(
        [*command, "--decisions", "300", "--out", str(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"PYTHONUNBUFFERED": "1"},
    )
    assert process.stdout.readline().startswith("0 of 300 decisions")
    process.stdout.close()
    said = process.stderr.read()
    assert (process.wait(timeout=60), said) == (0, "")
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "replay.rrd",
        "robot_0.json",
        "trial.parquet",
    ]


def test_progress_goes_on_where_the_clock_stands_still_or_goes_back(monkeypatch):
    from rich.console import Console

    from experiments.running import progress

    times = iter([5.0, 5.0, 4.0, 3.0, 1000.0, 2.0] * 10)
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(times))
    for terminal in (False, True):
        console = Console(force_terminal=terminal, quiet=True)
        with progress.progress(console, "trials", 5) as advance:
            for _ in range(5):
                advance()
