"""Who waits for the compiler is told so, once, and only if the wait is long."""

import importlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from numba import float64

import household
from household.compiled import jit
from household.compiled.patience import ENOUGH, NOTICE, PATIENCE, Patience

ROOT = Path(household.__file__).parents[1]


@pytest.fixture
def took(monkeypatch):
    """What waiting for the compiler is counted as, a list [s]."""
    waits = []
    monkeypatch.setattr(PATIENCE, "add", waits.append)
    return waits


def of_a_float(function):
    """A function as another process finds it: nothing of it was compiled here yet."""
    return jit.compile_for(jit.compiled(function.py_func), (float64,))


def test_what_is_compiled_is_a_wait_once_and_what_is_read_from_disk_is_none(
    took, tmp_path, monkeypatch
):
    (tmp_path / "doubling.py").write_text(
        "from household.compiled.jit import compiled\n\n"
        "@compiled\ndef double(x):\n    return 2.0 * x\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    double = importlib.import_module("doubling").double
    assert jit.compile_for(double, (float64,))(4.0) == 8.0
    assert len(took) == 1
    assert took[0] > 0.0
    jit.compile_for(double, (float64,))  # known here already
    assert of_a_float(double)(4.0) == 8.0  # known on disk
    assert len(took) == 1


def test_a_long_wait_is_told_once_and_a_short_one_never(capsys):
    patience = Patience()
    patience.add(ENOUGH)
    assert capsys.readouterr().err == ""
    for _ in range(3):
        patience.add(ENOUGH)
    assert capsys.readouterr().err == f"{NOTICE}\n"
    assert patience.waited == 4 * ENOUGH


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
