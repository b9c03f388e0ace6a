"""Examples are run as a user runs them: as scripts, in a folder of their own."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Returns a function that runs an example and returns what it made, by name."""
    monkeypatch.chdir(tmp_path)
    return lambda name: runpy.run_path(str(_file(name)), run_name="__main__")


@pytest.fixture
def run_functions(tmp_path, monkeypatch):
    """Returns a function that reads an example, without running its main part."""
    monkeypatch.chdir(tmp_path)
    return lambda name: runpy.run_path(str(_file(name)))


def _file(name):
    return EXAMPLES / f"{name}.py"
