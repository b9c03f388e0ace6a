"""Trials with phases are pure functions of their record."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.errors import ExperimentError
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.trial import describe_phases, describe_training, run, train
from experiments.phases.world import Residence, World, household
from experiments.running.study import Trial
from household.people.person import everyone_of
from learners import make_learner

VIEWS = {"representation": "audible_views", "counts": "exposures"}
WORLD = World(people=2)


def condition(learner="full_sharing", overrides=VIEWS, world=WORLD, **probing):
    wanted = {"new": ("people",), "split": "validation", "households": 1} | probing
    return Phases(
        name="a",
        learner=learner,
        learner_overrides=overrides,
        training=Training(world=world, households=2, decisions=200),
        probing=Probing(world=world, **wanted),
    )


def trial(*arguments, seed=3, **settings):
    return Trial(condition=condition(*arguments, **settings), seed=seed)


def own_learner(n_behaviors, rng, **settings):
    """A learner that is not in the catalog."""
    return make_learner("designated", n_behaviors, rng, **settings)


def own_policy(observation, agent):
    """A policy of somebody's own."""
    return 1


def test_the_same_record_gives_the_same_table():
    one = trial(touches=(0, 2), lived=50)
    assert run(one).equals(run(one))


def test_it_makes_no_difference_whether_the_first_phase_was_stored():
    one = trial(touches=(0, 2))
    assert run(one, train(one)).equals(run(one))


def test_another_seed_meets_other_people():
    assert run(trial())["people"][0] != run(trial(seed=4))["people"][0]


def test_each_number_of_touches_has_its_row_and_was_felt():
    table = run(trial(touches=(0, 1, 3)))
    assert table["touches"].to_list() == [0, 1, 3]
    assert (table["felt"] >= table["touches"]).all()
    assert (table["greedy"] <= 1.0).all()


def test_where_too_few_touches_come_it_says_how_many_were_felt():
    table = run(trial(touches=(0, 50), decisions=60))
    assert table["felt"][1] < 50


def test_only_the_last_row_of_a_household_is_lived():
    table = run(trial(touches=(0, 2), lived=50))
    assert table["verdicts_per_minute"].is_null().to_list() == [True, False]


def test_who_knows_everybody_is_right_and_who_draws_is_not():
    knows, draws = (run(trial(name, {})) for name in ("persona", "random"))
    assert knows["greedy"][0] == 1.0
    assert abs(draws["greedy"][0]) < 0.3
    assert knows["best_constant"][0] == draws["best_constant"][0]


def test_what_was_learned_in_many_households_serves_strangers():
    scores = [
        run(
            Trial(
                condition=replace(
                    condition(households=2),
                    training=Training(world=WORLD, households=3, decisions=1_000),
                ),
                seed=seed,
            )
        )["greedy"].mean()
        for seed in range(3)
    ]
    assert np.mean(scores) > 0.3


def test_learners_and_policies_of_ones_own_are_named_by_module(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "mine", sys.modules[__name__])
    learned = run(trial("mine:own_learner", {}))
    same = run(trial("designated", {}))
    assert learned["greedy"][0] == same["greedy"][0]
    constant = run(trial("act:mine:own_policy", {}))
    assert constant["greedy"][0] == run(trial("constant:play", {}))["greedy"][0]


def test_an_own_learner_that_is_not_there_is_one_line():
    with pytest.raises(ExperimentError, match="learner nowhere:none"):
        run(trial("nowhere:none", {}))


def test_several_robots_learn_and_share():
    two = World(people=2, robots=2)
    apart = trial(world=two)
    shared = replace(apart, condition=replace(apart.condition, sharing="shared"))
    tables = [run(one, train(one)) for one in (apart, shared)]
    assert tables[0]["greedy"][0] != tables[1]["greedy"][0]
    assert tables[1].equals(run(shared))


def test_people_who_are_opposed_agree_in_no_role():
    world = World(people=2, days=True, opposed=True)
    residence = Residence(world=world, home=3, people=(4, 7), roles=((1, 2),))
    one, other = everyone_of(household(residence, 10).scenario)
    liked = [each.preferences.argmax(axis=2) for each in (one, other)]
    assert (liked[0] != liked[1]).all()


def test_a_changed_constant_is_a_changed_description_and_probing_is_none_of_training():
    one = condition()
    other = replace(one, probing=replace(one.probing, world=World(people=2, robots=2)))
    assert describe_phases(one) != describe_phases(other)
    assert describe_training(one) == describe_training(other)
    warmer = replace(one, learner_overrides={**VIEWS, "horizon": 7.0})
    assert describe_training(one) != describe_training(warmer)


def test_touches_must_rise():
    with pytest.raises(ExperimentError, match="must rise"):
        Probing(touches=(5, 2))


def test_the_reference_that_looks_ahead_lives_in_the_household_that_it_looks_into():
    frame = run(trial("lookahead", {}, lived=20, touches=(0,)))
    assert frame["verdicts_per_minute"].is_not_null().all()
    assert frame["greedy"].is_nan().all()
