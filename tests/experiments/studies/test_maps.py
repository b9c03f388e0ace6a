"""Maps vary two constants of an experiment and nothing else."""

import numpy as np
import polars as pl
import pytest

from experiments.running.study import Trial
from experiments.running.trial import describe_condition
from experiments.studies import varying
from experiments.studies.maps import MAPS, as_text, run_cell


@pytest.fixture(params=MAPS.values(), ids=MAPS.keys())
def mapped(request):
    return request.param


def plain(condition):
    return describe_condition(condition) | {"factors": None}


def test_where_the_experiment_lies_its_condition_is_its_own(mapped):
    usual = plain(mapped.condition(mapped.usual))
    base = plain(mapped.base)
    # Personas and looks are written out where the scenario names them.
    for one in (usual, base):
        del one["scenario"]
    assert usual == base


def test_cells_differ_in_what_the_axes_vary(mapped):
    x, y = mapped.cells[0], mapped.cells[-1]
    assert x[0] != y[0]
    assert x[1] != y[1]
    assert plain(mapped.condition(x)) != plain(mapped.condition(y))
    names = [condition.name for condition in mapped.study((0,)).conditions]
    assert len(set(names)) == len(mapped.cells) == len(names)


def test_a_cell_keeps_one_number_for_each_claim(mapped):
    trial = Trial(condition=mapped.condition(mapped.usual), seed=0)
    (row,) = run_cell(trial, mapped.name).to_dicts()
    assert tuple(row) == mapped.ids
    assert all(0.0 <= value <= 1.0 for value in row.values())


def test_claims_are_judged_cell_by_cell():
    mapped = MAPS["attention"]
    first, last = mapped.cells[0], mapped.cells[-1]
    rows = [
        {"condition": mapped.condition(levels).name, "seed": seed, "1a": a, "1b": 1 - a}
        for levels in mapped.cells
        for seed in range(20)
        for a in (0.0 if levels == first else 1.0 if levels == last else seed % 2,)
    ]
    found = mapped.findings(pl.DataFrame(rows, strict=False))
    assert found["1a", first].verdict == found["1b", first].verdict == "holds"
    assert found["1a", last].verdict == found["1b", last].verdict == "fails"
    assert found["1a", mapped.usual].estimate.value == 0.5


@pytest.mark.parametrize("share", [0.15, 1 / 3, 0.75])
def test_attention_takes_the_share_of_the_time_that_it_is_to_take(share):
    changed = varying.attention(MAPS["attention"].base, share)
    (person,) = changed.scenario_overrides["people"]
    for stage in person["script"]:
        looks, away = np.mean(stage["look_for"]), np.mean(stage["look_away"])
        assert looks == 10.0
        assert looks / (looks + away) == pytest.approx(share)


def test_who_never_watched_watches_as_long_as_the_others_at_a_stretch():
    changed = varying.watching(MAPS["watching"].base, 0.6)
    for person in changed.scenario_overrides["people"]:
        assert {stage["look_at"] for stage in person["script"]} == {"robot_0"}
        reading = [
            np.mean(stage["look_away"])
            for stage in person["script"]
            if stage["look_away"] != [10.0, 30.0]
        ]
        assert reading == [pytest.approx(10.0 * 0.4 / 0.6)]


def test_levels_are_written_in_two_digits():
    assert list(map(as_text, (0.0, 1 / 3, 0.5, 2.0))) == ["0", "0.33", "0.5", "2"]
