"""Situations: hashable, free of order, and one canonical form for all swaps."""

import itertools
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from household import household_v0
from household.perception.situation import Situation
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep

ROLES = ("playing", "reading", "calling")
ACTORS = ("ann", "bob", "cat", "dan", "eve")
ROBOTS = ("robot_0", "robot_1")


@st.composite
def situations(draw, most=5):
    """Up to five actors and two robots; anybody may attend to anybody else."""
    names = draw(st.permutations(ACTORS))[: draw(st.integers(1, most))]
    roles = {name: draw(st.sampled_from(ROLES)) for name in names}
    pairs = list(itertools.permutations((*names, *ROBOTS), 2))
    attends = draw(st.sets(st.sampled_from(pairs), max_size=len(pairs)))
    return Situation.of(roles, attends)


def closure(situation):
    """All that can be reached by swapping two actors, again and again."""
    reached, frontier = {situation}, [situation]
    while frontier:
        here = frontier.pop()
        for one, other in itertools.combinations(here.entities, 2):
            there = here.swapped(one, other)
            if there not in reached:
                reached.add(there)
                frontier.append(there)
    return reached


def shuffled(situation, order):
    """The same people called by each other's names."""
    names = dict(zip(situation.entities, order, strict=True))
    return Situation.of(
        {names[actor]: role for actor, role in situation.plays},
        ((names.get(a, a), names.get(b, b)) for a, b in situation.attends),
    )


@settings(max_examples=150, deadline=None)
@given(situations())
def test_the_canonical_form_is_one_and_the_same_all_over_the_closure(situation):
    reached = closure(situation)
    assert {other.canonical() for other in reached} == {situation.canonical()}
    assert situation.canonical() in reached


@settings(max_examples=150, deadline=None)
@given(situations(most=4), situations(most=4))
def test_two_canonical_forms_are_equal_only_within_one_closure(one, other):
    together = other in closure(one)
    assert (one.canonical() == other.canonical()) == together


@settings(max_examples=200, deadline=None)
@given(situations(), st.randoms(use_true_random=False))
def test_a_look_that_moves_is_another_class_unless_swaps_lead_there(situation, chance):
    pairs = sorted(itertools.permutations((*situation.entities, *ROBOTS), 2))
    moved = {chance.choice(pairs), chance.choice(pairs)}
    other = Situation.of(dict(situation.plays), situation.attends ^ moved)
    same = other.canonical() == situation.canonical()
    assert same == (other in closure(situation))


@settings(max_examples=100, deadline=None)
@given(situations(), st.randoms(use_true_random=False))
def test_the_canonical_form_does_not_depend_on_names(situation, chance):
    order = list(situation.entities)
    chance.shuffle(order)
    assert shuffled(situation, order).canonical() == situation.canonical()


@settings(max_examples=100, deadline=None)
@given(situations())
def test_the_canonical_form_is_its_own_canonical_form(situation):
    canonical = situation.canonical()
    assert canonical.canonical() == canonical


@settings(max_examples=100, deadline=None)
@given(situations(), st.data())
def test_swapping_twice_changes_nothing(situation, data):
    one = data.draw(st.sampled_from(situation.entities))
    other = data.draw(st.sampled_from(situation.entities))
    assert situation.swapped(one, other).swapped(one, other) == situation
    assert situation.swapped(one, other) == situation.swapped(other, one)
    assert situation.swapped(one, one) == situation


@settings(max_examples=100, deadline=None)
@given(situations(), st.randoms(use_true_random=False))
def test_the_order_in_which_it_is_told_makes_no_difference(situation, chance):
    roles, pairs = list(situation.plays), sorted(situation.attends)
    chance.shuffle(roles)
    chance.shuffle(pairs)
    again = Situation.of(dict(roles), pairs)
    assert again == situation
    assert hash(again) == hash(situation)
    assert str(again) == str(situation)


@settings(max_examples=100, deadline=None)
@given(situations())
def test_without_an_entity_no_relation_to_it_is_left(situation):
    gone = situation.entities[0]
    rest = situation.without(gone)
    assert gone not in rest.entities
    assert not any(gone in pair for pair in rest.attends)
    assert rest.attends == {p for p in situation.attends if gone not in p}
    assert set(rest.plays) == {p for p in situation.plays if p[0] != gone}


