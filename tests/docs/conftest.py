"""The pages of the documentation, as CommonMark sees them."""

from pathlib import Path

import pytest
from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
PAGES = (ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted(ROOT.glob("docs/**/*.md")))


def pytest_generate_tests(metafunc):
    """A test that asks for a ``page`` runs once for each of them."""
    if "page" in metafunc.fixturenames:
        names = [str(path.relative_to(ROOT)) for path in PAGES]
        metafunc.parametrize("page", PAGES, ids=names, scope="module")


@pytest.fixture(scope="session")
def root():
    """The folder of the project."""
    return ROOT


@pytest.fixture(scope="session")
def tokens():
    """Returns a function that lists what a page is made of, inline parts included."""
    parser = MarkdownIt("commonmark").enable("table")

    def read(page: Path):
        blocks = parser.parse(page.read_text("utf-8"))
        return [part for block in blocks for part in (block, *(block.children or ()))]

    return read
