"""Pages of homes: their spaces, and who lives there."""

import pytest

from experiments.docs_tools.site.homes import write_homes
from household.home.floorplan import load_floorplan


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The folder with the pages."""
    folder = tmp_path_factory.mktemp("site")
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
