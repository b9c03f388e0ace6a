import os
import signal
import subprocess
import sys
import textwrap
import time
from dataclasses import fields

import numpy as np
import pytest
from pettingzoo.utils.conversions import parallel_to_aec

from household import household_v0
from household.errors import HouseholdError
from household.replay import RecordEpisodes
from household.replay.buffer import REMEMBERED, Buffer
from household.replay.marks import Marks
from household.replay.reading import read_replay
from household.replay.recorder import Recorder
from household.replay.rows import bends
from household.simulation.snapshot import Snapshot, snapshot


@pytest.fixture(autouse=True)
def strict():
    """Rerun warns of data that it cannot use; here it raises."""
    import rerun as rr

    rr.set_strict_mode(True)
    yield
    rr.set_strict_mode(False)


def choose(env, rng):
    return {agent: int(rng.integers(len(env.behaviors))) for agent in env.agents}


def equal(one: Snapshot, other: Snapshot) -> bool:
    """Whether two snapshots are equal, bit for bit and in their types."""
    return all(
        a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
        if isinstance(a, np.ndarray)
        else type(a) is type(b) and a == b
        for a, b in (
            (getattr(one, field.name), getattr(other, field.name))
            for field in fields(Snapshot)
        )
    )


@pytest.fixture
def lived(busy_home, tmp_path):
    """A whole episode: its snapshots, its rewards and its file."""
    env = RecordEpisodes(busy_home, tmp_path, flush_every=64)
    env.reset(seed=3)
    moments, rewards, rng = (
        [snapshot(busy_home.simulation)],
        [],
        np.random.default_rng(0),
    )
    while env.agents:
        _, reward, *_ = env.step(choose(env, rng))
        rewards.append([reward[a] for a in env.possible_agents])
        moments.append(snapshot(busy_home.simulation))
    return moments, rewards, tmp_path / "episode_00000.rrd"


def test_what_is_read_back_is_what_happened_bit_for_bit(lived):
    moments, rewards, path = lived
    replay = read_replay(path, tried=True)
    assert len(replay) == len(moments) == 301
    assert all(equal(a, b) for a, b in zip(replay, moments, strict=True))
    assert replay.moments.reward[1:].tolist() == rewards
    assert sum(len(m.touches) for m in moments) > 20
    assert {t.feedback.kind for m in moments for t in m.touches} == {"tap", "caress"}


def test_the_scenario_travels_in_the_file(lived, busy_home):
    scenario = read_replay(lived[2], tried=True).scenario
    assert scenario.plan == busy_home.scenario.plan
    assert scenario.people == busy_home.scenario.people
    assert scenario.behaviors == busy_home.scenario.behaviors


def test_recording_changes_nothing(lived, make_busy_home):
    env = make_busy_home()
    env.reset(seed=3)
    rng = np.random.default_rng(0)
    while env.agents:
        env.step(choose(env, rng))
    assert equal(snapshot(env.simulation), lived[0][-1])


def test_a_snapshot_does_not_change_with_the_household(busy_home):
    busy_home.reset(seed=1)
    before, again = snapshot(busy_home.simulation), snapshot(busy_home.simulation)
    for _ in range(30):
        busy_home.step(choose(busy_home, np.random.default_rng(0)))
    assert equal(before, again)
    assert not equal(before, snapshot(busy_home.simulation))


def test_lines_between_the_bends_of_a_course_miss_no_value_by_much():
    rng = np.random.default_rng(0)
    course = np.cumsum(rng.normal(0.0, 0.002, (500, 2)), axis=0)
    course[200:, 0] += 1.0  # A jump is told at both its ends.
    course[300:400] = course[300]
    where = bends(course, 0.01)
    rows = np.arange(len(course))
    drawn = [np.interp(rows, where, course[where, k]) for k in range(2)]
    assert np.abs(np.transpose(drawn) - course).max() <= 0.02
    assert {0, 199, 200, 499} <= set(where.tolist())
    assert len(where) < 250
    assert bends(np.zeros((9, 2)), 0.0).tolist() == [0, 8]


def test_marks_stay_for_a_while_or_until_another_takes_their_place():
    marks = Marks(stay=5)
    marks.items += [(1, "a", "x"), (2, None, "y"), (3, "a", "z"), (20, None, "w")]
    at, things, sizes = marks.groups(0, 10)
    groups = np.split(things, np.cumsum(sizes)[:-1])
    told = dict(zip(at.tolist(), [sorted(g.tolist()) for g in groups], strict=True))
    assert told == {1: ["x"], 2: ["x", "y"], 3: ["y", "z"], 7: ["z"], 8: []}
    assert [thing for _, _, thing in marks.left(10).items] == ["w"]


def test_only_parallel_households_are_recorded(tmp_path):
    with pytest.raises(HouseholdError, match="parallel households"):
        RecordEpisodes(household_v0.env(), tmp_path)


