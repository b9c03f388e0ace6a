"""Films: their pace, and what their frames show."""

import numpy as np
import pytest

from household.simulation.snapshot import snapshot
from household.view.film import FilmPainter, pace_of


@pytest.mark.parametrize(
    ("lasts", "film"), [(5, 20.0), (40, 40.0), (900, 60.0), (20_000, 60.0)]
)
def test_a_film_lasts_as_the_episode_but_20_to_60_seconds(lasts, film):
    pace = pace_of(lasts, 1.0)
    assert len(range(0, lasts, pace.every)) / pace.fps == pytest.approx(film, rel=0.02)
    assert pace.fps <= 30.0


def test_a_speed_of_ones_own_is_kept_and_moments_are_left_out_where_it_is_fast():
    assert pace_of(900, 1.0, speed=8.0) == (pace_of(900, 1.0, 8.0))
    assert (pace_of(900, 1.0, 8.0).fps, pace_of(900, 1.0, 8.0).every) == (8.0, 1)
    fast = pace_of(900, 0.5, 60.0)
    assert fast.every == 4
    assert fast.fps * fast.every * 0.5 == pytest.approx(60.0)


@pytest.fixture
def moments(make_busy_home, monkeypatch):
    """Two minutes of a busy home, moment by moment."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    env = make_busy_home()
    env.reset(seed=3)
    found = [snapshot(env.simulation)]
    for _ in range(60):
        env.step(dict.fromkeys(env.agents, 0))
        found.append(snapshot(env.simulation))
    return env.scenario, found


def test_frames_have_the_size_asked_for_and_one_moment_in_several_is_shown(moments):
    scenario, found = moments
    frames = list(FilmPainter(scenario, (800, 450)).frames(found, every=7))
    assert len(frames) == 9
    assert {frame.shape for frame in frames} == {(450, 800, 3)}


def test_a_touch_is_told_in_words_from_its_moment_on(moments):
    """Also where the moment itself is left out."""
    scenario, found = moments
    first = next(k for k, moment in enumerate(found) if moment.touches)
    assert first > 0
    painter = FilmPainter(scenario, (800, 450))
    frames = list(painter.frames(found[: first + 1]))
    # A line of 15 pixels is left blank, everybody has one, and half of one follows.
    begin = round(15 * (2 + len(scenario.people) + len(scenario.robots)))
    words = [_is_written_on(frame[begin:, 645:]) for frame in frames]
    assert not any(words[:-1])
    assert words[-1]


def _is_written_on(paper):
    return bool((np.abs(paper.astype(int) - 255).sum(2) > 60).any())
