"""Each example of what users write has a page, which shows it as it is."""

import re

import pytest

LIBRARIES = {"ppo", "rllib_ppo", "stable_baselines3_ppo", "torchrl_ppo"}
"""Those that docs/libraries.md is about."""


@pytest.fixture(scope="session")
def examples(root):
    return {path.stem: path.read_text("utf-8") for path in root.glob("examples/*.py")}


@pytest.fixture
def shown(root):
    """The code of each page."""
    pages = {p.stem: p.read_text("utf-8") for p in root.glob("docs/examples/*.md")}
    return {
        name: "".join(re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S))
        for name, text in pages.items()
    }


def test_pages_show_the_examples_as_they_are(examples, shown):
    assert shown.pop("index") == ""
    own = {name: code for name, code in examples.items() if name not in LIBRARIES}
    assert shown == own


def test_examples_are_short(examples):
    lengths = {name: len(code.splitlines()) for name, code in examples.items()}
    most = {name: 80 if name in LIBRARIES else 60 for name in examples}
    assert {n: lines for n, lines in lengths.items() if lines >= most[n]} == {}


def test_the_page_on_libraries_names_every_example(root):
    page = (root / "docs" / "libraries.md").read_text("utf-8")
    assert [name for name in LIBRARIES if f"examples/{name}.py" not in page] == []
