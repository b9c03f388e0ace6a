"""Trials with phases whose learner is a network (extra `deep`)."""

import pytest

pytest.importorskip("torch", reason="needs the extra `deep` (not in CI)")
pytest.importorskip("stable_baselines3", reason="needs the extra `deep` (not in CI)")

from dataclasses import replace

from experiments.generalization import deep, suite
from experiments.generalization.learners import NETWORKS, settings
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.trial import run
from experiments.phases.world import World
from experiments.running.study import Trial

WORLD = World(people=2)


@pytest.mark.parametrize("name", NETWORKS)
def test_a_trial_with_a_network_is_a_function_of_its_record(name):
    learner, tuned = settings([name])[name]
    condition = Phases(
        name="a",
        learner=learner,
        learner_overrides=tuned,
        training=Training(world=WORLD, households=2, decisions=400),
        probing=Probing(
            world=WORLD,
            new=("people",),
            split="validation",
            households=1,
            touches=(0, 2),
            lived=40,
        ),
    )
    one, again = (run(Trial(condition=condition, seed=1)) for _ in range(2))
    assert one.equals(again)
    assert one["touches"].to_list() == [0, 2]
    assert one["trained_choices"][0] > 0
    other = run(Trial(condition=condition, seed=2))
    assert not other["greedy"].equals(one["greedy"])


@pytest.mark.parametrize("name", NETWORKS)
@pytest.mark.parametrize(
    ("inquiry", "level"),
    [(suite.INQUIRY, {"family": "party"}), (deep.INQUIRY, {"budget": "plenty"})],
    ids=["suite", "deep"],
)
def test_a_network_runs_on_the_leaderboard(inquiry, level, name):
    condition = next(
        each
        for each in inquiry.conditions
        if each.factors == {"learner": name, **level}
    )
    short = replace(
        condition,
        training=replace(condition.training, households=1, decisions=100),
        probing=replace(
            condition.probing, split="validation", touches=(0, 1), decisions=60, lived=0
        ),
    )
    found = run(Trial(condition=short, seed=0))
    assert found["greedy"].is_between(-5.0, 1.0).all()
    assert found["trained_choices"][0] > 0
