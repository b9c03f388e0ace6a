import errno
import os
import signal
import sys
import time
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor

import pytest

from experiments.errors import ExperimentError
from experiments.running.engine import Engine, open_engine, run_trials

PROGRAM = """
    import os, sys, time
    from pathlib import Path
    from experiments.running.engine import open_engine, run_trials

    def trial(number):
        if number >= 4:
            time.sleep(600)
        return number

    if __name__ == "__main__":
        for outcome in run_trials(trial, range(40), open_engine("local", 2)):
            print(outcome.value, flush=True)
"""

INTERRUPTED_INSIDE = """
    import signal, sys, time
    from threading import Condition
    from experiments.running.engine import open_engine, run_trials

    at, seen = int(sys.argv[1]), 0

    def trial(number):
        if number >= 4:
            time.sleep(600)
        return number

    def interrupt(frame, event, _):
        global seen
        if event == "return" and frame.f_code is Condition.__enter__.__code__:
            seen += 1
            if seen == at:
                sys.setprofile(None)
                print("interrupted", flush=True)
                signal.raise_signal(signal.SIGINT)

    if __name__ == "__main__":
        for outcome in run_trials(trial, range(40), open_engine("local", 2)):
            if outcome.value == 3:
                sys.setprofile(interrupt)
"""

SLOW_TO_START = """
    import os, time
    from experiments.running.engine import open_engine, run_trials

    def trial(number):
        return number

    if __name__ == "__main__":
        for outcome in run_trials(trial, range(2), open_engine("local", 1)):
            print(outcome.value, flush=True)
    else:
        print(os.getpid(), flush=True)
        time.sleep(1)
"""

CRASHES = """
    import os, sys
    from pathlib import Path
    from experiments.running.engine import open_engine, run_trials

    def trial(number):
        marker = Path(os.environ["MARKERS"]) / f"ran_{number}"
        first = not marker.exists()
        marker.touch()
        if number == 7 or (number == 3 and first):
            os._exit(9)
        if number == 5:
            raise ValueError("five")
        return number

    if __name__ == "__main__":
        for o in run_trials(trial, range(12), open_engine("local", 2)):
            print(o.trial, o.value, type(o.error).__name__, o.attempts, flush=True)
"""


def threads(workers):
    return Engine(open=lambda: ThreadPoolExecutor(workers), window=workers)


def square(number):
    return number * number


def picky(number):
    if number == 2:
        raise ValueError("two is odd here")
    return number


def test_every_trial_comes_out_once_with_its_own_value():
    outcomes = list(run_trials(square, range(20), threads(3)))
    assert sorted(o.trial for o in outcomes) == list(range(20))
    assert all(o.value == o.trial**2 and o.error is None for o in outcomes)


def test_a_trials_own_exception_is_reported_and_not_tried_again():
    outcomes = {o.trial: o for o in run_trials(picky, range(5), threads(2))}
    assert isinstance(outcomes[2].error, ValueError)
    assert outcomes[2].attempts == 1
    assert [outcomes[n].value for n in (0, 1, 3, 4)] == [0, 1, 3, 4]


def test_no_more_trials_are_read_than_the_window_holds():
    read = []

    def trials():
        for number in range(100):
            read.append(number)
            yield number

    outcomes = run_trials(square, trials(), threads(2))
    next(outcomes)
    assert len(read) <= 4
    outcomes.close()


class BreaksOn(Executor):
    """Runs at once; the trial named `bad` breaks it and everything that follows."""

    def __init__(self, bad, log):
        self.bad, self.log, self.broken = bad, log, False

    def submit(self, fn, /, *args, **kwargs):
        if self.broken:
            raise BrokenExecutor
        future = Future()
        self.log.append(args[0])
        if args[0] == self.bad:
            self.broken = True
            future.set_exception(BrokenExecutor())
        else:
            future.set_result(fn(*args, **kwargs))
        return future

    def shutdown(self, wait=True, *, cancel_futures=False):
        pass


def test_a_trial_that_always_breaks_its_executor_is_given_up_after_three_attempts():
    log = []
    engine = Engine(open=lambda: BreaksOn(1, log), window=1)
    outcomes = {o.trial: o for o in run_trials(square, range(3), engine)}
    assert isinstance(outcomes[1].error, BrokenExecutor)
    assert outcomes[1].attempts == 3
    assert log.count(1) == 3
    assert outcomes[0].value == 0
    assert outcomes[2].value == 4


