"""Studies on drawn households: one row for a trial, the same whoever runs it."""

import json

import pytest

from experiments.cli import main
from experiments.docs_tools.many_people import FACTORS, page
from experiments.running.study import Condition, Trial
from experiments.running.trial import configuration
from experiments.studies.drawn import Households, score
from experiments.studies.people import LEARNERS, STUDIES


def small(study):
    """The same households with little experience."""
    households = study.run.keywords["households"]
    return Households(
        family=households.family,
        draw=households.draw,
        decisions=60,
        anew=households.anew,
    )


@pytest.mark.parametrize("name", STUDIES)
def test_a_trial_is_a_function_of_its_record(name):
    study = STUDIES[name]((3,))[0]
    trial = Trial(condition=study.conditions[-1], seed=3)
    one, again = (score(trial, households=small(study)) for _ in range(2))
    assert one.equals(again)
    assert one["greedy"][0] <= 1.0
    assert one["choices"][0] > 0


def test_a_learner_that_learned_nothing_is_near_chance():
    study = STUDIES["strangers"]((0,))[0]
    households = study.run.keywords["households"]
    untrained = Households(family=households.family, draw=households.draw, decisions=0)
    condition = Condition(name="x", scenario="own_norms", learner="designated")
    scores = [
        score(Trial(condition=condition, seed=seed), households=untrained)["greedy"][0]
        for seed in range(6)
    ]
    assert abs(sum(scores) / len(scores)) < 0.2


def test_the_configuration_holds_every_constant_of_the_households():
    plain = configuration(STUDIES["plenty"]((0,))[1])
    assert plain["run"]["households"]["family"]["personas"][0]["mistakes"] == 0.1
    assert len(plain["conditions"]) == len(LEARNERS)


def test_an_unknown_study_is_one_line_with_the_nearest_name(capsys):
    assert main(["study", "actor"]) == 2
    assert "actors" in capsys.readouterr().err


def test_the_page_says_which_learner_comes_out_best():
    estimate = {"value": 0.1, "low": 0.0, "high": 0.2, "n": 3, "method": "x"}
    good = {**estimate, "value": 0.8}

    def findings(levels, factor):
        return [
            {
                "factors": {"learner": learner, factor: level},
                "greedy": good if learner == "views" else estimate,
                "best_constant": estimate,
                "beyond_constant": estimate,
                "touches": estimate,
                "met": estimate,
            }
            for level in levels
            for learner in ("canonical", "views")
        ]

    text = page(
        {
            name: json.loads(json.dumps(findings(("8", "12"), factor)))
            for name, factor in FACTORS.items()
        }
    )
    assert "views comes out best" in text
    assert "0.70 and 0.70" in text
