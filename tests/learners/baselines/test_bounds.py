import numpy as np
import pytest

from learners import make_learner
from learners.baselines.bounds import OracleCredit
from learners.credit.history import History
from learners.credit.transitions import SituationNetwork

TRUTH = {"reads": [-1.0, 0.0, 1.0], "plays": [1.0, 0.2, -1.0]}


def appropriateness(state):
    return np.array(TRUTH[state])


def test_chance_takes_every_behavior_alike(rng):
    learner = make_learner("random", 4, rng)
    chosen = [learner.act("s") for _ in range(4000)]
    shares = [chosen.count(behavior) / 4000 for behavior in range(4)]
    assert shares == pytest.approx([0.25] * 4, abs=0.03)


@pytest.mark.parametrize("name", ["population_oracle", "persona_oracle"])
def test_an_oracle_does_what_people_really_like(name, rng):
    learner = make_learner(name, 3, rng, appropriateness=appropriateness)
    assert [learner.act(state) for state in ("reads", "plays")] == [2, 0]
    assert learner.q_values("plays").tolist() == TRUTH["plays"]


def test_the_best_constant_is_the_best_on_average(rng):
    learner = make_learner("best_constant", 3, rng, appropriateness=appropriateness)
    assert learner.act("reads") == 2  # so far people read
    # means over both: 0.0, 0.1, 0.0
    assert learner.act("plays") == 1
    assert learner.act("plays") == 0  # means 1/3, 0.13, -1/3


def test_an_oracle_is_told_nothing_new_by_touches(rng, entry, touch):
    learner = make_learner("persona_oracle", 3, rng, appropriateness=appropriateness)
    learner.learn(entry("plays", 0, 0.0, touch(value=-1.0, time=1.0)))
    assert learner.q_values("plays").tolist() == TRUTH["plays"]


def test_oracle_credit_goes_to_the_true_cause(entry, touch):
    history = History()
    for time, state in enumerate("abc"):
        history.append(entry(state, 0, float(time)))
    rule = OracleCredit(cause=lambda reward: reward.time - 2.0)
    assert rule.weigh(touch(time=3.0), history, SituationNetwork()) == ({1: 1.0}, 1)


def test_a_touch_without_a_cause_is_credited_to_nothing(entry, touch):
    history = History()
    history.append(entry())
    rule = OracleCredit(cause=lambda reward: None)
    assert rule.weigh(touch(time=1.0), history, SituationNetwork()) == ({}, None)
