"""Which representations by whole situations equal which closures of operators."""

from itertools import pairwise, permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import QLearner
from learners.analogy import Propagation
from learners.credit.rules import Designated
from learners.errors import StateError
from learners.representation import Canonical, MarkedSituations, Named, Nameless

NAMES = ("ann", "bob", "eve", "joe")
ROLES = ("reads", "calls", "plays")


@st.composite
def sentences(draw, names):
    plays = ", ".join(f"{name} {draw(st.sampled_from(ROLES))}" for name in names)
    pairs = [f"{a} {b}" for a in names for b in (*names, "robot") if a != b]
    looks = draw(st.lists(st.sampled_from(pairs), max_size=3, unique=True))
    return plays, *looks


def key(representation, state):
    (part,) = representation.parts(state)
    return part.key


def swap_with_strangers(state):
    """Everybody may take the place of everybody, also of those who are not there."""
    for one in state.entities:
        for other in NAMES:
            if other != one:
                yield state.swapped(one, other)


def closure(state, *operators, depth):
    analogy = Propagation(operators=operators, depth=depth)
    return {analog for analog, _ in analogy.spread(state)}


def test_the_named_situation_is_itself_whatever_it_is():
    assert Named().parts("any value") == (("any value", None, True),)


@settings(deadline=None, max_examples=60)
@given(data=st.data(), n=st.integers(1, 3), m=st.integers(1, 3))
def test_without_names_is_the_closure_under_swaps_with_strangers(toy, data, n, m):
    one = toy(*data.draw(sentences(NAMES[:n])))
    other = toy(*data.draw(sentences(NAMES[-m:])))
    reached = closure(one, swap_with_strangers, depth=len(NAMES))
    assert {key(Nameless(), state) for state in reached} == {key(Nameless(), one)}
    alike = key(Nameless(), one) == key(Nameless(), other)
    assert (other in reached) == alike


def test_canonical_tells_strangers_apart_and_nameless_does_not(toy):
    known, strange = toy("ann reads, bob calls"), toy("eve reads, joe calls")
    assert key(Canonical(), known) != key(Canonical(), strange)
    assert key(Nameless(), known) == key(Nameless(), strange)


@settings(deadline=None, max_examples=25)
@given(data=st.data())
def test_a_stranger_meets_what_swaps_with_strangers_would_have_carried(
    toy, entry, touch, data
):
    ways = (
        {"analogy": Propagation(operators=(swap_with_strangers,), depth=4)},
        {"representation": Nameless()},
    )
    learners = [
        QLearner(2, np.random.default_rng(0), credit=Designated(), **way)
        for way in ways
    ]
    pairs = list(permutations(NAMES, 2))
    states = [
        toy(*data.draw(sentences(data.draw(st.sampled_from(pairs))))) for _ in range(7)
    ]
    for time, (state, following) in enumerate(pairwise(states)):
        value = data.draw(st.sampled_from((None, -1.0, 0.5)))
        felt = () if value is None else (touch(value=value, time=time + 0.5),)
        for learner in learners:
            learner.learn(entry(state, 1, float(time), *felt, next_state=following))
    for state in states:
        np.testing.assert_allclose(
            learners[0].q_values(state), learners[1].q_values(state), atol=1e-12
        )


def test_a_marked_situation_is_the_same_for_whoever_plays_the_part(toy):
    phone = toy("ann reads, bob calls, eve plays", "bob robot")
    marked = {p.person: p.key for p in MarkedSituations().parts(phone)}
    for e1, e2 in (("ann", "bob"), ("bob", "eve"), ("ann", "eve")):
        swapped = MarkedSituations().parts(phone.swapped(e1, e2))
        other = {part.person: part.key for part in swapped}
        assert other[e2] == marked[e1]
        assert other[e1] != marked[e1]


def test_nobody_is_marked_where_nobody_is(toy):
    assert MarkedSituations().parts(toy("")) == ()


@pytest.mark.parametrize(
    ("representation", "lacking"),
    [
        (Canonical(), "lacks entities"),
        (Nameless(), "lacks without_names"),
        (MarkedSituations(), "lacks entities"),
    ],
)
def test_a_state_that_lacks_what_is_asked_of_it_is_refused(representation, lacking):
    with pytest.raises(StateError, match=lacking):
        representation.parts("no situation")
