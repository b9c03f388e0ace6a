"""The network per person (extra `deep`)."""

import numpy as np
import pytest

pytest.importorskip("torch", reason="needs the extra `deep` (not in CI)")

from experiments.deep.per_person import NetworkPerPerson
from experiments.phases.seeing import Seen
from learners.experience import Experience, Reward

LIKES_0, LIKES_1 = np.array([1.0, 0.0], np.float32), np.array([1.0, 1.0], np.float32)


def bout(number, action, giver=None):
    state = Seen("both", {"ann": LIKES_0, "bob": LIKES_1})
    touch = Reward(value=1.0, time=10.0 * number + 5, giver=giver, attending=True)
    return Experience(
        state=state,
        action=action,
        next_state=state,
        time=10.0 * number,
        next_time=10.0 * number + 10,
        rewards=(touch,) if giver else (),
        attended=True,
        chosen=True,
    )


def test_a_touch_teaches_what_its_giver_likes_and_silence_what_the_others_do_not():
    learner = NetworkPerPerson(2, np.random.default_rng(0))
    for number in range(300):
        action = number % 2
        learner.learn(bout(number, action, ("ann", "bob")[action]))
    ann = learner.q_values(Seen("ann", {"ann": LIKES_0}))
    bob = learner.q_values(Seen("bob", {"bob": LIKES_1}))
    assert ann == pytest.approx([1.0, 0.0], abs=0.2)
    assert bob == pytest.approx([0.0, 1.0], abs=0.2)


def test_what_is_expected_of_all_is_summed():
    learner = NetworkPerPerson(2, np.random.default_rng(0))
    for number in range(50):
        learner.learn(bout(number, number % 2, "ann"))
    parts = [learner.q_values(Seen("x", {"a": slot})) for slot in (LIKES_0, LIKES_1)]
    whole = learner.q_values(Seen("x", {"a": LIKES_0, "b": LIKES_1}))
    assert whole == pytest.approx(sum(parts), abs=1e-5)
