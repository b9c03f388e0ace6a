"""Views: one person with everybody else removed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners.analogy import Propagation, RemoveEntity
from learners.errors import ParameterError, StateError
from learners.expectation import ExpectedTouch
from learners.pooling import FullPooling, NoPooling
from learners.representation import (
    AudibleViews,
    NestedViews,
    PersonViews,
    Views,
    ViewSet,
)

NAMES = ("ann", "bob", "eve", "joe")
ALL = ("plays", "attends", "hears")


@st.composite
def sentences(draw, n):
    roles = st.sampled_from(("reads", "calls", "plays"))
    plays = ", ".join(f"{name} {draw(roles)}" for name in NAMES[:n])
    pairs = [f"{a} {b}" for a in NAMES[:n] for b in (*NAMES[:n], "robot") if a != b]
    return plays, *draw(st.lists(st.sampled_from(pairs), max_size=4, unique=True))


def keys(representation, state):
    return [part.key for part in representation.parts(state)]


def test_a_view_is_a_role_and_whether_the_robot_is_attended_to(toy):
    state = toy("ann reads, bob calls", "ann robot", "bob ann")
    assert Views().parts(state) == (
        ((("plays", "reads"), ("attends", "robot")), "ann", True),
        ((("plays", "calls"),), "bob", True),
    )


@settings(deadline=None, max_examples=60)
@given(data=st.data(), n=st.integers(1, 4))
def test_views_are_what_is_left_when_all_others_are_removed(toy, data, n):
    state = toy(*data.draw(sentences(n)))
    remove = Propagation(operators=(RemoveEntity(),), depth=n)
    alone = {s for s, _ in remove.spread(state) if len(s.entities) == 1}
    assert {s.entities[0]: keys(Views(), s) for s in alone} == {
        part.person: [part.key] for part in Views().parts(state)
    }


@settings(deadline=None, max_examples=60)
@given(data=st.data(), n=st.integers(1, 4))
def test_a_set_of_views_forgets_who_has_them_and_how_many(toy, data, n):
    state = toy(*data.draw(sentences(n)))
    assert keys(ViewSet(), state) == [frozenset(keys(Views(), state))]
    twin = state.renamed({"ann": "zoe"})
    both = type(state)(
        (*state.plays, ("zoe", dict(state.plays)["ann"])), state.looks | twin.looks
    )
    assert keys(ViewSet(), both) == keys(ViewSet(), state)


@settings(deadline=None, max_examples=30)
@given(data=st.data())
def test_views_with_names_are_views_whose_people_are_not_pooled(
    toy, entry, touch, data
):
    kinds = (
        {"representation": Views(), "pooling": NoPooling()},
        {"representation": PersonViews(), "pooling": FullPooling()},
        {"representation": PersonViews(), "pooling": NoPooling()},
    )
    learners = [
        ExpectedTouch(2, np.random.default_rng(0), counts="exposures", **kind)
        for kind in kinds
    ]
    states = [toy(*data.draw(sentences(3))) for _ in range(8)]
    for time, state in enumerate(states):
        giver = data.draw(st.sampled_from((None, *NAMES)))
        felt = () if giver is None else (touch(time=time + 0.5, giver=giver),)
        for learner in learners:
            learner.learn(entry(state, time % 2, float(time), *felt))
    for state in states:
        own, *others = (learner.q_values(state) for learner in learners)
        for other in others:
            np.testing.assert_allclose(own, other, atol=1e-12)


def test_only_those_who_attend_or_hear_are_within_hearing(toy):
    state = toy("ann reads, bob calls, eve plays", "ann robot", hears=["eve"])
    assert [part.person for part in AudibleViews().parts(state)] == ["ann", "eve"]


def test_the_silence_of_those_who_could_not_perceive_says_nothing(toy):
    state = toy("ann reads, bob calls, eve plays", "ann robot", hears=["eve"])
    assert {p.person: p.perceives for p in Views().parts(state)} == {
        "ann": True,
        "bob": False,
        "eve": True,
    }


def test_where_nothing_is_said_of_hearing_anybody_could_have_heard(toy):
    state = toy("ann reads, bob calls", "ann robot")
    assert all(part.perceives for part in Views().parts(state))


def test_a_view_consists_of_the_relations_that_are_asked_for(toy):
    state = toy("ann reads", "ann robot", hears=["ann"])
    (all_of_it,) = keys(Views(relations=ALL), state)
    assert all_of_it == (("plays", "reads"), ("attends", "robot"), ("hears", "robot"))
    assert keys(Views(relations=("plays",)), state) == [(("plays", "reads"),)]


def test_nested_views_are_audible_views_and_the_same_by_role_alone(toy):
    state = toy("ann reads, bob calls, eve plays", "ann robot", hears=["eve"])
    audible, nested = AudibleViews().parts(state), NestedViews().parts(state)
    assert [part.person for part in nested] == ["ann", "ann", "eve", "eve"]
    assert [part.key for part in nested[::2]] == [(0, part.key) for part in audible]
    assert [part.key for part in nested[1::2]] == [
        (1, (("plays", "reads"),)),
        (1, (("plays", "plays"),)),
    ]


def test_a_new_view_is_read_off_its_role_and_a_known_one_off_both(toy, entry, touch):
    attending = toy("ann reads", "ann robot", hears=["ann"])
    listening = toy("ann reads", hears=["ann"])
    settings = {"representation": NestedViews(), "pooling": FullPooling()}
    learner = ExpectedTouch(2, np.random.default_rng(1), **settings)
    learner.learn(entry(attending, 0, 0.0, touch(0.8, 0.0)))
    assert learner.q_values(attending)[0] == pytest.approx(0.8)
    # The full view is blank, so that half of it is the role's.
    assert learner.q_values(listening)[0] == pytest.approx(0.4)
    learner.learn(entry(listening, 0, 1.0, touch(-0.4, 1.0)))
    # The role's mean is now 0.2; one of its two views is at 0.8, the other at -0.4.
    assert learner.q_values(attending)[0] == pytest.approx((0.8 + 0.2) / 2)
    assert learner.q_values(listening)[0] == pytest.approx((-0.4 + 0.2) / 2)


@pytest.mark.parametrize(
    "kind", [Views, AudibleViews, NestedViews, PersonViews, ViewSet]
)
def test_a_state_without_views_is_refused(kind):
    with pytest.raises(StateError, match="str lacks views"):
        kind().parts("no situation")


@pytest.mark.parametrize(
    ("kind", "given"),
    [
        (Views, {"relations": "plays"}),
        (Views, {"relations": (1,)}),
        (NestedViews, {"relations": 0.3}),
        (NestedViews, {"coarser": 0.3}),
        (NestedViews, {"coarser": ("plays",)}),
        (NestedViews, {"coarser": (("plays",), ("plays", 2))}),
    ],
)
def test_relations_that_are_no_names_are_refused(kind, given):
    with pytest.raises(ParameterError, match=r"relations .* no names"):
        kind(**given)
