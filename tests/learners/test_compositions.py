"""All of the catalog composes with every representation and pooling, and is saved."""

import numpy as np
import pytest

from learners import CATALOG, load, make_learner
from learners.components import COMPONENTS, made
from learners.errors import ParameterError
from learners.saving import encode

LEARNERS = [name for name in CATALOG if name != "designated_adaptive"]
PEOPLE = {
    "marked": {"ann", "bob"},
    "views": {"ann", "bob"},
    "audible_views": {"ann"},  # who attends, and nothing is said of hearing
    "nested_views": {"ann"},
    "person_views": {"ann", "bob"},
}
"""Whose rows a representation keeps apart."""
POOLINGS = ("none", "full", "hierarchical", "adaptive")


def goes_on_as_saved(learner, live, world, path):
    live(learner, 60, np.random.default_rng(2))
    learner.save(path)
    twin = load(path, **world)
    ends = learner.history.entries[-1].next_time
    ways = [
        live(each, 60, np.random.default_rng(3), start=ends) for each in (learner, twin)
    ]
    assert ways[0] == ways[1]
    assert encode(learner) == encode(twin)


@pytest.mark.parametrize("pooling", POOLINGS)
@pytest.mark.parametrize("name", LEARNERS)
def test_every_learner_learns_by_views_with_every_pooling(
    name, pooling, live, attached, tmp_path
):
    world, settings = attached(name), {"representation": "views", "pooling": pooling}
    if name == "hierarchical_thompson":  # which asks for a posterior
        settings |= {"exploration": "softmax"}
    rng = np.random.default_rng(1)
    learner = make_learner(name, 3, rng, **world, **made(settings))
    goes_on_as_saved(learner, live, world, tmp_path / "learner.json")


@pytest.mark.parametrize("representation", COMPONENTS["representation"])
@pytest.mark.parametrize(
    "name", ["q_social", "q_trace", "designated", "travel_posterior", "views", "tamer"]
)
def test_every_representation_is_learned_and_saved(
    name, representation, live, tmp_path
):
    settings = made({"representation": representation})
    learner = make_learner(name, 3, np.random.default_rng(1), **settings)
    goes_on_as_saved(learner, live, {}, tmp_path / "learner.json")
    assert len(learner.table) > 0
    if representation in PEOPLE:
        assert {person for _, person in learner.table} == PEOPLE[representation]


@pytest.mark.parametrize("analogy", ["swap", "swap_remove", "remove"])
@pytest.mark.parametrize("representation", COMPONENTS["representation"])
def test_operators_carry_over_in_every_representation(
    analogy, representation, live, tmp_path
):
    settings = made({"representation": representation, "analogy": analogy})
    rng = np.random.default_rng(1)
    learner = make_learner("designated", 3, rng, **settings)
    goes_on_as_saved(learner, live, {}, tmp_path / "learner.json")


@pytest.mark.parametrize("name", ["q_social", "q_trace", "views", "tamer", "i_sabl"])
def test_what_people_like_is_learned_whatever_the_composition(name, live):
    for representation in ("canonical", "nameless", "views", "person_views"):
        settings = made({"representation": representation, "pooling": "hierarchical"})
        learner = make_learner(name, 3, np.random.default_rng(1), **settings)
        chosen = live(learner, 400, np.random.default_rng(2))
        assert chosen[-200:].count(1) > 110, representation  # live: they like 1


def test_adaptive_analogy_is_between_situations_by_name(rng):
    with pytest.raises(ParameterError, match="with Views, people are pooled"):
        make_learner("designated_adaptive", 3, rng, **made({"representation": "views"}))
