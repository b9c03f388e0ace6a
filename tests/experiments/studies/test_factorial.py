import numpy as np
import polars as pl
import pytest

from experiments.paper import EXPERIMENTS, OF_PAPER
from experiments.running.study import Condition, Trial
from experiments.running.trial import describe_condition
from experiments.studies import factorial
from experiments.studies.factorial import Combination


def grid(values):
    """A table of one outcome: (levels, seed) -> value."""
    return pl.DataFrame(
        [
            {"seed": seed, "right": value, **Combination(*levels)._asdict()}
            for (levels, seed), value in values.items()
        ]
    )


def test_the_36_conditions_combine_every_level_and_can_all_be_made():
    study = factorial.study(5, (0,))
    assert len(study.conditions) == 36
    settings = [describe_condition(c)["settings"] for c in study.conditions]
    assert all(one not in settings[:index] for index, one in enumerate(settings))


@pytest.mark.parametrize("number", OF_PAPER)
def test_what_the_paper_ran_is_among_the_combinations(number):
    ran = {Combination(**one.factors) for one in factorial.conditions(number)}
    assert factorial.PAPER[number] <= ran


@pytest.mark.parametrize(
    ("number", "levels", "condition"),
    [
        (1, ("asynchronous", "immediate", "none"), "asynchronous"),
        (2, ("social", "immediate", "none"), "social"),
        (3, ("social", "trace", "none"), "trace"),
        (4, ("social", "designated", "none"), "designated"),
        (5, ("social", "designated", "swap"), "swap"),
        (5, ("skip_silence", "designated", "swap"), "skip_silence"),
    ],
)
def test_a_combination_is_the_learner_of_the_plain_run(number, levels, condition):
    combinations = {Combination(**c.factors): c for c in factorial.conditions(number)}
    plain = EXPERIMENTS[number].condition(condition)
    assert (
        describe_condition(combinations[levels])["settings"]
        == (describe_condition(plain)["settings"])
    )


def test_a_level_is_averaged_over_the_other_factors():
    frame = grid(
        {
            (("social", "trace", "none"), 1): 0.4,
            (("social", "trace", "swap"), 1): 0.6,
            (("social", "immediate", "none"), 1): 0.0,
            (("social", "trace", "none"), 0): 1.0,
            (("asynchronous", "trace", "none"), 0): 0.0,
        }
    )
    found = factorial.level_means(frame, "right", {"rate": "social", "credit": "trace"})
    assert found.tolist() == [1.0, 0.5]


def test_a_combination_that_is_run_keeps_its_outcomes_alone():
    condition = factorial.study(3, (0,)).conditions[0]
    short = Condition(
        name="short",
        scenario=condition.scenario,
        learner=condition.learner,
        learner_overrides=condition.learner_overrides,
        scenario_overrides={"max_cycles": 300},
    )
    frame = factorial.run_combination(Trial(condition=short, seed=0), 3)
    assert frame.columns == list(factorial.OUTCOMES)
    assert len(frame) == 1
    assert 0.0 <= frame["right"][0] <= 1.0


def test_a_nan_in_a_cell_leaves_its_seed_out():
    levels = ("social", "trace", "none")
    frame = grid({(levels, 0): None, (levels, 1): 0.5})
    found = factorial.estimates(frame, "right")[levels]
    assert (found.n, found.value) == (1, 0.5)
    assert np.isnan(found.low)
