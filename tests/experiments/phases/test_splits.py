"""Which people, homes and roles are for the end, and that nobody looks before."""

import ast
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from experiments.errors import ExperimentError
from experiments.phases import splits
from experiments.phases.days import DAYS
from experiments.phases.splits import HASHES, read
from experiments.phases.splitting import (
    UNSEEN,
    best_responses,
    cluster_of,
    lists,
)

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def known():
    return {name: read(name, final=True) for name in HASHES}


def test_the_lists_are_those_that_the_rules_give(known):
    assert lists() == known


def test_there_are_as_many_as_the_protocol_wants(known):
    assert [len(each.people) for each in known.values()] == [64, 16, 32, 16]
    assert [len(each.homes) for each in known.values()] == [24, 6, 12, 6]
    assert [len(each.roles) for each in known.values()] == [63, 10, 32, 63]


def test_no_two_splits_share_anybody_or_any_home_or_any_assignment(known):
    for one, other in combinations(known.values(), 2):
        assert not set(one.people) & set(other.people)
        assert not set(one.homes) & set(other.homes)
        assert not set(one.roles) & set(other.roles)


def test_training_knows_every_day_of_both_people(known):
    for place in (0, 1):
        assert {pair[place] for pair in known["train"].roles} == set(range(len(DAYS)))


def test_what_is_swapped_is_training_turned_round(known):
    turned = {(other, one) for one, other in known["train"].roles}
    assert set(known["out_of_distribution"].roles) == turned


def test_strangers_are_of_a_cluster_that_nobody_else_is_of(known):
    for name, each in known.items():
        outside = [cluster_of(person) == UNSEEN for person in each.people]
        assert all(outside) if name == "out_of_distribution" else not any(outside)


def test_people_of_the_test_differ_more_than_those_of_training(known):
    def nearest(people):
        liked = np.array([best_responses(person) for person in people])
        apart = (liked[:, None] != liked[None]).mean(axis=2)
        np.fill_diagonal(apart, 1.0)
        return apart.min(axis=1).mean()

    assert nearest(known["test"].people) > nearest(known["train"].people[:32]) + 0.05


@pytest.mark.parametrize("split", ["test", "out_of_distribution"])
def test_the_test_is_refused_to_whoever_does_not_say_that_it_is_the_end(split):
    with pytest.raises(ExperimentError, match="final evaluation alone"):
        read(split)


def says_that_it_is_the_end(call):
    """Whether a call passes `final`, other than the plain False."""
    values = [each.value for each in call.keywords if each.arg == "final"]
    return any(getattr(value, "value", None) is not False for value in values)


def test_only_the_drawing_of_probed_households_says_that_it_is_the_end():
    asking = set()
    for file in (ROOT / "experiments").rglob("*.py"):
        tree = ast.parse(file.read_text("utf-8"))
        calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
        if any(map(says_that_it_is_the_end, calls)):
            asking.add(file.name)
    assert asking == {"drawing.py"}


def test_nothing_but_splits_reads_the_lists():
    using = {
        file.name
        for file in (ROOT / "experiments").rglob("*.py")
        if re.search(r"LISTS|phases/lists", file.read_text("utf-8"))
    }
    assert using == {"splits.py", "splitting.py"}  # the second one writes them


def test_a_list_that_was_changed_is_not_read(tmp_path, monkeypatch):
    (tmp_path / "train.json").write_text('{"people": [1], "homes": [], "roles": []}')
    monkeypatch.setattr(splits, "LISTS", tmp_path)
    splits._read.cache_clear()
    with pytest.raises(ExperimentError, match="hash is another"):
        read("train")
    splits._read.cache_clear()


def test_an_unknown_split_names_the_nearest():
    with pytest.raises(ExperimentError, match="validation"):
        read("validatoin")
