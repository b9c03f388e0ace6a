"""Who waits for the compiler is told so, once, and only if the wait is long."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

import household
from household.compiled.patience import ENOUGH, NOTICE, SHORT, Patience

ROOT = Path(household.__file__).parents[1]


def test_what_is_read_from_disk_is_no_wait(capsys):
    patience = Patience()
    for _ in range(1000):
        patience.add(SHORT / 2)
    assert patience.waited == 0.0
    assert capsys.readouterr().err == ""


def test_a_long_wait_is_told_once_and_a_short_one_never(capsys):
    patience = Patience()
    patience.add(ENOUGH)
    assert capsys.readouterr().err == ""
    for _ in range(3):
        patience.add(ENOUGH)
    assert capsys.readouterr().err == f"{NOTICE}\n"
    assert patience.waited == 4 * ENOUGH


def test_the_wait_lasts_as_long_as_something_is_compiled(monkeypatch):
    clock = iter((5.0, 5.75))
    monkeypatch.setattr(time, "perf_counter", lambda: next(clock))
    patience = Patience()
    with patience.waiting():
        pass
    assert patience.waited == 0.75


@pytest.mark.slow
def test_nothing_is_left_to_compile_after_warming_up(tmp_path):
    for package in ("experiments", "household", "learners", "policies"):
        without = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / package, tmp_path / package, ignore=without)
    plain = {name: each for name, each in os.environ.items() if "NUMBA" not in name}

    def run(*words):
        return subprocess.run(
            [sys.executable, *words],
            cwd=tmp_path,
            env=plain | {"PYTHONPATH": str(tmp_path)},
            capture_output=True,
            text=True,
            check=True,
        )

    first, second = (run("-m", "experiments", "warm-up") for _ in range(2))
    assert first.stderr.strip() == NOTICE
    assert "Compiled in" in first.stdout
    assert second.stderr == ""
    assert "compiled already" in second.stdout
    kept = set(tmp_path.rglob("*.nbi")), set(tmp_path.rglob("*.nbc"))
    assert len(kept[0]) > 20
    run("-m", "experiments", "train", "party", "--decisions", "300", "--out", "out")
    assert kept == (set(tmp_path.rglob("*.nbi")), set(tmp_path.rglob("*.nbc")))
