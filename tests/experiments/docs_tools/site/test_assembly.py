"""The pages of the site: all in one folder, each in the navigation, links kept."""

import re
from pathlib import Path

import pytest

from experiments.docs_tools.site.assembly import assemble, navigation
from household.config.toml import shipped

ROOT = Path(__file__).parents[4]


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The real site, before Sphinx builds it."""
    folder = tmp_path_factory.mktemp("site")
    assemble(ROOT, folder)
    return folder


@pytest.fixture
def project(tmp_path):
    """A small project with pages in folders, of which one shows a program."""
    texts = {
        "README.md": "# Project\n",
        "examples/draw.py": "print('```')\n",
        "docs/index.md": "# First\n",
        "docs/suite.md": (ROOT / "docs" / "suite.md").read_text("utf-8"),
        "docs/new/page.md": "# New\n[a](../../README.md) [b](../../examples/draw.py)\n",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, "utf-8")
    return tmp_path


def test_every_hand_written_page_is_in_the_navigation_once(site):
    index = (site / "index.md").read_text("utf-8")
    for page in (ROOT / "docs").rglob("*.md"):
        name = page.relative_to(ROOT / "docs").with_suffix("").as_posix()
        times = len(re.findall(rf"^{name}$", index, re.MULTILINE))
        assert times == (name != "index"), name


@pytest.mark.parametrize(
    ("folder", "kind"), [("families", "family"), ("homes", "home")]
)
def test_whatever_is_shipped_has_a_page_with_its_picture(site, folder, kind):
    for name in shipped(kind):
        page = (site / folder / f"{name}.md").read_text("utf-8")
        (picture,) = re.findall(r"!\[.*\]\((.*)\)", page)
        assert (site / folder / picture).exists()


def test_links_out_of_the_folder_of_pages_lead_to_pages_of_the_site(project):
    assemble(project, project / "site")
    page = (project / "site" / "new" / "page.md").read_text("utf-8")
    assert page == "# New\n[a](../index.md) [b](../files/examples/draw.md)\n"
    shown = (project / "site" / "files" / "examples" / "draw.md").read_text("utf-8")
    assert "print('```')\n" in shown


def test_a_page_that_nobody_named_is_in_the_navigation(project):
    found = navigation([Path("index"), Path("new/page"), Path("environment")])
    assert ":caption: More\n\nnew/page\n" in found
    assert ":caption: The simulation\n\nenvironment\n" in found
