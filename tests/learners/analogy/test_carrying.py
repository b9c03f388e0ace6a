from itertools import pairwise, permutations
from math import factorial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import QLearner
from learners.analogy.carrying import Analogy, Propagation
from learners.analogy.operators import RemoveEntity
from learners.credit.rules import Designated, Trace
from learners.errors import ParameterError, StateError
from learners.exploration import Softmax
from learners.representation.situations import Canonical
from learners.representation.views import Views
from learners.tabular.rates import AsynchronousRate, ConstantRate, SocialRate


@pytest.fixture
def three(toy):
    return toy("ann reads, bob calls, eve plays", "bob robot")


def test_without_analogy_an_update_stays_where_it_is(three):
    assert Analogy().spread(three) == ((three, 1.0),)


def test_strength_fades_with_the_number_of_swaps(three):
    spread = Propagation(strength=0.5, depth=2).spread(three)
    assert [strength for _, strength in spread] == [1.0, 0.5, 0.5, 0.5, 0.25, 0.25]
    assert len({state for state, _ in spread}) == 6


def test_a_limit_keeps_the_nearest_analogs(three):
    spread = Propagation(strength=0.5, depth=2, limit=4).spread(three)
    assert [strength for _, strength in spread] == [1.0, 0.5, 0.5, 0.5, 0.25]


def test_users_add_operators_as_plain_functions(three):
    def e1_is_as_e2(state):
        return [state.swapped("ann", "bob")]

    spread = Propagation(operators=(e1_is_as_e2,)).spread(three)
    assert spread == ((three, 1.0), (three.swapped("ann", "bob"), 1.0))


def test_an_analog_moves_by_strength_times_the_rate(toy, entry, touch, rng):
    state = toy("ann reads, bob calls")
    learner = QLearner(2, rng, gamma=0.0, analogy=Propagation(strength=0.25))
    learner.learn(entry(state, 1, 0.0, touch(value=-1.0, time=1.0)))
    np.testing.assert_allclose(learner.q_values(state), [0.0, -1.0])
    analog = state.swapped("ann", "bob")
    np.testing.assert_allclose(learner.q_values(analog), [0.0, -0.25])
    assert learner.table.visits(analog) == [0.0, 0.25]


def test_removing_an_entity_teaches_the_simpler_situation(toy, entry, touch, rng):
    analogy = Propagation(operators=(RemoveEntity(),))
    learner = QLearner(2, rng, gamma=0.0, analogy=analogy)
    state = toy("ann reads, bob calls")
    learner.learn(entry(state, 0, 0.0, touch(value=1.0, time=1.0)))
    np.testing.assert_allclose(learner.q_values(toy("ann reads")), [1.0, 0.0])
    np.testing.assert_allclose(learner.q_values(toy("ann calls")), [0.0, 0.0])


def test_all_of_a_class_read_one_row(three, entry, touch, rng):
    learner = QLearner(2, rng, gamma=0.0, representation=Canonical())
    learner.learn(entry(three, 1, 0.0, touch(value=-1.0, time=1.0)))
    for names in permutations(three.entities):
        renamed = three.renamed(dict(zip(three.entities, names, strict=True)))
        np.testing.assert_allclose(learner.q_values(renamed), [0.0, -1.0])
    assert len(learner.table) == 1


ROLES = st.sampled_from(("reads", "calls", "plays"))
NAMES = ("ann", "bob", "eve", "joe")


@st.composite
def sentences(draw, n):
    plays = ", ".join(f"{name} {draw(ROLES)}" for name in NAMES[:n])
    pairs = [f"{a} {b}" for a in NAMES[:n] for b in (*NAMES[:n], "robot") if a != b]
    looks = draw(st.lists(st.sampled_from(pairs), max_size=4, unique=True))
    return plays, *looks


def closure(state):
    analogy = Propagation(depth=max(len(state.entities) - 1, 1))
    return {analog for analog, _ in analogy.spread(state)}


@settings(deadline=None, max_examples=60)
@given(data=st.data(), n=st.integers(1, 4))
def test_a_canonical_form_stands_for_the_closure_under_swaps_and_no_more(toy, data, n):
    one, other = (toy(*data.draw(sentences(n))) for _ in range(2))
    assert {state.canonical() for state in closure(one)} == {one.canonical()}
    assert (other in closure(one)) == (other.canonical() == one.canonical())


def test_the_closure_of_unlike_actors_has_all_permutations(toy):
    state = toy("ann reads, bob calls, eve plays, joe works")
    assert len(closure(state)) == factorial(4)


