import math
from dataclasses import dataclass

import numpy as np
import pytest

from learners import QLearner
from learners.analogy.carrying import Propagation
from learners.credit.heuristics import FixedDelay
from learners.credit.rules import CreditRule, Designated, Trace, Weighing
from learners.errors import ExperienceError, ParameterError, UnknownBehaviorError
from learners.exploration import Greedy, Thompson
from learners.tabular.rates import (
    AsynchronousRate,
    ConstantRate,
    SocialRate,
    SynchronousRate,
)


@pytest.fixture
def make(rng):
    def make(**parts):
        parts.setdefault("rate", ConstantRate(alpha=0.5))
        return QLearner(2, rng, **parts)

    return make


def test_one_update_of_q_learning_worked_by_hand(make, entry, touch):
    learner = make(gamma=0.5)
    learner.learn(entry("t", 0, 0.0, touch(value=0.8, time=1.0)))  # Q(t, 0) = 0.4
    learner.learn(entry("s", 1, 1.0, touch(value=1.0, time=2.0), next_state="t"))
    # 0 + 0.5 * (1 + 0.5 * 0.4 - 0) = 0.6
    assert learner.q_values("s").tolist() == [0.0, pytest.approx(0.6)]


def test_silence_is_a_reward_of_zero_for_the_newest_pair(make, entry, touch):
    learner = make(gamma=0.0)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("s", 0, 1.0))
    assert learner.q_values("s")[0] == pytest.approx(0.25)  # 0.5, then half of it


def test_two_touches_at_once_are_two_updates(make, entry, touch):
    learner = make(gamma=0.0)
    felt = (touch(value=1.0, time=1.0), touch(value=-1.0, time=1.0, giver="bob"))
    learner.learn(entry("s", 0, 0.0, *felt))
    # 0.5 * 1 = 0.5, then 0.5 + 0.5 * (-1 - 0.5) = -0.25
    assert learner.q_values("s")[0] == pytest.approx(-0.25)
    assert learner.table.visits("s") == [2.0, 0.0]
    assert len(learner.credits) == 2


def test_a_synchronous_learner_tires_for_all_pairs_at_once(make, entry, touch):
    learner = make(gamma=0.0, rate=SynchronousRate(exponent=1.0))
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("t", 0, 1.0, touch(value=1.0, time=2.0)))
    assert learner.q_values("s")[0] == 1.0  # rate 1
    assert learner.q_values("t")[0] == 0.5  # rate 1/2, though never visited


def test_an_asynchronous_learner_tires_pair_by_pair(make, entry, touch):
    learner = make(gamma=0.0, rate=AsynchronousRate())
    for time, state in enumerate("stss"):
        learner.learn(entry(state, 0, float(time), touch(value=1.0, time=time + 1.0)))
    assert learner.q_values("t")[0] == 1.0
    assert learner.table.visits("s") == [3.0, 0.0]


def test_a_social_learner_forgets_less_of_what_goes_unrewarded(make, entry, touch):
    values = {}
    for rate in (AsynchronousRate(), SocialRate()):
        learner = make(gamma=0.0, rate=rate)
        learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
        for time in range(1, 6):
            learner.learn(entry("s", 0, float(time)))
        values[type(rate)] = learner.q_values("s")[0]
    product = 1.0
    for visits in range(1, 6):
        product *= 1 - (1 + visits) ** -1.4
    assert values[SocialRate] == pytest.approx(product)
    assert values[SocialRate] > 2 * values[AsynchronousRate]


def test_a_trace_carries_the_newest_error_back(make, entry, touch):
    learner = make(gamma=0.0, credit=Trace(decay=0.5))
    learner.learn(entry("a", 0, 0.0, touch(value=0.4, time=1.0)))  # Q(a) = 0.2
    learner.learn(entry("b", 0, 1.0, touch(value=1.0, time=2.0)))
    # error 1 - 0 = 1; Q(b) = 0.5 * 1, Q(a) = 0.2 + 0.5 * 0.5 * 1
    assert learner.q_values("b")[0] == pytest.approx(0.5)
    assert learner.q_values("a")[0] == pytest.approx(0.45)