def test_swapping_exchanges_roles_and_looks():
    before = Situation.of(
        {"ann": "reading", "bob": "calling"},
        [("ann", "robot_0"), ("ann", "bob"), ("robot_0", "bob")],
    )
    after = Situation.of(
        {"ann": "calling", "bob": "reading"},
        [("bob", "robot_0"), ("bob", "ann"), ("robot_0", "ann")],
    )
    assert before.swapped("ann", "bob") == after
    assert before.canonical() == after.canonical()


def test_removing_a_robot_keeps_the_actors():
    before = Situation.of({"ann": "reading"}, [("ann", "robot_0")])
    assert before.without("robot_0") == Situation.of({"ann": "reading"})


def test_two_circles_of_looks_are_not_one_though_everybody_looks_once():
    """Six who look round in a ring, or in two rings of three: alike one by one."""
    six = dict.fromkeys("abcdef", "playing")
    ring = Situation.of(six, ["ab", "bc", "cd", "de", "ef", "fa"])
    two = Situation.of(six, ["ab", "bc", "ca", "de", "ef", "fd"])
    pairs = [frozenset(tuple(pair) for pair in s.attends) for s in (ring, two)]
    ring, two = (Situation.of(six, p) for p in pairs)
    assert ring.canonical() != two.canonical()
    renamed = ring.swapped("a", "d").swapped("b", "c")
    assert renamed.canonical() == ring.canonical()


@pytest.mark.parametrize("n", [1, 8, 64])
def test_many_who_are_all_alike_have_a_canonical_form_at_once(n):
    roles = {f"person_{i:02}": "reading" for i in range(n)}
    looks = [(name, "robot_0") for name in roles]
    situation = Situation.of(roles, looks)
    assert situation.canonical() == situation


@pytest.mark.parametrize("n", [12, 64])
def test_many_who_talk_in_pairs_have_a_canonical_form_without_trying_every_order(n):
    """Renamed at random it is the same: 32 pairs could be put in 32! orders."""
    names = [f"person_{i:02}" for i in range(n)]
    pairs = [
        p
        for a, b in zip(names[::2], names[1::2], strict=True)
        for p in ((a, b), (b, a))
    ]
    situation = Situation.of(dict.fromkeys(names, "reading"), pairs)
    order = random.Random(1).sample(names, n)
    assert shuffled(situation, order) != situation
    assert shuffled(situation, order).canonical() == situation.canonical()


@pytest.mark.parametrize("n", [8, 16])
def test_all_who_look_at_all_have_a_canonical_form_without_trying_every_order(n):
    names = [f"person_{i:02}" for i in range(n)]
    situation = Situation.of(
        dict.fromkeys(names, "reading"), itertools.permutations(names, 2)
    )
    assert situation.canonical() == situation


def test_a_situation_is_a_key_and_cannot_be_changed():
    situation = Situation.of({"ann": "reading"})
    assert {situation: 1}[Situation.of({"ann": "reading"})] == 1
    with pytest.raises(AttributeError):
        situation.plays = ()


def test_the_scenario_says_which_relations_a_situation_holds(household_of):
    """Ann looks at the robot before her, and the robot at her; Bob at Ann."""

    def person(name, place, at):
        step = ScriptStep(place=place, duration=(900.0, 900.0), look_at=at)
        return PersonSpec(name=name, persona="paper_actor", script=(step,))

    looks = {}
    for relations in ("none", "robot", "all"):
        env = household_v0.parallel_env(
            household_of(
                people=(person("ann", "phone", "robot_0"), person("bob", "rug", "ann")),
                robots=(RobotSpec(position=(2.0, 2.5), heading=180.0),),
                situation={"attention": relations},
            )
        )
        env.reset(seed=1)
        situation = env.situation("robot_0")
        assert situation.plays == (("ann", "calling"), ("bob", "playing"))
        looks[relations] = situation.attends
    assert looks["none"] == frozenset()
    assert looks["robot"] == {("ann", "robot_0")}
    assert looks["all"] >= {("ann", "robot_0"), ("robot_0", "ann")}
    assert ("bob", "robot_0") not in looks["all"]


def test_each_robot_sees_the_situation_from_its_own_point_of_view(household_of):
    step = ScriptStep(place="phone", duration=(900.0, 900.0), look_at="robot_1")
    ann = PersonSpec(name="ann", persona="paper_actor", script=(step,))
    env = household_v0.parallel_env(
        household_of(
            people=(ann,),
            robots=(RobotSpec(position=(7.5, 4.5)), RobotSpec(position=(1.0, 1.5))),
        )
    )
    env.reset(seed=1)
    assert env.situation("robot_0").attends == frozenset()
    assert env.situation("robot_1").attends == {("ann", "robot_1")}
