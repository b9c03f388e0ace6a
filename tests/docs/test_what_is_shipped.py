"""Whatever the package ships has its place in the documentation."""

import re

import pytest

from household.config.toml import shipped
from learners.catalog import CATALOG


@pytest.fixture
def read(root):
    """Returns a function that reads a page by its name."""
    return lambda name: (root / "docs" / name).read_text("utf-8")


def test_every_scenario_is_described_with_its_picture(read):
    page = read("scenarios.md")
    for name in shipped("scenario"):
        assert f"**{name}**" in page
        assert f"(pictures/scenario_{name}.png)" in page


def test_every_home_is_described_with_its_picture(read):
    page = read("homes.md")
    for name in shipped("home"):
        assert f"## {name}\n" in page
        assert f"(pictures/home_{name}.svg)" in page


def test_the_table_of_personas_lists_exactly_those_that_are_shipped(read):
    listed = re.findall(r"^\| (\w+) \| \d", read("people.md"), re.MULTILINE)
    assert listed == list(shipped("persona"))


def test_the_readme_shows_results_as_they_are_stored(root, read):
    text = (root / "README.md").read_text("utf-8").replace("**", "")
    glance = text.partition("## Results at a glance")[2].partition("\n## ")[0]
    shown = re.findall(r"-?\d\.\d\d \[-?\d\.\d\d, -?\d\.\d\d\]", glance)
    assert len(shown) >= 8
    stored = read("many_people.md")
    assert [estimate for estimate in shown if estimate not in stored] == []
    (claims, held) = re.findall(r"Of (\d+) claims of the paper (\d+) come out", glance)[
        0
    ]
    assert f"{held} of {claims} claims hold" in read("results.md")


def test_the_readme_says_of_what_carries_over_what_was_found(root, read):
    text = (root / "README.md").read_text("utf-8")
    answer = text.partition("## What carries over")[2].partition("\n## ")[0]
    shown = re.findall(r"\d\.\d\d\s\[\d\.\d\d, \d\.\d\d\]", answer)
    gain, turn, cost = (" ".join(estimate.split()) for estimate in shown)
    stored = read("generalization.md")
    assert (
        f"pooled views within hearing serve strangers. Found: a difference of {gain}"
    ) in stored
    assert (
        "After 20 touches, new people: within hearing, full against within hearing, "
        f"none turns from gain to harm at h = {turn}."
    ) in stored
    assert f"harm after 20 touches. Not found: a difference of {cost}" in stored


def test_tutorials_count_personas_and_learners_as_they_are(read):
    assert "lists nineteen" in read("tutorials/3_your_own_home.md")
    assert len(shipped("persona")) == 19
    assert "some forty more" in read("tutorials/2_learning.md")
    assert 35 < len(CATALOG) - 2 < 45


def test_the_readme_and_the_first_page_count_the_tutorials_as_they_are(root, read):
    tutorials = list(root.glob("docs/tutorials/*.md"))
    assert len(tutorials) == 6
    assert "six, of ten minutes each" in (root / "README.md").read_text("utf-8")
    assert "There are\nsix, of ten minutes each:" in read("index.md")
