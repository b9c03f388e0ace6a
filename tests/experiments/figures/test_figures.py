import re
import xml.etree.ElementTree as ET

import numpy as np
import polars as pl
import pytest

from experiments import figures
from experiments.figures.plots import _sampled, time_share
from experiments.paper import EXPERIMENTS, comparison
from experiments.running.study import Trial
from experiments.running.trial_columns import key_of
from household.perception.situation import Situation


@pytest.fixture
def study(play_trial):
    """Returns the table of experiment 1, three seeds, in the toy home."""
    parts = []
    for condition in EXPERIMENTS[1].conditions:
        for seed in range(3):
            trial = Trial(condition=condition, seed=seed)
            lead = pl.lit(condition.name).alias("condition"), pl.lit(seed).alias("seed")
            parts.append(play_trial(trial).select(*lead, pl.all()))
    return pl.concat(parts)


def test_figure_3_has_the_papers_rows_for_one_seed_and_for_all(study):
    columns = EXPERIMENTS[1].figures[0].columns(study)
    assert [panel.label for panel in columns[0].panels] == [
        "behavior",
        "Q in PLAY",
        "cumulative\nreward",
    ]
    assert columns[0].title.startswith("typical seed")
    assert columns[1].title.startswith("mean of 3 seeds")


def test_the_same_data_gives_the_same_files(study, tmp_path):
    columns = EXPERIMENTS[1].figures[0].columns(study)
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        figures.save(columns, tmp_path / folder / "figure_3")
    for name in ("figure_3.svg", "figure_3.png"):
        one, two = (tmp_path / folder / name for folder in ("one", "two"))
        assert one.read_bytes() == two.read_bytes()
    assert (tmp_path / "one" / "figure_3.png").read_bytes()[:4] == b"\x89PNG"


def test_a_figure_in_a_page_takes_the_pages_colors_and_width(study):
    columns = EXPERIMENTS[1].figures[0].columns(study)
    parts = figures.inline(columns, "figure_3")
    assert len(parts) == 2
    for part in parts:
        ET.fromstring(part)
        assert "var(--ink)" in part
        assert "#1b1f24" not in part
        assert re.search(r'<svg[^>]* width="', part) is None
        assert 'role="img"' in part


def test_ids_of_figures_in_one_page_do_not_clash(study):
    columns = EXPERIMENTS[1].figures[0].columns(study)
    parts = figures.inline(columns, "a") + figures.inline(columns, "b")
    clips = [set(re.findall(r'<clipPath id="([^"]+)"', part)) for part in parts]
    assert sum(len(found) for found in clips) == len(set.union(*clips)) > 0


def test_conditions_are_compared_in_one_figure(study, tmp_path):
    columns = comparison(EXPERIMENTS[1], study)
    assert [panel.label for panel in columns[0].panels] == [
        "cumulative\nreward",
        "caresses\nper minute",
        "taps\nper minute",
    ]
    svg, _ = figures.save(columns, tmp_path / "comparison")
    assert svg.stat().st_size > 1000


def test_a_stepwise_curve_holds_its_value_until_the_next_change():
    times, values = np.array([1.0, 3.0]), np.array([0.5, 0.8])
    found = _sampled(times, values, np.array([0.0, 1.0, 2.9, 3.0, 9.0]))
    assert np.isnan(found[0])
    assert found[1:].tolist() == [0.5, 0.5, 0.8, 0.8]
    assert np.isnan(_sampled(times[:0], values[:0], np.array([1.0]))).all()


def test_the_share_of_time_is_counted_within_each_bin(table):
    # play from 0 to 2 s, bark from 2 to 4 s, play from 4 to 6 s; 20 bins to 40 s
    playing = Situation.of({"ann": "playing"})
    play = (playing, "play", 1.0)
    frame = table([play, (playing, "bark", 1.0), play])
    assert time_share(frame, "behavior", "play", 40.0).tolist() == [
        *(1.0, 0.0, 1.0),
        *[0.0] * 17,
    ]
    assert time_share(frame, "behavior", "play", 80.0)[:2].tolist() == [0.5, 0.5]
    assert time_share(frame, "situation", key_of(playing), 40.0)[:4].tolist() == [
        *(1.0, 1.0, 1.0, 0.0)
    ]