@settings(deadline=None, max_examples=25)
@given(data=st.data(), n=st.integers(1, 3))
@pytest.mark.parametrize(
    "parts",
    [
        {"credit": Trace(decay=0.5), "rate": AsynchronousRate()},
        {"credit": Designated(), "rate": SocialRate()},
    ],
)
def test_closed_propagation_and_the_canonical_form_learn_the_same(
    toy, entry, touch, data, n, parts
):
    ways = (
        {"analogy": Propagation(depth=max(n - 1, 1))},
        {"representation": Canonical()},
    )
    learners = [QLearner(2, np.random.default_rng(0), **way, **parts) for way in ways]
    states = [toy(*data.draw(sentences(n))) for _ in range(9)]
    for time, (state, following) in enumerate(pairwise(states)):
        value = data.draw(st.sampled_from((None, -1.0, 0.5)))
        felt = () if value is None else (touch(value=value, time=time + 0.5),)
        action = data.draw(st.integers(0, 1))
        for learner in learners:
            learner.learn(
                entry(state, action, float(time), *felt, next_state=following)
            )
    for state in states:
        for analog in closure(state):
            np.testing.assert_allclose(
                learners[0].q_values(analog), learners[1].q_values(analog), atol=1e-12
            )


@pytest.mark.parametrize(
    "component", [{"analogy": Propagation()}, {"representation": Canonical()}]
)
def test_a_state_that_cannot_be_swapped_leaves_the_table_unchanged(
    component, entry, touch, rng
):
    learner = QLearner(2, rng, exploration=Softmax(), **component)
    with pytest.raises(StateError, match="str lacks entities"):
        learner.learn(entry("no entities", 0, 0.0, touch(time=1.0)))
    assert len(learner.table) == 0


@pytest.mark.parametrize(
    "make",
    [
        lambda: Propagation(strength=1.5),
        lambda: Propagation(depth=0),
        lambda: Propagation(limit=-1),
    ],
)
def test_a_propagation_out_of_range_is_refused(make):
    with pytest.raises(ParameterError):
        make()


@pytest.fixture
def borrower(rng):
    """A learner that carries to simpler situations, up to two people less."""
    remove = Propagation(operators=(RemoveEntity(),), depth=2)
    return QLearner(2, rng, gamma=0.0, rate=ConstantRate(alpha=1.0), analogy=remove)


def test_a_situation_never_met_borrows_from_the_simpler_ones_it_contains(
    borrower, toy, entry, touch
):
    borrower.learn(entry(toy("ann reads, bob calls"), 1, 0.0, touch(-1.0, 1.0)))
    met_with_eve = toy("ann reads, bob calls, eve plays")
    assert borrower.q_values(met_with_eve).tolist() == [0.0, -1.0]


def test_the_nearest_simpler_situation_comes_first(borrower, toy, entry, touch):
    borrower.learn(entry(toy("ann reads"), 0, 0.0, touch(-1.0, 1.0)))
    borrower.learn(entry(toy("ann reads, bob calls"), 0, 1.0, touch(1.0, 2.0)))
    new = toy("ann reads, bob calls, eve plays")
    assert borrower.q_values(new).tolist() == [1.0, 0.0]


def test_equally_near_ones_count_by_their_visits(borrower, toy, entry, touch):
    for time, (plays, value) in enumerate(
        [("ann reads", 1.0), ("ann reads", 1.0), ("bob calls", -0.5)]
    ):
        felt = touch(value, time + 1.0)
        borrower.learn(entry(toy(plays), 0, float(time), felt))
    assert borrower.q_values(toy("ann reads, bob calls"))[0] == pytest.approx(0.5)


def test_what_was_tried_is_not_borrowed(borrower, toy, entry, touch):
    borrower.learn(entry(toy("ann reads"), 0, 0.0, touch(-1.0, 1.0)))
    both = toy("ann reads, bob calls")
    assert borrower.q_values(both).tolist() == [-1.0, 0.0]
    borrower.learn(entry(both, 0, 1.0))  # in silence
    assert borrower.q_values(both).tolist() == [0.0, 0.0]


def test_swaps_alone_have_nothing_to_borrow(toy, entry, touch, rng):
    learner = QLearner(2, rng, gamma=0.0, analogy=Propagation())
    learner.learn(entry(toy("ann reads"), 0, 0.0, touch(-1.0, 1.0)))
    assert learner.q_values(toy("ann reads, bob calls")).tolist() == [0.0, 0.0]


@settings(deadline=None, max_examples=25)
@given(data=st.data())
def test_views_with_names_are_closed_removal_where_all_agree(toy, entry, touch, data):
    n = data.draw(st.integers(1, 3))
    closed = Propagation(operators=(RemoveEntity(),), depth=3)
    plain = {"gamma": 0.0, "rate": AsynchronousRate()}
    removal = QLearner(2, np.random.default_rng(0), analogy=closed, **plain)
    views = QLearner(2, np.random.default_rng(0), representation=Views(), **plain)
    for time in range(6):
        state = toy(*data.draw(sentences(n)))
        value = data.draw(st.sampled_from((None, -1.0, 0.5)))
        givers = () if value is None else state.entities
        felt = [touch(value, time + 0.5, giver) for giver in givers]
        views.learn(entry(state, 0, float(time), *felt))
        removal.learn(entry(state, 0, float(time), *felt[:1]))
    for name in NAMES[:n]:
        for role in ("reads", "calls", "plays"):
            for looks in ([], [f"{name} robot"]):
                alone = toy(f"{name} {role}", *looks)
                np.testing.assert_allclose(
                    views.q_values(alone), removal.q_values(alone), atol=1e-12
                )
