from pathlib import Path

import pytest

from learners import CATALOG

PAGE = Path(__file__).parents[2] / "docs" / "learners.md"


@pytest.fixture(scope="module")
def page():
    return PAGE.read_text("utf-8")


@pytest.mark.parametrize("name", CATALOG)
def test_the_page_lists_every_learner_with_its_summary(page, name):
    assert f"| `{name}` | " in page
    assert CATALOG[name].summary in page
