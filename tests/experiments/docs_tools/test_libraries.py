"""The page on training libraries says what is stored of their runs."""

import json

import pytest

from experiments.docs_tools.libraries import EXAMPLES, page, smoothed


@pytest.fixture(scope="module")
def root(request):
    return request.config.rootpath


@pytest.fixture(scope="module")
def documents(root):
    folder = root / "docs" / "libraries"
    return [
        json.loads((folder / f"{name}.json").read_text("utf-8")) for name in EXAMPLES
    ]


def test_the_page_is_what_the_stored_runs_say(root, documents):
    assert page(documents) == (root / "docs" / "libraries.md").read_text("utf-8")


def test_every_example_learned(documents):
    for one in documents:
        _, rewards = smoothed(one["curve"])
        assert rewards[-1] > rewards[0] + 0.2


def test_a_curve_is_averaged_over_the_last_hours():
    hours, rewards = smoothed([[1.0, 0.0], [2.0, 1.0], [7.5, 5.0]])
    assert hours == [1.0, 2.0, 7.5]
    assert rewards == [0.0, 0.5, 5.0]
