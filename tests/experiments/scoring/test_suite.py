"""The admission rule refuses what is not worth learning in, and says why."""

import msgspec
import numpy as np
import pytest
import tomli_w

from experiments.analysis.statistics import mean
from experiments.running.engine import open_engine
from experiments.scoring.moments import probe_set
from experiments.scoring.scores import probe_score
from experiments.scoring.suite import (
    Admission,
    check_suite,
    demand,
    duplicates,
    table_choices,
)
from household import household_v0
from household.scenario.family import Draw, draw, load_family


def admitted(**changes):
    usual = {
        "family": "play",
        "demand": "Play",
        "best_constant": "ask",
        "constant": mean([0.3, 0.4]),
        "table": mean([0.95, 0.97]),
        "share": mean([0.6, 0.7]),
        "touches": mean([2.0, 3.0]),
    }
    return Admission(**(usual | changes))


def test_a_family_that_meets_the_rule_has_no_faults():
    assert admitted().faults == ()


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"constant": mean([0.6, 0.7])}, "constant ask scores 0.65"),
        ({"table": mean([0.8, 0.7])}, "the richest table scores 0.75"),
        ({"touches": mean([0.1, 0.3])}, "0.20 touches a minute"),
        ({"like": "party"}, "the same households as party"),
    ],
)
def test_what_breaks_the_rule_is_said_with_its_figure(changes, says):
    (fault,) = admitted(**changes).faults
    assert says in fault


def test_a_family_that_differs_in_words_alone_is_a_duplicate():
    play = load_family("play")
    copy = msgspec.structs.replace(play, name="games", demand="Join in")
    assert duplicates([play, load_family("party"), copy]) == {"games": "play"}


def test_the_fitted_table_is_better_than_every_constant_behavior():
    env = household_v0.parallel_env(draw("phone", Draw(seed=2, n_people=2)))
    fitted, tested = probe_set(env, [1, 2, 3], 600), probe_set(env, [4], 600)
    table = probe_score(table_choices(fitted, tested), tested.moments)
    constants = [
        probe_score([behavior] * len(tested.moments), tested.moments)
        for behavior in range(len(env.behaviors))
    ]
    assert table > max(constants)


def test_what_a_household_demands_depends_on_family_and_seed_alone():
    one, again = demand(("elder_care", 3)), demand(("elder_care", 3))
    assert one == again
    assert np.isfinite([one.table, *one.constants.values()]).all()


def test_a_family_that_everybody_solves_by_one_behavior_is_refused(tmp_path):
    family = msgspec.to_builtins(load_family("play"))
    for norm in family["norms"].values():
        for part in ("attending", "absorbed"):
            norm[part] = dict.fromkeys(family["behaviors"], -0.5) | {"ask": 0.8}
    family["name"] = "one_rule"
    path = tmp_path / "one_rule.toml"
    path.write_text(tomli_w.dumps(strip_none(family)), encoding="utf-8")
    (found,) = check_suite([str(path)], 2, open_engine("local", 1), lambda: None)
    assert found.best_constant == "ask"
    assert any("constant ask" in fault for fault in found.faults)


def strip_none(data):
    """TOML knows no None."""
    if isinstance(data, dict):
        return {key: strip_none(each) for key, each in data.items() if each is not None}
    if isinstance(data, (list, tuple)):
        return [strip_none(each) for each in data]
    return data
