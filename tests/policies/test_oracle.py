"""Bounds are told what only the simulator knows; nobody else is."""

import numpy as np
import pytest

from experiments.running.study import Condition, Trial
from experiments.running.trial import play
from learners.baselines.bounds import Oracle
from learners.catalog import CATALOG

BOUNDS = [name for name, recipe in CATALOG.items() if recipe.needs]


def trained(learner, scenario="experiment_4", cycles=400, **overrides):
    """The robots of a short trial."""
    condition = Condition(
        name="bound",
        scenario=scenario,
        learner=learner,
        scenario_overrides={"max_cycles": cycles, **overrides},
    )
    return play(Trial(condition=condition, seed=3))


@pytest.mark.parametrize("learner", BOUNDS)
def test_every_bound_lives_through_a_household(learner):
    assert trained(learner, "evening", 120).keys() == {"robot_0", "robot_1"}


def test_credit_by_an_oracle_goes_to_what_was_judged():
    learner = trained("oracle_credit")["robot_0"].learner
    states = {str(state): state for state in learner.table}
    play_, sleep = learner.q_values(states["actor playing, actor > robot_0"])
    assert play_ > sleep
    play_, sleep = learner.q_values(states["actor calling"])
    assert play_ < sleep <= 0.1


def test_oracles_of_persons_and_of_the_average_agree_where_all_share_the_norms():
    persona, population = (
        trained(name, "evening", 60, heterogeneity=0.0)["robot_0"].learner
        for name in ("persona_oracle", "population_oracle")
    )
    assert isinstance(persona, Oracle)
    np.testing.assert_allclose(persona.q_values("now"), population.q_values("now"))


def test_where_tastes_differ_the_average_person_is_somebody_else():
    persona, population = (
        trained(name, "evening", 60, heterogeneity=0.8)["robot_0"].learner
        for name in ("persona_oracle", "population_oracle")
    )
    assert not np.allclose(persona.q_values("now"), population.q_values("now"))
