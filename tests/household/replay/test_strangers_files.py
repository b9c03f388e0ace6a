"""Replay files from anywhere: read as far as they go, or refused in one line."""

import struct
import subprocess
import sys
from collections import Counter

import numpy as np
import pytest

from household import household_v0
from household.errors import HouseholdError
from household.replay import RecordEpisodes, chunks, probing, query
from household.replay.finding import find
from household.replay.reading import read_replay
from household.replay.rendering import write_film, write_picture
from household.replay.viewer import choose, recordings, view

DECISIONS = 40

LEAST = 20_000
"""The home, who lives there and the first moment take about so much [bytes]."""


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The bytes of a recording, written in four parts."""
    folder = tmp_path_factory.mktemp("whole")
    env = RecordEpisodes(
        household_v0.parallel_env("experiment_5", max_cycles=DECISIONS),
        folder,
        flush_every=10,
    )
    env.reset(seed=1)
    while env.agents:
        env.step(dict.fromkeys(env.agents, 1))
    env.close()
    return (folder / "episode_00000.rrd").read_bytes()


@pytest.fixture
def read(tmp_path):
    """Reads bytes as a replay file; returns moments, or None if it is refused."""
    path = tmp_path / "strange.rrd"

    def read(content):
        path.write_bytes(content)
        try:
            return read_replay(path, tried=True)
        except HouseholdError as error:
            said = str(error)
        assert said.startswith(f"{path}: ")
        assert said.isprintable()
        assert len(said) < len(str(path)) + 500
        return None

    return read


def test_a_file_cut_at_100_bytes_is_refused_in_one_line(whole, read):
    assert read(whole[:100]) is None


@pytest.mark.parametrize("share", [0.25, 0.5, 0.75])
def test_a_file_cut_at_a_quarter_or_half_is_read_to_the_cut(whole, read, share):
    replay = read(whole[: round(len(whole) * share)])
    assert replay is not None
    decisions = replay.moments.decision.tolist()
    assert decisions == list(range(len(decisions)))


def test_wherever_a_file_is_cut_it_is_read_or_refused_and_never_gets_shorter(
    whole, read
):
    lengths = []
    for end in np.linspace(0, len(whole), 60).astype(int).tolist():
        replay = read(whole[:end])
        if end >= LEAST:
            assert replay is not None, end
        lengths.append(0 if replay is None else len(replay))
    assert lengths == sorted(lengths)
    assert lengths[-1] == DECISIONS + 1


def forged(whole, rng):
    """The file with some bytes changed, dropped, doubled or exchanged."""
    data, kind = bytearray(whole), rng.integers(4)
    at = int(rng.integers(len(data)))
    size = int(rng.integers(1, 200))
    if kind == 0:
        data[at : at + size] = rng.bytes(len(data[at : at + size]))
    elif kind == 1:
        del data[at : at + size]
    elif kind == 2:
        data[at:at] = data[at : at + size]
    else:
        for place in rng.integers(len(data), size=5).tolist():
            data[place] ^= 1 << int(rng.integers(8))
    return bytes(data)


READER = """
import sys
from household.errors import HouseholdError
from household.replay.reading import read_replay
for path in sys.argv[1:]:
    try:
        read_replay(path, tried=True)
        print("read", flush=True)
    except HouseholdError as error:
        good = str(error).startswith(path) and str(error).isprintable()
        print("refused" if good else repr(error), flush=True)
"""


def try_all(paths):
    """What came of each: read, refused, or "ended" where Rerun ended its process."""
    came = []
    while len(came) < len(paths):
        command = [sys.executable, "-c", READER, *map(str, paths[len(came) :])]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        came += done.stdout.splitlines()
        if done.returncode != 0:
            assert done.returncode < 0, done.stderr  # no traceback of ours
            came.append("ended")
    return Counter(came)


def write_forged(whole, folder, n):
    rng, paths = np.random.default_rng(7), []
    for i in range(n):
        paths.append(folder / f"forged_{i}.rrd")
        paths[-1].write_bytes(forged(whole, rng))
    return paths


def test_a_forged_file_is_read_or_refused_in_one_line(whole, tmp_path):
    came = try_all(write_forged(whole, tmp_path, 25))
    assert set(came) <= {"read", "refused", "ended"}
    assert came["refused"] > 0


@pytest.mark.slow
def test_many_forged_files_are_read_or_refused_in_one_line(whole, tmp_path):
    came = try_all(write_forged(whole, tmp_path, 1000))
    print(f"\nforged recordings: {dict(came)}")
    assert set(came) <= {"read", "refused", "ended"}
    assert came["refused"] > 100


def test_a_file_that_ends_its_reader_is_refused_in_one_line(tmp_path, monkeypatch):
    """As Rerun's reader does where it panics; it is another process that ends."""
    monkeypatch.setattr(probing, "_READ", "import os; os.abort()")
    with pytest.raises(HouseholdError, match=r"a\.rrd: damaged; Rerun cannot read it"):
        probing.check_readable(tmp_path / "a.rrd")


