"""Household situations keep the promises that analogy asks of a state."""

from hypothesis import given, settings
from hypothesis import strategies as st

from household.perception.situation import Situation
from learners.analogy.carrying import Propagation
from learners.representation.states import is_state

NAMES = ("ann", "bob", "eve", "joe")
ROLES = ("reading", "calling", "playing")


@st.composite
def situations(draw, n):
    people = NAMES[:n]
    pairs = [(a, b) for a in people for b in (*people, "robot") if a != b]
    robots = [(name, "robot") for name in people]
    return Situation.of(
        {name: draw(st.sampled_from(ROLES)) for name in people},
        draw(st.lists(st.sampled_from(pairs), max_size=5, unique=True)),
        draw(st.sets(st.sampled_from(robots))),
        draw(st.sets(st.sampled_from(robots))),
    )


def closure(state):
    analogy = Propagation(depth=max(len(state.entities) - 1, 1))
    return {analog for analog, _ in analogy.spread(state)}


@settings(deadline=None, max_examples=100)
@given(data=st.data(), n=st.integers(1, 4))
def test_the_canonical_situation_stands_for_the_closure_under_swaps(data, n):
    one, other = (data.draw(situations(n)) for _ in range(2))
    assert is_state(one)
    assert {state.canonical() for state in closure(one)} == {one.canonical()}
    assert (other in closure(one)) == (other.canonical() == one.canonical())


@settings(deadline=None, max_examples=50)
@given(data=st.data(), n=st.integers(2, 4))
def test_swapping_twice_changes_nothing_and_leaving_takes_all_relations(data, n):
    state = data.draw(situations(n))
    assert state.swapped("ann", "bob").swapped("ann", "bob") == state
    left = state.without("bob")
    assert "bob" not in left.entities
    assert "bob" not in {each for pair in left.attends for each in pair}


@settings(deadline=None, max_examples=50)
@given(data=st.data(), n=st.integers(1, 4))
def test_a_view_is_what_is_left_when_all_others_are_removed(data, n):
    state = data.draw(situations(n))
    for name, view in state.views():
        alone = state
        for other in set(state.entities) - {name}:
            alone = alone.without(other)
        assert alone.views() == ((name, view),)
        assert dict(alone.plays)[name] == dict(view)["plays"]
        assert (("near", "robot") in view) == ((name, "robot") in state.near)
        assert (("hears", "robot") in view) == ((name, "robot") in state.hears)


@settings(deadline=None, max_examples=50)
@given(data=st.data(), n=st.integers(1, 4))
def test_without_names_strangers_in_the_same_roles_are_the_same(data, n):
    one, other = data.draw(situations(n)), data.draw(situations(n))
    strangers = dict(zip(one.entities, ("xan", "yve", "zoe", "kim"), strict=False))
    renamed = one
    for name, stranger in strangers.items():
        renamed = renamed.swapped(name, stranger)
    assert renamed.without_names() == one.without_names()
    alike = one.canonical() == other.canonical()
    assert (one.without_names() == other.without_names()) == alike
