"""Replays as pictures and films, without a viewer."""

import sys

import numpy as np
import pytest
from imageio_ffmpeg import count_frames_and_secs
from matplotlib.image import imread

from household.errors import HouseholdError
from household.replay import RecordEpisodes
from household.replay.rendering import write_film, write_picture
from household.simulation.snapshot import snapshot
from household.view import figure


@pytest.fixture(autouse=True)
def no_screen(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")


@pytest.fixture(scope="module")
def recorded(make_busy_home, tmp_path_factory):
    """A short episode: its scenario, its moments and its file."""
    folder = tmp_path_factory.mktemp("recorded")
    env = RecordEpisodes(make_busy_home(), folder)
    env.reset(seed=3)
    moments = [snapshot(env.unwrapped.simulation)]
    for _ in range(12):
        env.step(dict.fromkeys(env.agents, 0))
        moments.append(snapshot(env.unwrapped.simulation))
    env.close()
    return env.unwrapped.scenario, moments, folder / "episode_00000.rrd"


def test_a_picture_of_a_replay_is_the_picture_of_the_episode(recorded, tmp_path):
    scenario, moments, path = recorded
    files = tmp_path / "replay.png", tmp_path / "episode.png"
    for at, shown in ((None, moments[-4:]), (7, moments[4:8])):
        write_picture(path, files[0], at, (640, 480))
        figure.save(scenario, shown, files[1], (640, 480))
        assert (imread(files[0]) == imread(files[1])).all()


def test_a_moment_that_is_not_in_the_replay_is_an_error(recorded, tmp_path):
    with pytest.raises(HouseholdError, match="no decision 13; allowed: 0 to 12"):
        write_picture(recorded[2], tmp_path / "none.png", at=13)


def test_a_film_goes_as_fast_as_it_is_told(recorded, tmp_path):
    out = tmp_path / "film.mp4"
    write_film(recorded[2], out, (320, 240), speed=4.0)
    assert count_frames_and_secs(str(out)) == (13, 3.25)


def test_a_gif_has_a_frame_for_each_moment_that_it_has_time_for(recorded, tmp_path):
    from PIL import Image

    out = tmp_path / "film.gif"
    write_film(recorded[2], out, (320, 240), speed=16.0)
    with Image.open(out) as gif:
        assert gif.size == (320, 240)
        assert gif.n_frames == 7
        assert gif.info["duration"] in {120, 125, 130}
        first = np.asarray(gif.convert("RGB"))
        gif.seek(6)
        assert (np.asarray(gif.convert("RGB")) != first).any()


def test_without_the_extra_a_film_says_what_to_install(recorded, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(HouseholdError, match=r"polite-household\[render\]"):
        write_film(recorded[2], tmp_path / "film.mp4", (320, 240))
