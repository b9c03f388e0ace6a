"""The page on training libraries says what is stored of their runs."""

import json

import pytest

from experiments.docs_tools.libraries import EXAMPLES, SEEDS, page, read, smoothed


@pytest.fixture(scope="module")
def root(request):
    return request.config.rootpath


@pytest.fixture(scope="module")
def documents(root):
    return read(root / "docs" / "libraries")


def test_the_page_is_what_the_stored_runs_say(root, documents):
    assert page(documents) == (root / "docs" / "libraries.md").read_text("utf-8")


def test_whatever_is_stored_is_on_the_page(root, documents):
    files = {file.stem for file in (root / "docs" / "libraries").glob("*.json")}
    read_from = {f"{one['example']}_{one['seed']}" for one in documents}
    assert read_from == files
    assert {f"{name}_{SEEDS[0]}" for name in EXAMPLES} <= files


def test_figures_of_an_example_are_means_over_its_seeds(documents):
    (one, *_) = (each for each in documents if each["example"] == "ppo")
    other = json.loads(json.dumps(one)) | {"seed": 9}
    score = other["family"]["scores"]["policy"]["probe_greedy"]
    first, score["value"] = score["value"], score["value"] + 0.5
    others = [each for each in documents if each["example"] != "ppo"]
    text = page([one, other, *others])
    (row,) = (line for line in text.splitlines() if line.startswith("| PPO, one file"))
    assert f"| {first + 0.25:.2f} | {first:.2f}, {first + 0.5:.2f} |" in row


def test_every_example_learned(documents):
    for one in documents:
        _, rewards = smoothed(one["curve"])
        assert rewards[-1] > rewards[0] + 0.2


def test_a_curve_is_averaged_over_the_last_hours():
    hours, rewards = smoothed([[1.0, 0.0], [2.0, 1.0], [7.5, 5.0]])
    assert hours == [1.0, 2.0, 7.5]
    assert rewards == [0.0, 0.5, 5.0]
