"""Compiling: what is kept on disk, when it is forgotten, that it changes nothing."""

import os
import subprocess
import sys
from typing import Annotated

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import (
    PACKAGES,
    bind,
    compiled,
    forget_outdated,
)

A_MINUTE = """
import hashlib
from household import household_v0

env = household_v0.parallel_env("evening")
env.reset(seed=3)
read = hashlib.sha256()
for step in range(60):
    env.step({agent: (step // 5 + i) % 8 for i, agent in enumerate(env.agents)})
    read.update(env.state().tobytes() + env.simulation.crowd.position.tobytes())
print(read.hexdigest())
"""


def test_what_was_compiled_before_any_source_changed_is_forgotten(tmp_path):
    """A change in one file also counts for functions of others, which may call it."""
    kept = []
    for package, changed in (("one", 100), ("other", 200)):
        source = tmp_path / package / "loops.py"
        index = tmp_path / package / "inner" / "__pycache__" / "loops.f.nbi"
        index.parent.mkdir(parents=True)
        for file, when in ((source, changed), (index, 150)):
            file.touch()
            os.utime(file, (when, when))
        kept.append(index)
    forget_outdated([tmp_path / "one"])
    assert [index.exists() for index in kept] == [True, True]
    forget_outdated([tmp_path / "one", tmp_path / "other"])
    assert [index.exists() for index in kept] == [False, False]


def test_all_compiled_functions_are_where_changes_are_looked_for():
    (root,) = {package.parent for package in PACKAGES}
    assert [package.name for package in PACKAGES] == ["household", "policies"]
    names = ("experiments", "household", "learners", "policies")
    sources = [file for name in names for file in (root / name).rglob("*.py")]
    compiles = [file for file in sources if "@compiled\n" in file.read_text("utf-8")]
    assert root / "household" / "perception" / "senses.py" in compiles
    for file in compiles:
        assert any(file.is_relative_to(package) for package in PACKAGES)


def test_a_minute_is_the_same_compiled_or_not(capsys):
    plain = subprocess.run(
        [sys.executable, "-c", A_MINUTE],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        check=True,
        text=True,
    ).stdout
    exec(A_MINUTE, {})
    assert capsys.readouterr().out == plain != ""


@compiled
def _weighed(weights, values: Annotated[Floats, "n"], most: float):
    """The weighed sum of values, at most so much."""
    return min((weights * values).sum(), most)


def test_a_bound_function_knows_its_first_arguments_and_takes_the_others():
    weigh = bind(_weighed, np.array([1.0, 10.0]))
    values = np.array([2.0, 3.0, 4.0])
    assert weigh(values[:2], 100.0) == 32.0
    # Arrays with gaps, too, and whole numbers for others.
    assert weigh(values[::2], 100) == 42.0
    assert weigh(values[:2], 5) == 5.0
