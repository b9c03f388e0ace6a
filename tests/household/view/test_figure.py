"""Figures of moments: every format and size, with all names, legend and touches."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from household import household_v0
from household.errors import HouseholdError
from household.scenario.family import draw
from household.simulation.snapshot import snapshot
from household.view import figure
from household.view.labels import place_labels


@pytest.fixture
def busy(make_busy_home):
    """A scenario, and its moments up to one with a touch."""
    env = make_busy_home()
    env.reset(seed=3)
    moments = [snapshot(env.simulation)]
    while not moments[-1].touches:
        env.step(dict.fromkeys(env.agents, 0))
        moments.append(snapshot(env.simulation))
    return env.scenario, moments


def texts_of(path):
    root = ElementTree.parse(path).getroot()
    return [each.text for each in root.iter() if each.tag.endswith("}text")]


def test_lines_hold_everybody_by_name_and_what_they_do(busy, tmp_path):
    scenario, moments = busy
    figure.save(scenario, moments, tmp_path / "moment.svg")
    texts = texts_of(tmp_path / "moment.svg")
    # In the home, and in the legend.
    for name in (*scenario.person_names, *scenario.robot_names):
        assert texts.count(name) == 2
    for behavior in moments[-1].behavior:
        assert scenario.behaviors[behavior] in texts
    assert any(f"{moments[-1].time:.0f} s" in text for text in texts)


def test_the_legend_says_what_somebody_does_to_the_right_of_any_name(tmp_path):
    from matplotlib.textpath import TextPath

    env = household_v0.parallel_env(draw("family_evening", 77))
    env.reset(seed=0)
    figure.save(env.scenario, [snapshot(env.simulation)], tmp_path / "moment.svg")
    root = ElementTree.parse(tmp_path / "moment.svg").getroot()
    legend = [t for t in root.iter() if "text-anchor: start" in t.get("style", "")]
    for i, text in enumerate(legend):
        if text.text in env.scenario.person_names:
            name = TextPath((0, 0), text.text, size=figure.NAME)
            end = float(text.get("x")) + name.get_extents().width
            assert float(legend[i + 1].get("x")) > end
    assert len(legend) > 2 * len(env.scenario.person_names)


def test_a_touch_is_drawn_at_its_moment_and_not_before(busy, tmp_path):
    scenario, moments = busy
    kind = moments[-1].touches[-1].feedback.kind
    counts = []
    for shown in (moments, moments[:-1]):
        figure.save(scenario, shown, tmp_path / "moment.svg")
        counts.append(texts_of(tmp_path / "moment.svg").count(kind))
    assert counts == [2, 1]  # The legend has it too.


@pytest.mark.parametrize("size", [(1280, 720), (640, 900), (2400, 800)])
def test_pixels_are_as_many_as_asked_for(busy, tmp_path, size):
    from matplotlib.image import imread

    figure.save(*busy, tmp_path / "moment.png", size)
    picture = imread(tmp_path / "moment.png")
    assert picture.shape[:2] == size[::-1]
    colors = (picture * 255).astype(np.uint8).view(np.uint32)  # red to alpha in one
    assert len(np.unique(colors)) > 50


def test_lines_keep_the_proportions_asked_for(busy, tmp_path):
    figure.save(*busy, tmp_path / "moment.svg", (900, 600))
    head = (tmp_path / "moment.svg").read_text()
    box = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', head)
    width, height = map(float, box.groups())
    assert width / height == pytest.approx(1.5, rel=0.01)


def test_the_same_moment_gives_the_same_file(busy, tmp_path):
    for ending in ("svg", "pdf", "png"):
        files = [tmp_path / f"{k}.{ending}" for k in range(2)]
        for file in files:
            figure.save(*busy, file)
        first, second = (file.read_bytes() for file in files)
        assert first == second
    assert (tmp_path / "0.pdf").read_bytes().startswith(b"%PDF")


def test_names_side_by_side_do_not_cover_each_other():
    names = ["alexandra", "bartholomew", "christina", "robot_0"]
    size = np.array([figure.name_size(name) for name in names])
    position = np.array([[2.0, 2.0], [2.4, 2.0], [2.2, 2.4], [2.2, 1.7]])
    radius = np.array([0.25, 0.25, 0.25, 0.15])
    bounds = np.array([0.0, 0.0, 5.0, 5.0])
    centers = place_labels(position[None], radius, size[None], bounds)[0]
    for i in range(len(names)):
        for j in range(i):
            apart = np.abs(centers[i] - centers[j]) - (size[i] + size[j]) / 2
            assert apart.max() >= 0.0, (names[i], names[j])


def test_longer_names_take_more_room():
    assert figure.name_size("bartholomew")[0] > 2 * figure.name_size("ben")[0]


def test_a_file_that_cannot_be_written_is_one_line(busy, tmp_path):
    with pytest.raises(HouseholdError, match="No such file"):
        figure.save(*busy, tmp_path / "nowhere" / "moment.png")