class TakesItselfDown(BreaksOn):
    """Closes its pipes while it is handed a trial, as a breaking pool does."""

    def submit(self, fn, /, *args, **kwargs):
        if args[0] == self.bad and not self.broken:
            self.broken = True
            raise OSError(errno.EBADF, "Bad file descriptor")
        return super().submit(fn, *args, **kwargs)


def test_an_executor_that_breaks_while_handed_a_trial_costs_nothing():
    opened = []

    def reopened():
        bad = None if opened else 1
        opened.append(TakesItselfDown(bad, []))
        return opened[-1]

    outcomes = list(run_trials(square, range(3), Engine(open=reopened, window=1)))
    assert [(o.value, o.error, o.attempts) for o in outcomes] == [
        (0, None, 1), (1, None, 1), (4, None, 1),
    ]  # fmt: skip
    assert len(opened) == 2


def test_executors_that_only_ever_break_end_the_run_with_their_error():
    engine = Engine(open=lambda: TakesItselfDown(0, []), window=1)
    with pytest.raises(OSError, match="Bad file"):
        list(run_trials(square, range(3), engine))


def test_in_real_processes_crashes_cost_nothing_but_the_trial_that_crashes(
    program, tmp_path, monkeypatch
):
    markers = tmp_path / "markers"
    markers.mkdir()
    monkeypatch.setenv("MARKERS", str(markers))
    out, err = program(CRASHES).communicate(timeout=100)
    rows = {int(line.split()[0]): line.split()[1:] for line in out.splitlines()}
    assert len(rows) == 12, err
    assert rows[7] == ["None", "BrokenProcessPool", "3"]
    assert rows[5][:2] == ["None", "ValueError"]
    assert all(rows[n][0] == str(n) for n in range(12) if n not in (5, 7))


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL, signal.SIGTERM])
def test_a_stopped_run_leaves_no_process_behind(program, group_is_empty, how):
    process = program(PROGRAM)
    lines = [process.stdout.readline() for _ in range(4)]
    assert sorted(lines) == ["0\n", "1\n", "2\n", "3\n"]
    time.sleep(0.2)
    os.kill(process.pid, how)
    process.wait(timeout=30)
    assert group_is_empty(process.pid)


def test_ctrl_c_in_a_terminal_reaches_the_whole_group_and_prints_one_traceback(
    program, group_is_empty
):
    process = program(PROGRAM)
    for _ in range(4):
        process.stdout.readline()
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=30)
    assert group_is_empty(process.pid)
    assert err.count("KeyboardInterrupt") == 1


def test_a_worker_leaves_ctrl_c_to_its_parent_from_the_start(program):
    process = program(SLOW_TO_START)
    os.kill(int(process.stdout.readline()), signal.SIGINT)
    assert process.communicate(timeout=30) == ("0\n1\n", "")


@pytest.mark.parametrize("at", [1, 2, 3])
def test_ctrl_c_just_after_a_lock_was_taken_does_not_leave_it_locked(
    program, group_is_empty, at
):
    process = program(INTERRUPTED_INSIDE, at)
    out, err = process.communicate(timeout=30)
    assert out == "interrupted\n"
    assert err.count("KeyboardInterrupt") == 1
    assert group_is_empty(process.pid)


@pytest.mark.parametrize(
    ("spec", "workers", "said"),
    [
        ("locl", None, "did you mean 'local'?"),
        ("local", 0, "--workers must be at least 1, got 0"),
        ("local:somewhere", None, "takes no address"),
    ],
)
def test_a_wrong_engine_is_named_in_one_line(spec, workers, said):
    with pytest.raises(ExperimentError) as caught:
        open_engine(spec, workers)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["dask", "ray"])
def test_an_engine_that_is_not_installed_says_how_to_install_it(name, monkeypatch):
    module = {"dask": "distributed", "ray": "ray"}[name]
    monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.delitem(
        sys.modules, f"experiments.running.engine.{name}", raising=False
    )
    with pytest.raises(ExperimentError, match=rf"polite-household\[{name}\]"):
        open_engine(name)
