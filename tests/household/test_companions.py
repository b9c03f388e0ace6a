"""Another package of a companion's name is noticed when `household` is imported."""

import subprocess
import sys
from pathlib import Path

import pytest

import household
from household.companions import COMPANIONS, check_companions

ROOT = Path(household.__file__).parents[1]


def imported(folder):
    """What a process that finds a folder's packages first says on importing ours."""
    code = (
        f"import sys; sys.path[:0] = [{str(folder)!r}, {str(ROOT)!r}]; import household"
    )
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("name", COMPANIONS)
def test_a_package_that_comes_first_is_named_in_one_line(name, tmp_path):
    (tmp_path / name).mkdir()
    (tmp_path / name / "__init__.py").touch()
    told = imported(tmp_path).stderr.splitlines()[-1]
    assert told.startswith(f"ImportError: household comes with a package {name!r}")
    assert str(tmp_path / name) in told


def test_a_script_of_that_name_is_named_itself(tmp_path):
    script = tmp_path / "experiments.py"
    script.touch()
    assert f"in its place: {script}; " in imported(tmp_path).stderr.splitlines()[-1]


def test_a_folder_that_is_no_package_shadows_nothing(tmp_path):
    (tmp_path / "experiments").mkdir()
    assert imported(tmp_path).returncode == 0


def test_a_package_that_lies_over_ours_is_noticed(tmp_path, monkeypatch):
    for name in (*COMPANIONS, "household"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").touch()
    monkeypatch.syspath_prepend(tmp_path)
    for name in COMPANIONS:
        monkeypatch.delitem(sys.modules, name, raising=False)
    with pytest.raises(ImportError, match="'learners'"):
        check_companions(tmp_path)
