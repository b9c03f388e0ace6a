import re
from pathlib import Path

import pytest

from learners import CATALOG

PAGE = Path(__file__).parents[2] / "docs" / "learners.md"


@pytest.fixture
def page():
    return PAGE.read_text("utf-8")


def test_the_examples_of_the_page_run(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert len(blocks) == 2
    exec("\n".join(blocks), {"__name__": "learners_page"})


@pytest.mark.parametrize("name", CATALOG)
def test_the_page_lists_every_learner_with_its_summary(page, name):
    assert f"| `{name}` | " in page
    assert CATALOG[name].summary in page
