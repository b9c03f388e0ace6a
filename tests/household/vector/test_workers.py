"""Workers never outlive who started them, and what ends one is told."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from household import vector
from household.household_v0 import make_minds
from household.vector.workers import WorkerError

PROC = Path("/proc")
pytestmark = pytest.mark.skipif(not PROC.is_dir(), reason="needs /proc")


def children(pid=None):
    """Who was started by a process."""
    pid = os.getpid() if pid is None else pid
    tasks = (PROC / str(pid) / "task").glob("*/children")
    return {int(child) for task in tasks for child in task.read_text().split()}


def is_alive(pid):
    try:
        return (PROC / str(pid) / "stat").read_text().split()[2] != "Z"
    except OSError:
        return False


def within(seconds, condition):
    """Whether something comes true in time."""
    until = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > until:
            return False
        time.sleep(0.02)
    return True


def started(workers=1, **arguments):
    """A vector environment with so many workers, and their process numbers."""
    before = children()
    homes = workers + 1
    envs = vector.make("evening", homes=homes, workers=workers, seed=1, **arguments)
    return envs, children() - before


def live_on(envs):
    for _ in range(9):
        envs.step(np.zeros(envs.num_envs, int))


def test_close_ends_the_workers_at_once():
    envs, workers = started(2)
    assert len(workers) == 2
    envs.reset()
    envs.close()
    assert not workers & children()
    envs.close()


def test_a_forgotten_environment_ends_its_workers():
    envs, workers = started()
    assert workers <= children()
    del envs
    assert not workers & children()


def test_more_workers_than_homes_are_not_started():
    before = children()
    envs = vector.make("evening", homes=2, workers=5)
    assert len(children() - before) == 1
    envs.close()


def test_a_worker_that_is_killed_ends_the_others_and_is_told():
    envs, workers = started(2)
    envs.reset()
    os.kill(max(workers), signal.SIGKILL)
    with pytest.raises(WorkerError, match="has ended, with status -9"):
        live_on(envs)
    assert envs.closed
    assert not workers & children()


class Sulking:
    """Minds that stop thinking after a while, but not in the process that made them."""

    def __init__(self, scenario):
        self._minds, self._left = make_minds(scenario), 3

    def __getattr__(self, name):
        return getattr(self._minds, name)

    def decide(self, percepts):
        self._left -= 1
        if self._left < 0:
            raise ArithmeticError("no more")
        return self._minds.decide(percepts)


def test_an_error_in_a_worker_is_told_with_its_traceback():
    home = os.getpid()

    def minds(scenario):
        return (Sulking if os.getpid() != home else make_minds)(scenario)

    envs, workers = started(make_minds=minds)
    envs.reset()
    with pytest.raises(WorkerError, match=r"(?s)worker 0 failed:.*Error: no more"):
        live_on(envs)
    assert not workers & children()


def test_an_error_while_workers_start_leaves_none_behind():
    def minds(scenario):
        if os.getpid() != home:
            raise ArithmeticError("not here")
        return make_minds(scenario)

    home, before = os.getpid(), children()
    with pytest.raises(WorkerError, match="not here"):
        vector.make("evening", homes=2, workers=1, make_minds=minds)
    assert children() == before


# Without a guard for the main module, with minds of its own.
SCRIPT = """
import numpy as np
from household import vector
from household.household_v0 import make_minds

def minds(scenario):
    return make_minds(scenario)

envs = vector.make("evening", homes=2, workers=1, seed=1, make_minds=minds)
envs.reset()
print("ready", flush=True)
while True:
    envs.step(np.zeros(4, int))
    {then}
"""


@pytest.mark.parametrize(
    ("how", "then"),
    [
        (signal.SIGKILL, "pass"),
        (signal.SIGTERM, "pass"),
        (signal.SIGINT, "pass"),
        (None, "break"),
        (None, "raise ArithmeticError"),
    ],
    ids=["killed", "terminated", "interrupted", "done", "failed"],
)
def test_no_worker_outlives_its_parent(how, then, tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT.format(then=then))
    parent = subprocess.Popen(
        [sys.executable, script],
        env=os.environ | {"PYTHONPATH": str(Path(vector.__file__).parents[2])},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    workers = set()
    try:
        assert within(
            60, lambda: len(workers.update(children(parent.pid)) or workers) == 1
        )
        assert parent.stdout.readline() == "ready\n"
        if how == signal.SIGINT:
            os.killpg(parent.pid, how)  # As Ctrl-C does: to the whole group.
        elif how is not None:
            parent.send_signal(how)
        _, errors = parent.communicate(timeout=30)
        assert within(10, lambda: not any(map(is_alive, workers)))
    finally:
        parent.kill()
        for worker in filter(is_alive, workers):
            os.kill(worker, signal.SIGKILL)
    # Only the parent's error is told, with those that it was raised in the middle of.
    told = errors.count("Traceback") - errors.count("During handling of the above")
    assert told == (how == signal.SIGINT or "raise" in then)
