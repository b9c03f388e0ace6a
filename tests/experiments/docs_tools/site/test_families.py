"""Pages of families: households as they are drawn, scores as they are stored."""

from pathlib import Path

import pytest

from experiments.docs_tools.site.families import polite, write_families
from household.scenario.family import draw, load_family

SUITE = Path(__file__).parents[4] / "docs" / "suite.md"


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """The page of the family `phone`, with its scores made known."""
    folder = tmp_path_factory.mktemp("site")
    (folder / "suite.md").write_text(SUITE.read_text("utf-8"), "utf-8")
    write_families(folder)
    return (folder / "families" / "phone.md").read_text("utf-8")


def test_a_page_names_the_people_whom_the_seeds_draw(page):
    for person in draw("phone", 2).people:
        assert f"{person.name.split('_')[0]} ({person.persona})" in page


def test_a_page_has_the_scores_of_its_family_alone(page):
    stored = SUITE.read_text("utf-8").partition("| phone | random |")[2]
    best_constant = stored.splitlines()[1].removeprefix("|  ")
    assert best_constant.startswith("| always ")
    assert best_constant in page
    assert page.count("| lookahead |") == 1


def test_what_is_most_polite_follows_the_norms():
    found = {activity: best for activity, *best in polite(load_family("phone"))}
    assert found["calling"] == ["sleep", "retreat"]
