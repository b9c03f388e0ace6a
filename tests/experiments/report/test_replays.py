"""The typical trial is recorded and shown once, by one version of Rerun."""

import pytest

from experiments.report import replays
from experiments.report.replays import play
from household.replay import rendering, web_viewer
from household.replay.reading import read_replay
from household.replay.web_viewer import recorded_by


@pytest.fixture(scope="module")
def out(tmp_path_factory):
    """A directory of results, with the replay of a trial that was typical once."""
    out = tmp_path_factory.mktemp("out")
    (out / "replays").mkdir()
    (out / "replays" / "experiment_1_seed_9.html").write_text("typical no more")
    return out


@pytest.fixture(autouse=True)
def no_films(monkeypatch):
    """Films take long, and the extra for them may be missing."""
    monkeypatch.setattr(rendering, "can_film", lambda: False)


def test_a_typical_trial_is_a_recording_a_page_and_a_picture(out):
    played = play(1, 2, out)
    assert len(read_replay(played.recording)) > 1000
    assert "Experiment 1: Standard Q-learning, seed 2" in played.page.read_text()
    assert played.picture.read_text().startswith("<?xml")
    assert played.film is None
    names = {path.name for path in (out / "replays").iterdir()}
    stem = "experiment_1_seed_2"
    viewer = f"viewer_{recorded_by(played.recording)}"
    assert names == {f"{stem}{kind}" for kind in (".rrd", ".html", ".svg")} | {viewer}


def test_what_is_there_is_not_made_again(out, monkeypatch):
    before = play(1, 2, out)
    monkeypatch.setattr(replays, "record", None)
    times = {path: path.stat().st_mtime_ns for path in (out / "replays").iterdir()}
    assert play(1, 2, out) == before
    now = {path: path.stat().st_mtime_ns for path in (out / "replays").iterdir()}
    assert now == times


def test_a_recording_of_another_version_is_made_anew(out, monkeypatch):
    made = []
    monkeypatch.setattr(web_viewer, "viewer_version", lambda: "0.1.0")
    monkeypatch.setattr(replays, "record", lambda trial, path: made.append(path))
    monkeypatch.setattr(web_viewer, "start_viewer", None)
    (out / "replays" / "viewer_0.1.0").mkdir()
    played = play(1, 2, out)
    assert made == [played.recording]
    assert "viewer_0.1.0/" in played.page.read_text()