def test_a_trace_ends_at_a_behavior_chosen_against_the_values(make, entry, touch):
    learner = make(gamma=0.0, credit=Trace(decay=0.5), rate=ConstantRate(alpha=1.0))
    learner.learn(entry("b", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("a", 0, 1.0))
    learner.learn(entry("b", 1, 2.0))  # against Q(b, 0) = 1
    before = learner.q_values("a")[0]
    learner.learn(entry("c", 0, 3.0, touch(value=1.0, time=4.0)))
    assert learner.q_values("a")[0] == before
    assert learner.q_values("b")[1] == pytest.approx(0.5)


def test_a_behavior_that_just_went_on_does_not_cut_the_trace(make, entry, touch):
    learner = make(gamma=0.0, credit=Trace(decay=0.5), rate=ConstantRate(alpha=1.0))
    learner.learn(entry("b", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("a", 1, 1.0))
    learner.learn(entry("b", 1, 2.0, chosen=False))
    learner.learn(entry("c", 0, 3.0, touch(value=1.0, time=4.0)))
    assert learner.q_values("a")[1] == pytest.approx(0.25)


def test_designated_credit_lands_on_the_designated_pair(make, entry, touch):
    rule = Designated(heuristic=FixedDelay(delay=5.0))
    learner = make(gamma=0.0, credit=rule)
    learner.learn(entry("phone", 1, 0.0, next_time=5.0, next_state="floor"))
    learner.learn(entry("floor", 1, 5.0, touch(value=-1.0, time=6.0)))
    assert learner.q_values("phone").tolist() == [0.0, -0.5]
    assert learner.q_values("floor").tolist() == [0.0, 0.0]
    (credit,) = learner.credits
    assert credit.designated.state == "phone"
    assert [(e.state, e.action, e.time, w) for e, w in credit.shares] == [
        ("phone", 1, 0.0, 1.0)
    ]


def test_silence_leaves_no_credits(make, entry, touch):
    learner = make()
    learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    learner.learn(entry("s", 0, 1.0))
    assert learner.credits == ()


def test_a_new_episode_keeps_the_values_and_starts_the_clock_anew(make, entry, touch):
    learner = make()
    learner.learn(entry("s", 0, 50.0, touch(time=51.0)))
    learner.start_episode()
    learner.learn(entry("t", 0, 0.0))
    assert learner.q_values("s")[0] > 0.0


def test_asking_for_values_changes_nothing(make):
    learner = make()
    learner.q_values("s")[0] = 5.0
    assert learner.q_values("s").tolist() == [0.0, 0.0]
    assert len(learner.table) == 0


def test_a_greedy_learner_does_what_was_caressed(make, entry, touch):
    learner = make(exploration=Greedy())
    learner.learn(entry("s", 1, 0.0, touch(time=1.0)))
    assert learner.act("s") == 1


def snapshot(learner):
    rows = {s: (list(r.values), list(r.visits)) for s, r in learner.table.rows.items()}
    return rows, learner.table.updates, len(learner.history)


@pytest.mark.parametrize("action", [-1, 2, 0.5, 1.0])
def test_an_unknown_behavior_is_refused_and_the_table_unchanged(
    make, entry, touch, action
):
    learner = make()
    learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    before = snapshot(learner)
    with pytest.raises(UnknownBehaviorError, match=f"behavior {action} is not one"):
        learner.learn(entry("s", action, 1.0, touch(time=2.0)))
    assert snapshot(learner) == before


def test_an_entry_out_of_order_is_refused_and_the_table_unchanged(make, entry, touch):
    learner = make()
    learner.learn(entry("s", 0, 5.0, touch(time=6.0)))
    before = snapshot(learner)
    with pytest.raises(ExperienceError, match="overlaps"):
        learner.learn(entry("s", 0, 4.0, touch(time=5.0)))
    with pytest.raises(ExperienceError, match="older than the history"):
        learner.learn(entry("s", 0, 6.0, touch(time=1.0)))
    assert snapshot(learner) == before


class Broken(CreditRule):
    def weigh(self, reward, history, network):
        raise ExperienceError("a user's rule that fails")


@dataclass
class Skewed(CreditRule):
    weight: float

    def weigh(self, reward, history, network):
        return Weighing({0: self.weight}, 0)


@pytest.mark.parametrize("weight", [math.nan, math.inf, -0.1])
def test_a_credit_rule_with_impossible_weights_is_refused(make, entry, touch, weight):
    learner = make(credit=Skewed(weight))
    with pytest.raises(ParameterError, match="the weight that a credit rule gave"):
        learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    assert len(learner.table) == 0


class Scattered(CreditRule):
    def weigh(self, reward, history, network):
        return Weighing({}, None)


def test_a_credit_rule_that_fails_leaves_the_table_unchanged(make, entry, touch):
    learner = make(credit=Broken())
    with pytest.raises(ExperienceError, match="user's rule"):
        learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    assert len(learner.table) == 0


def test_a_touch_may_be_about_nothing(make, entry, touch):
    learner = make(credit=Scattered())
    learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    assert len(learner.table) == 0
    assert learner.credits[0].designated is None


@pytest.mark.parametrize(
    ("parts", "reason"),
    [
        ({"gamma": 1.0}, "gamma"),
        ({"gamma": -0.1}, "gamma"),
        ({"horizon": 0.0}, "horizon"),
        ({"exploration": Thompson()}, "posterior"),
    ],
)
def test_a_learner_out_of_range_is_refused(make, parts, reason):
    with pytest.raises(ParameterError, match=reason):
        make(**parts)


def test_behaviors_are_at_least_one(rng):
    with pytest.raises(ParameterError, match="n_behaviors"):
        QLearner(0, rng)


def test_values_are_numpy_arrays_of_all_behaviors(make):
    values = make().q_values("s")
    assert values.shape == (2,)
    assert values.dtype == np.float64


def test_an_update_carried_to_analogs_counts_once(rng, toy, entry):
    learner = QLearner(2, rng, analogy=Propagation())
    learner.learn(entry(toy("ann reads, bob calls"), 0, 0.0))
    assert (len(learner.table), learner.table.updates) == (2, 1)
