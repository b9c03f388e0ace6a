import numpy as np
import pytest

from learners import QLearner, load, make_learner
from learners.components import COMPONENTS, made
from learners.credit.rules import Designated, Immediate, Trace
from learners.errors import ParameterError
from learners.tabular.rates import AsynchronousRate, ConstantRate
from learners.tabular.silence import SilentSteps


@pytest.fixture
def make(rng):
    def make(rate=None, credit=None, **how):
        return QLearner(
            2,
            rng,
            gamma=0.0,
            rate=rate or ConstantRate(alpha=0.5),
            credit=credit or Immediate(),
            silent_steps=SilentSteps(**how),
        )

    return make


def test_silence_that_is_counted_apart_leaves_touches_their_rate(make, entry, touch):
    exponent = 0.77
    together, apart = (
        make(rate=AsynchronousRate(exponent=exponent), apart=apart)
        for apart in (False, True)
    )
    for learner in (together, apart):
        for second in range(3):
            learner.learn(entry("s", 0, float(second)))
        learner.learn(entry("s", 0, 3.0, touch(value=1.0, time=4.0)))
    assert together.q_values("s")[0] == pytest.approx(4.0**-exponent)
    assert apart.q_values("s")[0] == 1.0  # the first touch, at a rate of 1


def test_touches_that_are_counted_apart_leave_silence_its_rate(make, entry, touch):
    learner = make(rate=AsynchronousRate(), apart=True)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("s", 0, 1.0))  # the first silence, at a rate of 1
    assert learner.q_values("s")[0] == 0.0
    assert learner.table.visits("s") == [2.0, 0.0]


def test_silence_held_back_is_learned_when_the_wait_is_over(make, entry, touch):
    learner = make(held=True, wait=2.0)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("s", 0, 1.0))  # ends at 2 s
    learner.learn(entry("t", 0, 2.0))
    assert learner.q_values("s")[0] == 0.5
    learner.learn(entry("t", 0, 3.0))  # ends at 4 s
    assert learner.q_values("s")[0] == 0.25


def test_silence_is_held_back_while_somebody_is_on_the_way(make, entry, touch):
    learner = make(held=True, wait=0.0)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    for second in range(1, 6):
        learner.learn(entry("s", 0, float(second), approached=True))
    assert learner.q_values("s")[0] == 0.5
    learner.learn(entry("t", 0, 6.0))
    assert learner.q_values("s")[0] == pytest.approx(0.5 * 0.5**5)


def test_silence_is_never_learned_where_a_touch_comes_late(make, entry, touch):
    late = touch(value=-1.0, time=4.0, approach_began=0.5)
    learner, hasty = (make(held=held, credit=Designated()) for held in (True, False))
    for each in (learner, hasty):
        each.learn(entry("s", 0, 0.0))  # what the touch is about
        each.learn(entry("t", 1, 1.0, approached=True))
        each.learn(entry("u", 1, 2.0, approached=True))
        each.learn(entry("u", 1, 3.0, late))
        for second in range(4, 9):
            each.learn(entry("v", 1, float(second)))
    assert learner.table.visits("s") == [1.0, 0.0]
    assert hasty.table.visits("s") == [2.0, 0.0]
    assert learner.table.visits("t") == hasty.table.visits("t")


def test_silence_under_attention_is_learned_as_such_when_it_was_held_back(rng, entry):
    learner = QLearner(2, rng, silent_steps=SilentSteps(held=True))
    learner.learn(entry("s", 0, 0.0, attended=True))
    learner.learn(entry("t", 0, 1.0))
    learner.learn(entry("t", 0, 2.0))
    (target,) = learner.targets
    assert (target.state, target.factors.attended) == ("s", True)


def test_an_episode_that_ends_takes_its_silence_along(make, entry):
    learner = make(held=True)
    learner.learn(entry("s", 0, 0.0))
    learner.start_episode()
    for second in range(4):
        learner.learn(entry("t", 0, float(second)))
    assert learner.table.visits("s") == [0.0, 0.0]
    assert learner.table.visits("t") == [2.0, 0.0]


@pytest.mark.parametrize("name", COMPONENTS["silent_steps"])
def test_what_waits_and_what_is_counted_is_saved(name, live, tmp_path):
    settings = made({"silent_steps": name})
    learner = make_learner("designated", 3, np.random.default_rng(1), **settings)
    live(learner, 40, np.random.default_rng(2))
    learner.save(tmp_path / "learner.json")
    twin = load(tmp_path / "learner.json")
    start = learner.history.entries[-1].next_time
    for each in (learner, twin):
        live(each, 40, np.random.default_rng(3), start=start)
    assert twin.table.to_data() == learner.table.to_data()
    assert bool(learner.table.silent) == ("apart" in name)


def test_what_cannot_be_is_refused(make):
    with pytest.raises(ParameterError, match="Trace"):
        make(credit=Trace(), held=True)
    with pytest.raises(ParameterError, match="wait"):
        SilentSteps(wait=-1.0)
    with pytest.raises(ParameterError, match="held is 2"):
        SilentSteps(held=2)
