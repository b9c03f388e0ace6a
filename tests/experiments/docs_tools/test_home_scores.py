"""Reference scores on the pages of homes: stored as the code computes them."""

import json
import math
from pathlib import Path

import pytest

from experiments.docs_tools.home_scores import SEEDS, rows, scored
from household.config.toml import shipped

STORED = json.loads(
    (Path(__file__).parents[3] / "docs" / "scores" / "scenarios.json").read_text()
)


def test_scores_are_stored_for_each_scenario_and_seed():
    assert set(STORED) == set(shipped("scenario"))
    assert {len(of_seeds) for of_seeds in STORED.values()} == {len(SEEDS)}


@pytest.mark.parametrize("scenario", ["experiment_3", "home_office"])
def test_stored_scores_are_those_that_are_computed(scenario):
    found, stored = scored(scenario, SEEDS[1]), STORED[scenario][1]
    for measure in ("probe", "per_minute"):
        assert found[measure] == pytest.approx(stored[measure])


def in_one_seed(probe, per_minute):
    names = ("random", "constant:a", "constant:b", "population", "persona", "lookahead")
    return {
        "probe": dict(zip(names, probe, strict=True)),
        "per_minute": dict(zip(names, per_minute, strict=True)),
    }


def test_the_best_constant_is_the_one_of_the_best_probe_score_over_seeds():
    one = in_one_seed([0, 0.9, 0.5, 1, 1, None], [0, 1, 2, 3, 4, 4])
    other = in_one_seed([0, 0.1, 0.7, 1, 1, None], [0, 1, 2, 3, 4, 4])
    found = {row.policy: row for row in rows([one, other])}
    assert list(found) == ["random", "always b", "population", "persona", "lookahead"]
    assert found["always b"].probe.value == pytest.approx(0.6)
    assert found["lookahead"].probe is None
    assert [row.lived for row in found.values()] == [0, 0.5, 0.75, 1, 1]


def test_where_nothing_makes_a_difference_the_best_lived_constant_stands():
    seed = in_one_seed([None] * 6, [1.0, 1.0, 2.0, 1.0, 1.0, 1.0])
    found = list(rows([seed]))
    assert found[1].policy == "always b"
    assert all(row.probe is None and math.isnan(row.lived) for row in found)
