"""Findings are stored, and the page shows all of them."""

import json
import math

import pytest

from experiments.docs_tools.validation import page
from experiments.running.engine import open_engine
from experiments.validation import rimea
from experiments.validation.figures import Published, not_modeled
from experiments.validation.results import GROUPS, NOT_MODELED, count, how_many, store
from experiments.validation.scenes import Scene, together, watch

KNOWN = Published(
    name="a figure", unit="s", said="2", low=1.5, high=2.5, source="us", reading="thus"
)


@pytest.fixture
def scene():
    return Scene(name="a scene", watch=_watch, published=(KNOWN,), seeds=4)


def _watch(seed):
    return {"a figure": (1.9, 2.0, 2.1, math.nan)[seed]}


def test_seeds_in_which_there_was_nothing_to_see_are_left_out(scene):
    (found,) = together(scene, [_watch(seed) for seed in range(scene.seeds)])
    assert found.simulated.value == pytest.approx(2.0)
    assert found.simulated.n == 3
    assert found.verdict == "as published"


def test_scenes_are_watched_once_for_each_seed(scene):
    done = []
    (found,) = watch([scene], open_engine("here"), lambda: done.append(1))
    assert (len(done), found.where) == (4, "a scene")


def test_the_page_shows_every_figure_with_its_verdict(scene, tmp_path):
    found = {
        "Some": together(scene, [{"a figure": 9.0}]),
        "Others": [not_modeled(NOT_MODELED["Teachers"][0])],
    }
    text = page(json.loads(store(found, tmp_path).read_text("utf-8")))
    assert "| a figure (s) | 2 | a scene | 9.00 | **off** |" in text
    assert "Of 2 figures 0 are as" in text
    assert f"{NOT_MODELED['Teachers'][0].reading}" in text


def test_scenes_have_names_of_their_own_and_figures_of_their_own():
    scenes = [scene for group in GROUPS.values() for scene in group]
    assert len({scene.name for scene in scenes}) == len(scenes)
    assert how_many() == sum(scene.seeds for scene in scenes)
    for scene in scenes:
        names = [one.name for one in scene.published]
        assert len(set(names)) == len(names)


def test_a_test_of_walking_is_held_against_the_guideline_in_three_frames():
    corridor = rimea.SCENES[:3]
    found = watch(corridor, open_engine("here"), lambda: None)
    assert count(found, "as published") == 3
