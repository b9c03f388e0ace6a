"""What the real viewer says of a replay; it needs a graphics driver, not a screen."""

from pathlib import Path

import numpy as np
import pytest

from household.errors import HouseholdError
from household.replay import RecordEpisodes
from household.replay.process import address, free_ports, start_viewer
from household.replay.reading import read_replay
from household.replay.serving import moment_of, served
from household.replay.viewer import choose, recordings, view

DRIVERS = tuple(Path("/usr/share/vulkan/icd.d").glob("lvp_icd*.json"))
"""Of the software rasterizer; Debian's package mesa-vulkan-drivers brings it."""

needs_driver = pytest.mark.skipif(not DRIVERS, reason="no mesa-vulkan-drivers")

VIEWS = {
    "Activities and behaviors",
    "Attention: row looks at column",
    "Credit: believed above, true below",
    "Events: click on a time",
    "Moods (private)",
    "Situation",
    "Sum of touches",
    "Touches",
    "busy: two_room_flat",
}


@pytest.fixture
def viewer(monkeypatch, tmp_path, until):
    """A viewer without a screen."""
    from rerun.experimental import ViewerClient

    monkeypatch.setenv("VK_ICD_FILENAMES", str(DRIVERS[0]))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    (port,) = free_ports(1)

    def connected():
        clients.append(ViewerClient.connect(address(port)))
        return clients[-1].get_state() is not None

    clients = []
    process = start_viewer("--headless", f"--port={port}", "--window-size=1280x720")
    try:
        until(connected)
        yield clients[-1], address(port), process
    finally:
        process.kill()
        process.wait(20)


def play(env, decisions):
    """Plays the beginning of an episode."""
    env.reset(seed=3)
    rng = np.random.default_rng(0)
    for _ in range(decisions):
        env.step({a: int(rng.integers(len(env.behaviors))) for a in env.agents})


def moment(state):
    return state.recordings[0].current_time


def complaints(state):
    return [(v.name, r.severity, r.summary) for v in state.views for r in v.reports]


@needs_driver
def test_the_viewer_shows_every_view_without_a_complaint(
    viewer, busy_home, tmp_path, until
):
    client, _, _ = viewer
    env = RecordEpisodes(busy_home, tmp_path)
    play(env, 40)
    env.close()
    client.open(str(tmp_path / "episode_00000.rrd"))
    until(lambda: client.get_state().active_recording and client.get_state().views)
    client.set_time("decision", sequence=30, play_state="paused")
    until(lambda: not client.get_state().loading)
    client.take_screenshot(None)
    state = client.get_state()
    assert {view.name for view in state.views} == VIEWS
    assert complaints(state) == []


@needs_driver
def test_a_link_opens_a_replay_at_its_moment(viewer, busy_home, tmp_path, until):
    client, _, _ = viewer
    env = RecordEpisodes(busy_home, tmp_path)
    play(env, 40)
    env.close()
    with served(tmp_path / "episode_00000.rrd") as replay:
        client.open(replay + moment_of(30))
        until(lambda: {v.name for v in client.get_state().views} == VIEWS)
        until(lambda: moment(client.get_state()) == 30)
        client.set_time("decision", sequence=11, play_state="paused")
        until(lambda: moment(client.get_state()) == 11)
        assert complaints(client.get_state()) == []


@needs_driver
def test_an_episode_can_be_watched_while_it_goes_on(viewer, busy_home, tmp_path, until):
    client, url, _ = viewer
    env = RecordEpisodes(busy_home, tmp_path, watch=url, flush_every=10)
    play(env, 40)
    until(lambda: client.get_state().active_recording)
    until(lambda: {v.name for v in client.get_state().views} == VIEWS)
    env.close()


@needs_driver
def test_who_closes_the_viewer_does_not_stop_the_episode(viewer, busy_home, tmp_path):
    _, url, process = viewer
    env = RecordEpisodes(busy_home, tmp_path, watch=url, flush_every=10)
    play(env, 40)
    process.kill()
    process.wait(20)
    for _ in range(40):
        env.step(dict.fromkeys(env.agents, 1))
    env.close()
    assert len(read_replay(tmp_path / "episode_00000.rrd", tried=True)) == 81


def test_replays_are_found_below_a_directory_and_chosen_by_number(tmp_path):
    for name in ("b/two.rrd", "a/one.rrd", "a/table.parquet"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    shown = []
    chosen = choose(tmp_path, ask=lambda _: " 2 ", show=shown.append)
    assert chosen == tmp_path / "b/two.rrd"
    assert [line.split() for line in shown] == [["1", "a/one.rrd"], ["2", "b/two.rrd"]]
    assert choose(tmp_path / "a") == tmp_path / "a/one.rrd"


@pytest.mark.parametrize("answer", ["", "0", "3", "x"])
def test_a_choice_that_is_none_says_what_is_allowed(tmp_path, answer):
    for name in ("one.rrd", "two.rrd"):
        (tmp_path / name).touch()
    with pytest.raises(HouseholdError, match="from 1 to 2"):
        choose(tmp_path, ask=lambda _: answer, show=lambda _: None)


def test_a_place_without_replays_is_an_error(tmp_path):
    with pytest.raises(HouseholdError, match="no replay file"):
        recordings(tmp_path)
    with pytest.raises(HouseholdError, match="no such file"):
        view(tmp_path / "missing.rrd")
