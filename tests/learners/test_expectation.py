import numpy as np
import pytest

from learners.errors import ParameterError
from learners.expectation import ExpectedTouch
from learners.exploration import Thompson
from learners.pooling import FullPooling, HierarchicalPooling, NoPooling
from learners.representation import Canonical, Views


@pytest.fixture
def make(rng):
    def make(**components):
        components.setdefault("representation", Views())
        components.setdefault("counts", "exposures")
        return ExpectedTouch(2, rng, **components)

    return make


def test_silence_lowers_the_mean_of_exposures_but_not_that_of_touches(
    make, toy, entry, touch
):
    state = toy("ann reads")
    exposures, touches = make(), make(counts="touches")
    for learner in (exposures, touches):
        learner.learn(entry(state, 0, 0.0, touch(time=1.0)))
        for time in (1.0, 2.0, 3.0):
            learner.learn(entry(state, 0, time))
    assert exposures.q_values(state).tolist() == [0.25, 0.0]
    assert touches.q_values(state).tolist() == [1.0, 0.0]


def test_a_touch_teaches_its_givers_view_and_silence_the_others(
    make, toy, entry, touch
):
    learner = make()
    both = toy("ann reads, bob calls")
    learner.learn(entry(both, 0, 0.0, touch(value=-1.0, time=1.0, giver="bob")))
    assert learner.q_values(toy("bob calls")).tolist() == [-1.0, 0.0]
    assert learner.q_values(toy("ann reads")).tolist() == [0.0, 0.0]
    visits = {person: row.visits[0] for (_, person), row in learner.table.rows.items()}
    assert visits == {"ann": 1.0, "bob": 1.0}


def test_views_of_all_who_are_there_add_up(make, toy, entry, touch):
    learner = make(pooling=FullPooling())
    learner.learn(entry(toy("bob calls"), 0, 0.0, touch(-1.0, 1.0, "bob")))
    learner.learn(entry(toy("ann plays"), 0, 1.0, touch(0.5, 2.0, "ann")))
    strangers = toy("eve calls, joe calls, zoe plays")
    assert learner.q_values(strangers)[0] == pytest.approx(-1.0 - 1.0 + 0.5)


def test_whoever_could_not_perceive_the_robot_is_not_exposed(make, toy, entry):
    learner = make()
    learner.learn(entry(toy("ann reads, bob calls", hears=["ann"]), 0, 0.0))
    assert [person for _, person in learner.table] == ["ann"]


def test_a_bout_exposes_each_view_once(make, toy, entry):
    learner = make()
    reading, looking = toy("ann reads, bob calls"), toy("ann reads, bob plays")
    learner.learn(entry(reading, 0, 0.0))
    learner.learn(entry(looking, 0, 1.0, chosen=False))
    learner.learn(entry(looking, 0, 2.0))
    visits = {
        (person, dict(view)["plays"]): row.visits[0]
        for (view, person), row in learner.table.rows.items()
    }
    assert visits == {("ann", "reads"): 2.0, ("bob", "calls"): 1.0, ("bob", "plays"): 2}


def test_whoever_touches_was_exposed_even_if_the_robot_could_not_know(
    make, toy, entry, touch
):
    learner = make()
    deaf = toy("ann reads, bob calls", hears=["bob"])
    learner.learn(entry(deaf, 0, 0.0, touch(value=-1.0, time=1.0, giver="ann")))
    assert learner.q_values(toy("ann reads")).tolist() == [-1.0, 0.0]


def test_nobody_at_home_is_worth_nothing(make, toy, entry, touch):
    learner = make()
    learner.learn(entry(toy(""), 0, 0.0, touch(time=1.0)))
    assert learner.q_values(toy("")).tolist() == [0.0, 0.0]
    assert len(learner.table) == 0


def test_rare_touches_weigh_less_in_the_sum_than_frequent_ones(make, toy, entry, touch):
    """Why means of touches fall behind: they forget how often somebody touches."""
    learners = make(), make(counts="touches")
    both, time = toy("ann reads, bob calls"), 0.0
    for step in range(40):
        action = step % 2
        felt = []
        if step % 8 == 0:  # ann hardly ever praises behavior 0
            felt.append(touch(1.0, time + 1.0, "ann"))
        if action == 1:  # bob always praises behavior 1, a little
            felt.append(touch(0.5, time + 1.0, "bob"))
        for learner in learners:
            learner.learn(entry(both, action, time, *felt))
        time += 1.0
    exposures, touches = (learner.q_values(both) for learner in learners)
    np.testing.assert_allclose(exposures, [0.25, 0.5])
    np.testing.assert_allclose(touches, [1.0, 0.5])


def test_a_posterior_comes_of_hierarchical_pooling_over_people(make):
    make(pooling=HierarchicalPooling(), exploration=Thompson())
    for components in (
        {"pooling": NoPooling()},
        {"pooling": HierarchicalPooling(), "representation": Canonical()},
    ):
        with pytest.raises(ParameterError, match="needs a posterior"):
            make(exploration=Thompson(), **components)


def test_what_is_no_way_of_counting_is_refused(make):
    with pytest.raises(ParameterError, match="counts is 'steps'"):
        make(counts="steps")
