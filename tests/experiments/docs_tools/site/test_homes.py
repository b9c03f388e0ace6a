"""Pages of homes: their spaces, and who lives there."""

import shutil
from pathlib import Path

import pytest

from experiments.docs_tools.site.homes import write_homes
from household.config.toml import shipped
from household.home.floorplan import load_floorplan

SCORES = Path(__file__).parents[4] / "docs" / "scores"


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The folder with the pages."""
    folder = tmp_path_factory.mktemp("site")
    shutil.copytree(SCORES, folder / "scores")
    write_homes(folder)
    return folder / "homes"


def test_a_page_lists_every_room_and_place(pages):
    text = (pages / "studio.md").read_text("utf-8")
    plan = load_floorplan("studio")
    for space in (*plan.rooms, *plan.regions):
        assert f"| {space.name} |" in text
    assert "7.0 m x 4.6 m" in text


def test_a_page_says_who_lives_there_in_which_scenario(pages):
    text = (pages / "family_apartment.md").read_text("utf-8")
    assert "### evening" in text
    for name in ("mother", "father", "son", "daughter"):
        assert f"| {name} |" in text


def test_every_home_has_the_reference_scores_of_its_scenarios(pages):
    for home in shipped("home"):
        text = (pages / f"{home}.md").read_text("utf-8")
        scenarios = text.count("\n### ")
        assert scenarios > 0
        for policy in ("random", "always ", "population", "persona", "lookahead"):
            assert text.count(f"\n| {policy}") == scenarios, (home, policy)


def test_where_no_scores_are_stored_the_page_tells_how_to_make_them(tmp_path):
    write_homes(tmp_path)
    text = (tmp_path / "homes" / "studio.md").read_text("utf-8")
    assert "docs_tools.home_scores docs/scores/scenarios.json home_office`" in text
