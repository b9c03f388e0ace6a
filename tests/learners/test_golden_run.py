"""One short seeded run, worked out anew without any of the package's machinery."""

import math
from collections import defaultdict

import numpy as np
import pytest

from learners import QLearner
from learners.exploration import Softmax
from learners.tabular.rates import AsynchronousRate

GAMMA, EXPONENT, TEMPERATURE = 0.3, 0.8, 0.2


@pytest.fixture
def run():
    """Sixty entries (state, reward or None, next state); 0 likes 0, 1 likes 1."""
    rng = np.random.default_rng(7)
    states = rng.integers(2, size=61).tolist()
    speaks = (rng.random(60) < 0.5).tolist()
    return list(zip(states[:-1], speaks, states[1:], strict=True))


def by_hand(run, seed):
    rng = np.random.default_rng(seed)
    q, visits = defaultdict(lambda: [0.0, 0.0]), defaultdict(lambda: [0, 0])
    for state, speaks, following in run:
        odds = math.exp((q[state][0] - q[state][1]) / TEMPERATURE)
        action = 0 if rng.random() < odds / (1 + odds) else 1
        reward = (1.0 if action == state else -1.0) if speaks else 0.0
        alpha = 1 / (1 + visits[state][action]) ** EXPONENT
        target = reward + GAMMA * max(q[following])
        q[state][action] = (1 - alpha) * q[state][action] + alpha * target
        visits[state][action] += 1
    return dict(q)


def by_learner(run, seed, entry, touch):
    learner = QLearner(
        2,
        np.random.default_rng(seed),
        gamma=GAMMA,
        rate=AsynchronousRate(exponent=EXPONENT),
        exploration=Softmax(temperature=TEMPERATURE),
    )
    for time, (state, speaks, following) in enumerate(run):
        action = learner.act(state)
        value = 1.0 if action == state else -1.0
        felt = (touch(value=value, time=time + 1.0),) if speaks else ()
        learner.learn(entry(state, action, float(time), *felt, next_state=following))
    return learner


@pytest.mark.parametrize("seed", range(5))
def test_a_run_of_q_learning_comes_out_as_the_equations_say(run, entry, touch, seed):
    learner = by_learner(run, seed, entry, touch)
    for state, values in by_hand(run, seed).items():
        np.testing.assert_allclose(learner.q_values(state), values, atol=1e-12)


def test_watching_a_run_does_not_change_it(run, entry, touch):
    unwatched = by_learner(run, 0, entry, touch)
    watched = by_learner([], 0, entry, touch)
    for time, (state, speaks, following) in enumerate(run):
        action = watched.act(state)
        for each in (0, 1):
            watched.q_values(each)
            watched.rate(watched.table.updates, watched.table.visits(each)[0], None)
            watched.network.probability(each, each, 0)
        value = 1.0 if action == state else -1.0
        felt = (touch(value=value, time=time + 1.0),) if speaks else ()
        watched.learn(entry(state, action, float(time), *felt, next_state=following))
    assert watched.table.rows == unwatched.table.rows
