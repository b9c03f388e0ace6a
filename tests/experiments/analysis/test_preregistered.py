import numpy as np
import polars as pl
import pytest

from experiments.analysis.preregistered import Contrast, results
from experiments.errors import ExperimentError


def frame(gain, n=20):
    """Two learners with the same 20 seeds, 5 groups of people and 4 homes."""
    rng = np.random.default_rng(0)
    rows = []
    for seed in range(n):
        common = rng.normal(0, 0.3)
        for learner, added in (("plain", 0.0), ("better", gain)):
            rows.append(
                {
                    "learner": learner,
                    "seed": seed,
                    "people": f"group {seed % 5}",
                    "home": seed % 4,
                    "greedy": common + added + rng.normal(0, 0.02),
                }
            )
    return pl.DataFrame(rows)


BETTER = Contrast(
    text="Better is better.", more={"learner": "better"}, less={"learner": "plain"}
)
WORSE = Contrast(
    text="Plain is better.", more={"learner": "plain"}, less={"learner": "better"}
)


def test_pairs_share_their_seed_so_a_small_gain_is_seen():
    (found,) = results(frame(0.1), [BETTER])
    assert found.verdict == "as expected"
    assert found.difference.value == pytest.approx(0.1, abs=0.02)
    assert found.difference.low > 0.08
    assert 0.5 < found.improvement.value < 0.8


def test_what_is_the_other_way_round_is_called_so():
    assert results(frame(0.1), [WORSE])[0].verdict == "the opposite"


def test_nothing_is_found_where_there_is_nothing():
    assert results(frame(0.0), [BETTER])[0].verdict == "not found"


def test_two_contrasts_are_corrected_for_their_number():
    one, other = results(frame(0.1), [BETTER, WORSE])
    assert one.adjusted == pytest.approx(2 * one.p)
    assert other.adjusted >= other.p


def test_conditions_with_other_people_are_paired_by_seed():
    apart = frame(0.1).with_columns(
        pl.concat_str("people", "learner", separator=" of ").alias("people")
    )
    (found,) = results(apart, [BETTER])
    assert found.difference.value == pytest.approx(0.1, abs=0.02)
    assert found.difference.method == "crossed bootstrap over seed"


def test_too_many_contrasts_are_refused():
    with pytest.raises(ExperimentError, match="at most 6"):
        results(frame(0.1), [BETTER] * 7)


def test_a_contrast_of_nothing_is_refused():
    absent = Contrast(text="?", more={"learner": "none"}, less={"learner": "plain"})
    with pytest.raises(ExperimentError, match="nothing to compare"):
        results(frame(0.1), [absent])
