"""What is written down of a condition."""

import pytest

from experiments.paper import EXPERIMENTS
from experiments.running.study import Condition
from experiments.running.trial import configuration, describe, make_learner_of


def described(**overrides):
    condition = Condition(
        name="a", scenario="s", learner="designated", learner_overrides=overrides
    )
    return describe(make_learner_of(condition))


def test_a_setting_that_came_later_is_written_down_where_it_says_something():
    assert "silent_steps" not in described()
    assert "silent_steps" not in described(silent_steps="together")
    assert described(silent_steps="apart")["silent_steps"] == {
        "type": "SilentSteps",
        "apart": True,
        "held": False,
        "wait": 2.0,
    }


@pytest.mark.parametrize("number", EXPERIMENTS)
def test_what_is_stored_of_an_experiment_names_nothing_of_this_process(number):
    """Else the same command would refuse its own results in the next process."""
    described = str(configuration(EXPERIMENTS[number].study((0,))))

    assert " at 0x" not in described
