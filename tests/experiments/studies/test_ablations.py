"""Ablations part two ideas, and say what each adds."""

import polars as pl
import pytest

from experiments.running.study import Trial
from experiments.running.trial import make_home, make_learner_of
from experiments.studies.ablations import ABLATIONS, OUTCOMES, RATES, run_ablated
from learners.baselines.skip_silence import SkipSilence
from learners.tabular.rates import AsynchronousRate, SocialRate

KINDS = dict(zip(RATES, (AsynchronousRate, SocialRate), strict=True))


@pytest.fixture(params=ABLATIONS.values(), ids=ABLATIONS.keys())
def ablation(request):
    return request.param


def test_every_pair_of_levels_is_there_once(ablation):
    first, second = ablation.factors.values()
    pairs = [tuple(one.factors.values()) for one in ablation.conditions]
    assert pairs == [(one, other) for one in first for other in second]


def test_conditions_are_what_their_levels_say(ablation):
    for condition in ablation.conditions:
        learner, levels = make_learner_of(condition), condition.factors
        assert type(learner.rate) is KINDS[levels["rate"]]
        if "situation" in levels:
            attention = make_home(condition).scenario.situation.attention
            assert (attention == "none") == (levels["situation"] == "roles")
        else:
            skips = isinstance(learner, SkipSilence)
            assert skips == (levels["silence_teaches"] == "nothing")


def test_a_trial_is_kept_as_three_outcomes():
    condition = ABLATIONS["rate_representation"].conditions[0]
    (row,) = run_ablated(Trial(condition=condition, seed=0)).to_dicts()
    assert row.keys() == OUTCOMES.keys()
    assert 0.0 <= row["right"] <= 1.0
    assert row["reward"] != 0.0


def test_effects_are_differences_of_the_four_means():
    ablation = ABLATIONS["rate_representation"]
    # Without both 1, with the first 3, with the second 4, with both 10.
    means = dict(zip((c.name for c in ablation.conditions), (1, 4, 3, 10), strict=True))
    frame = pl.DataFrame(
        [
            {**condition.factors, "seed": seed, "reward": means[condition.name] + seed}
            for condition in ablation.conditions
            for seed in range(5)
        ]
    )
    found = ablation.effects(frame, "reward")
    values = {name: estimate.value for name, estimate in found.items()}
    assert values == {"rate": 4.0, "situation": 5.0, "rate x situation": 4.0}
    assert ablation.estimate(frame, "reward", "social", "roles").value == 5.0
