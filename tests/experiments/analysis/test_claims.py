import numpy as np
import polars as pl
import pytest

from experiments.analysis.claims import Claim, overall, verdicts
from experiments.analysis.measures import StudyMeasure
from experiments.analysis.statistics import mean
from experiments.running.files import to_json


def given(values, label):
    return StudyMeasure(
        label=label,
        conditions=(label,),
        values=lambda frame: np.asarray(values, dtype=float),
    )


def claim(values, rule="at least", threshold=0.5, **others):
    return Claim(
        id="9z",
        text="It works.",
        reading="share of the seeds in which it works",
        measure=given(values, "a"),
        rule=rule,
        threshold=threshold,
        **others,
    )


NOTHING = pl.DataFrame()


@pytest.mark.parametrize(
    ("values", "rule", "holds"),
    [
        ([1, 1, 0, 0], "at least", True),
        ([1, 0, 0, 0], "at least", False),
        ([1, 1, 0, 0], "at most", True),
        ([1, 1, 1, 0], "at most", False),
    ],
)
def test_the_point_value_decides(values, rule, holds):
    assert claim(values, rule).check(NOTHING).holds is holds


def test_above_needs_the_whole_interval():
    wide, narrow = [0.0, 2.0, 0.1, 1.9], [1.0, 1.1, 0.9, 1.0]
    assert not claim(wide, "above", 0.5, estimate=mean).check(NOTHING).holds
    assert claim(narrow, "above", 0.5, estimate=mean).check(NOTHING).holds


def test_no_better_than_holds_if_the_interval_covers_nothing_or_the_gain_is_small():
    def holds(values):
        found = claim(values, "no better than", 0.1, estimate=mean).check(NOTHING)
        return found.holds

    assert holds([-1.0, 1.0, 0.9, -0.4])
    assert holds([0.05, 0.06, 0.05, 0.04])
    assert not holds([0.5, 0.6, 0.5, 0.4])


def test_without_data_no_claim_holds():
    for rule in ("at least", "at most", "above", "no better than"):
        assert not claim([], rule, estimate=mean).check(NOTHING).holds


def test_a_claim_from_to_fails_on_either_side():
    def holds(value):
        values = [value, value]
        return claim(values, "at most", 0.5, least=0.3, estimate=mean).check(NOTHING)

    found = {value: holds(value).verdict for value in (0.1, 0.3, 0.4, 0.5, 0.6)}
    assert list(found.values()) == ["fails", "holds", "holds", "holds", "fails"]


def test_an_interval_that_straddles_the_threshold_leaves_it_undecided():
    found = claim([1, 1, 1, 0]).check(NOTHING)
    assert (found.holds, found.verdict) == (True, "undecided")
    assert found.seeds_to_decide > 4
    wide = claim([0.0, 2.0, 0.1, 1.9], "above", 0.5, estimate=mean).check(NOTHING)
    assert (wide.holds, wide.verdict) == (False, "undecided")


def test_no_better_than_is_decided_where_the_interval_covers_nothing():
    found = claim([-1.0, 1.0, 0.9, -0.4], "no better than", 0.1, estimate=mean)
    assert found.check(NOTHING).verdict == "holds"


def test_what_random_and_persona_reach_says_whether_a_claim_says_anything():
    def standing(floor, ceiling):
        reached = {"random": [floor], "persona": [ceiling]}
        asked = claim([1, 1], reference=lambda n: given(reached[n], n), estimate=mean)
        return asked.check(NOTHING).standing

    assert standing(0.1, 0.9) is None
    assert standing(0.6, 0.9) == "empty"
    assert standing(0.1, 0.4) == "unattainable"
    assert claim([1, 1]).check(NOTHING).standing is None


def test_the_verdict_on_a_claim_is_its_worst_ones():
    held, lost, open_ = (claim(v).check(NOTHING) for v in ([1] * 9, [0] * 9, [1, 0]))
    assert overall([held]) == {"9z": "holds"}
    assert overall([open_, held]) == {"9z": "undecided"}
    assert overall([lost, open_, held]) == {"9z": "fails"}


def test_what_is_written_down_says_all_that_the_verdict_rests_on():
    plain = claim([1, 1, 1, 0]).check(NOTHING).plain()
    assert plain["value"] == 0.75
    assert plain["low"] < 0.75 < plain["high"]
    assert {"id", "text", "threshold", "holds", "rule", "n", "interval"} <= set(plain)


def test_an_interval_that_is_not_known_is_written_as_null():
    plain = claim([1.0]).check(NOTHING).plain()
    assert '"low": null' in to_json(plain)


def test_a_claim_holds_if_it_holds_in_all_its_conditions():
    good, bad = claim([1, 1]).check(NOTHING), claim([0, 0]).check(NOTHING)
    assert verdicts([good, good]) == {"9z": True}
    assert verdicts([good, bad]) == {"9z": False}
    assert verdicts([bad, good]) == {"9z": False}