def test_a_turn_based_household_is_recorded_below_its_turns(tmp_path):
    home = household_v0.parallel_env(max_cycles=5)
    env = parallel_to_aec(RecordEpisodes(home, tmp_path))
    env.reset(seed=1)
    for agent in env.agent_iter():
        env.step(None if env.truncations[agent] else 1)
    assert len(read_replay(tmp_path / "episode_00000.rrd", tried=True)) == 6


def test_each_episode_gets_a_file_of_its_own(tmp_path):
    env = RecordEpisodes(household_v0.parallel_env(max_cycles=5), tmp_path / "new")
    for _ in range(2):
        env.reset()
        while env.agents:
            env.step(dict.fromkeys(env.agents, 0))
    env.reset()
    env.step(dict.fromkeys(env.agents, 1))
    env.close()
    paths = sorted((tmp_path / "new").iterdir())
    assert [path.name for path in paths] == [f"episode_{k:05d}.rrd" for k in range(3)]
    assert [len(read_replay(path, tried=True)) for path in paths] == [6, 6, 2]


def test_what_was_written_survives_a_kill(tmp_path):
    script = f"""
        import os, signal
        from household import household_v0
        from household.replay import RecordEpisodes
        home = household_v0.parallel_env()
        env = RecordEpisodes(home, {str(tmp_path)!r}, flush_every=50)
        env.reset(seed=1)
        for _ in range(120):
            env.step(dict.fromkeys(env.agents, 1))
        env.wait()
        os.kill(os.getpid(), signal.SIGKILL)
    """
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(script)], check=False)
    assert done.returncode == -signal.SIGKILL
    replay = read_replay(tmp_path / "episode_00000.rrd", tried=True)
    assert replay.moments.decision.tolist() == list(range(100))


def test_a_file_torn_in_the_middle_is_read_up_to_the_tear(lived, tmp_path):
    moments, _, path = lived
    torn = tmp_path / "torn.rrd"
    torn.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])
    replay = read_replay(torn, tried=True)
    assert 0 < len(replay) < len(moments)
    assert all(equal(a, b) for a, b in zip(replay, moments, strict=False))


def test_a_process_that_forgets_to_close_still_writes_everything(tmp_path):
    script = f"""
        from household import household_v0
        from household.replay import RecordEpisodes
        env = RecordEpisodes(household_v0.parallel_env(), {str(tmp_path)!r})
        env.reset(seed=1)
        for _ in range(7):
            env.step(dict.fromkeys(env.agents, 1))
    """
    subprocess.run([sys.executable, "-c", textwrap.dedent(script)], check=True)
    assert len(read_replay(tmp_path / "episode_00000.rrd", tried=True)) == 8


@pytest.mark.parametrize("content", [b"", b"hello", b"x" * 1000])
def test_what_is_no_replay_is_named_in_one_line(tmp_path, content):
    path = tmp_path / "none.rrd"
    path.write_bytes(content)
    with pytest.raises(HouseholdError, match=r"none\.rrd: ") as error:
        read_replay(path, tried=True)
    assert "\n" not in str(error.value)


def test_threads_do_not_pile_up(tmp_path):
    def threads():
        return len(os.listdir("/proc/self/task"))

    def record(k):
        env.reset()
        Recorder(env.simulation, tmp_path / f"{k}.rrd").close()

    env = household_v0.parallel_env(max_cycles=2)
    record(0)
    usual = threads()
    for k in range(1, 6):
        record(k)
    # Rerun's threads end a little after they were told to.
    until = time.monotonic() + 20.0
    while threads() > usual and time.monotonic() < until:
        time.sleep(0.05)
    assert threads() <= usual


def test_importing_the_household_imports_neither_rerun_nor_pygame():
    code = (
        "import sys, household.household_v0, household.replay;"
        "print(sorted({'rerun', 'pygame', 'matplotlib'} & sys.modules.keys()))"
    )
    out = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    )
    assert out.stdout.strip() == "[]"


def test_where_robots_were_is_known_for_a_while_also_after_it_was_written(
    random_actions,
):
    env = household_v0.parallel_env("evening", max_cycles=800)
    env.reset(seed=1)
    n, buffer = len(env.scenario.people), Buffer(env.simulation, 700)
    spots = []
    for decision, actions in zip(range(800), random_actions(env, 0), strict=False):
        buffer.put()
        spots.append(env.simulation.crowd.position[n:].copy())
        if buffer.full or decision % 90 == 89:
            buffer.take()
        for ago in (0, 1, 100, 511, 512):
            if ago <= decision:
                was = decision - ago if ago < REMEMBERED else decision
                found = buffer.spots([1], [decision - ago], [decision])
                assert found.tolist() == [spots[was][1].tolist()]
        env.step(actions)
