"""Processes that start together: one compiles a function, and the others get it."""

import importlib
import subprocess
import sys
from pathlib import Path

import pytest
from numba import float64

from household.compiled import jit
from household.compiled.sharing import Later, turn_at

TRIPLE = (
    "from household.compiled.jit import compiled\n\n"
    "@compiled\ndef triple(x):\n    return 3.0 * x\n"
)

HELD = """
import sys
from pathlib import Path

from household.compiled.sharing import turn_at

with turn_at(Path(sys.argv[1]), wait=True) as mine:
    print(mine, flush=True)
    sys.stdin.readline()
"""


@pytest.fixture
def somebody():
    """Starts processes that have their turn at a file until they are told to end it."""
    started = []

    def begin(path: Path) -> subprocess.Popen:
        other = subprocess.Popen(
            [sys.executable, "-c", HELD, str(path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        started.append(other)
        assert other.stdout.readline() == "True\n"
        return other

    yield begin
    for other in started:
        other.kill()
        other.communicate()


def test_one_at_a_time_has_its_turn_and_the_next_when_it_has_ended(tmp_path, somebody):
    path = tmp_path / "turn.lock"
    other = somebody(path)
    with turn_at(path, wait=False) as mine:
        assert not mine
    with turn_at(tmp_path / "another.lock", wait=False) as mine:
        assert mine
    other.communicate("end\n")
    with turn_at(path, wait=False) as mine:
        assert mine


def test_a_killed_process_ends_its_turn(tmp_path, somebody):
    path = tmp_path / "turn.lock"
    somebody(path).kill()
    with turn_at(path, wait=True) as mine:
        assert mine


def test_where_nothing_can_be_written_everybody_has_its_turn(tmp_path):
    (tmp_path / "file").touch()
    for path in (None, tmp_path / "file" / "below.lock"):
        with turn_at(path, wait=False) as one, turn_at(path, wait=False) as other:
            assert one
            assert other


def test_what_another_process_compiles_is_got_at_the_first_call(
    tmp_path, somebody, monkeypatch
):
    (tmp_path / "tripling.py").write_text(TRIPLE)
    monkeypatch.syspath_prepend(tmp_path)
    triple = importlib.import_module("tripling").triple
    other = somebody(jit._turn_of(triple))
    found = jit.compile_for(triple, (float64,))
    assert isinstance(found, Later)
    assert not triple.overloads
    other.communicate("end\n")
    assert found(2.0) == 6.0
    assert found(3.0) == 9.0
    assert not isinstance(jit.compile_for(triple, (float64,)), Later)