def test_of_many_files_the_one_that_ends_the_reader_is_named(tmp_path, monkeypatch):
    script = "import os; print('next'); print('next', flush=True); os.abort()"
    monkeypatch.setattr(probing, "_READ", script)
    with pytest.raises(HouseholdError, match=r"b\.rrd: damaged; Rerun cannot read it"):
        probing.check_readable(*(tmp_path / f"{name}.rrd" for name in "abc"))


@pytest.mark.parametrize(
    "show",
    [
        read_replay,
        query.read,
        lambda path: find(path, "tap"),
        view,
        lambda path: write_picture(path, "no.png"),
        lambda path: write_film(path, "no.mp4"),
    ],
)
def test_a_file_is_tried_out_in_another_process_first(tmp_path, show, monkeypatch):
    path = tmp_path / "a.rrd"
    path.write_bytes(b"x" * 1000)
    monkeypatch.setattr(probing, "_READ", "import os; os.abort()")
    with pytest.raises(HouseholdError, match=r"a\.rrd: damaged; Rerun cannot read it"):
        show(path)


def test_a_file_that_was_read_well_is_not_tried_again_until_it_changes(
    whole, tmp_path, monkeypatch
):
    path = tmp_path / "a.rrd"
    path.write_bytes(whole)
    assert len(read_replay(path)) > 0
    monkeypatch.setattr(probing, "_READ", "import os; os.abort()")
    assert len(read_replay(path)) > 0
    path.write_bytes(whole + b"x")
    with pytest.raises(HouseholdError, match="damaged"):
        read_replay(path)


def test_a_message_that_says_it_is_endless_ends_the_file(whole, read):
    head = whole[: chunks.HEADER]
    for length in (2**63, 2**64 - 1, 2**40):
        assert read(head + struct.pack("<QQ", 2, length) + b"x" * 100) is None


def test_a_file_that_is_too_large_is_not_read(whole, read, monkeypatch):
    monkeypatch.setattr(chunks, "LARGEST", 1000)
    assert read(whole) is None


@pytest.mark.parametrize("name", ["a" * 5000, "a\0b", "two\nlines"])
def test_a_name_that_no_file_has_is_refused_in_one_line(tmp_path, name):
    for path in (tmp_path / name, tmp_path / f"{name}.rrd"):
        with pytest.raises(HouseholdError) as caught:
            read_replay(path, tried=True)
        assert str(caught.value).isprintable()
        assert len(str(caught.value)) < 400


def test_where_nobody_can_answer_the_replays_are_listed(tmp_path):
    for name in ("a", "b"):
        (tmp_path / f"{name}.rrd").write_bytes(b"")
    assert len(recordings(tmp_path)) == 2

    def closed(_):
        raise RuntimeError("input(): lost sys.stdin")

    shown = []
    with pytest.raises(HouseholdError, match="holds 2 replays; name one of them"):
        choose(tmp_path, ask=closed, show=shown.append)
    assert len(shown) == 2


@pytest.mark.parametrize("answer", ["9" * 5000, "٢", "0", "-1", "1.0", "", "²"])
def test_an_answer_that_is_no_number_on_the_list_is_refused(tmp_path, answer):
    for name in ("a", "b"):
        (tmp_path / f"{name}.rrd").write_bytes(b"")
    with pytest.raises(HouseholdError, match="a number from 1 to 2"):
        choose(tmp_path, ask=lambda _: answer, show=lambda _: None)
