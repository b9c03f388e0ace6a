import numpy as np
import polars as pl
import pytest

from experiments.analysis import measures
from experiments.analysis.target_situations import TargetSituation
from experiments.running.trial_columns import key_of
from household.perception.situation import Situation

PLAYING = Situation.of({"ann": "playing"})
CALLING = Situation.of({"ann": "calling"})
PLAY, CALL = key_of(PLAYING), key_of(CALLING)


def entries(*behaviors, wanted=1.0):
    return [(PLAYING, behavior, wanted) for behavior in behaviors]


def learned(play, bark, n):
    """Updates in the last of n entries that set the final Q-values."""
    last = [
        {"situation": PLAY, "behavior": "play", "value": play},
        {"situation": PLAY, "behavior": "bark", "value": bark},
    ]
    return [[]] * (n - 1) + [last]


def test_the_last_quarter_is_rounded_up(table):
    assert len(measures.last_quarter(table(entries(*["play"] * 9)))) == 3


def test_appropriate_is_what_is_wanted_most_at_that_time(table):
    frame = table(
        [(PLAYING, "play", 1.0), (PLAYING, "bark", 1.0), (PLAYING, "bark", -0.5)]
    )
    assert measures.appropriate(frame).tolist() == [True, False, True]


def test_where_all_is_wanted_equally_all_is_appropriate(table):
    assert measures.appropriate(table(entries("play", "bark", wanted=0.0))).all()


def test_a_situation_converges_with_nine_of_the_last_ten_right_and_q_in_order(table):
    behaviors = ["bark"] * 30 + ["bark"] + ["play"] * 9
    frame = table(entries(*behaviors), updates=learned(0.5, 0.1, 40))
    assert measures.converged(frame, PLAY)


def test_eight_of_the_last_ten_are_not_enough(table):
    behaviors = ["play"] * 30 + ["bark"] * 2 + ["play"] * 8
    frame = table(entries(*behaviors), updates=learned(0.5, 0.1, 40))
    assert not measures.converged(frame, PLAY)
    assert not measures.masters(frame, PLAY)


@pytest.mark.parametrize("bark", [0.5, 0.6])
def test_right_choices_without_the_highest_value_are_not_enough(table, bark):
    frame = table(entries(*["play"] * 40), updates=learned(0.5, bark, 40))
    assert not measures.converged(frame, PLAY)
    assert measures.masters(frame, PLAY)


def test_a_situation_that_never_was_is_not_converged(table):
    assert not measures.masters(table(entries("play")), CALL)
    assert not measures.converged(table(entries("play")), CALL)
    assert not measures.converged(table(entries("play")), None)


def test_only_choices_count_not_behaviors_that_went_on(table):
    frame = table(entries("play", "bark"), chosen=[True, False])
    assert measures.decisions(frame, PLAY)["behavior"].to_list() == ["play"]


def test_a_q_curve_begins_where_its_situation_was_first_met(table):
    frame = table(
        [(CALLING, "play", 1.0), (PLAYING, "play", 1.0), (PLAYING, "bark", 1.0)],
        q=[
            {"bark": 0.0, "play": 0.0},
            {"bark": 0.0, "play": 0.25},
            {"bark": 0, "play": 0},
        ],
        updates=[
            [],
            [{"situation": PLAY, "behavior": "play", "value": 0.5}],
            [{"situation": CALL, "behavior": "play", "value": 9.0}],
        ],
    )
    times, values = measures.q_curve(frame, PLAY, "play")
    assert times.tolist() == [2.0, 4.0]
    assert values.tolist() == [0.25, 0.5]
    assert measures.final_q(frame, PLAY) == {"bark": 0.0, "play": 0.5}
    assert measures.final_q(frame, "nowhere") == {}


@pytest.mark.parametrize(
    ("values", "fall"),
    [
        ([0.0, 0.8, 0.2], 0.75),
        ([0.0, 0.8], 0.0),
        ([-0.5, -0.1], 0.0),
        ([0.4, -0.4], 2.0),
    ],
)
def test_a_fall_is_relative_to_the_peak_and_needs_one(values, fall):
    assert measures.fall_from_peak(np.array(values)) == pytest.approx(fall)


def test_alternating_needs_each_behavior_in_a_tenth_of_the_last_choices(table):
    early = ["bark"] * 30
    nine_to_one = table(entries(*early, *["play"] * 9, "bark"))
    assert measures.keeps_alternating(nine_to_one, PLAY)
    assert not measures.keeps_alternating(table(entries(*early, *["play"] * 10)), PLAY)
    assert not measures.keeps_alternating(nine_to_one, None)


def test_a_target_situation_is_the_most_frequent_one_that_fits(table):
    alone = Situation.of({"bob": "playing"})
    seen = Situation.of({"bob": "playing"}, [("bob", "robot_0")])
    frame = table(
        [(Situation.of({"bob": "unknown"}), "play", 1.0)] * 5
        + [(alone, "play", 1.0)] * 3
        + [(seen, "play", 1.0)] * 2
    )
    play = TargetSituation(name="PLAY", role="playing")
    assert play.find(frame) == key_of(alone)
    assert TargetSituation(name="PLAY", role="play").find(frame) is None
    watched = TargetSituation(name="S11", role="playing", attended=True)
    assert watched.find(frame) == key_of(seen)
    ignored = TargetSituation(name="S51", role="playing", attended=False)
    assert ignored.find(frame) == key_of(alone)


def test_a_person_who_is_called_like_a_role_does_not_play_it(table):
    frame = table([(Situation.of({"playing": "calling"}), "play", 1.0)])
    assert TargetSituation(name="PLAY", role="playing").find(frame) is None


@pytest.mark.parametrize("attended", [None, True, False])
def test_a_target_situation_fits_what_it_finds_and_nothing_else(table, attended):
    target = TargetSituation(name="PLAY", role="playing", attended=attended)
    for attends in ([], [("bob", "robot_0")]):
        for role in ("playing", "calling"):
            one = Situation.of({"bob": role}, attends)
            found = target.find(table([(one, "play", 1.0)]))
            assert found == (key_of(one) if target(one) else None)


def study(table, rewards):
    return pl.concat(
        table(entries("play"), reward=[reward]).select(
            pl.lit(name).alias("condition"), pl.lit(seed).alias("seed"), pl.all()
        )
        for name in ("a", "b")
        for seed, reward in rewards.items()
    )


@pytest.mark.parametrize(
    ("rewards", "typical"),
    [
        ({0: 5.0, 1: 1.0, 2: 3.0}, 2),
        ({0: 5.0, 1: 1.0, 2: 3.0, 3: 4.0}, 2),  # 3 and 4 tie: the lower seed
        ({4: 2.0, 7: 2.0, 9: 2.0}, 4),
    ],
)
def test_the_typical_seed_has_the_median_reward(table, rewards, typical):
    assert measures.typical_seed(study(table, rewards), "a") == typical


def test_a_measure_per_seed_comes_in_the_order_of_the_seeds(table):
    frame = study(table, {2: 5.0, 0: 1.0, 1: 3.0})
    rewards = measures.per_seed(frame, "b", measures.final_reward)
    assert rewards.tolist() == [1.0, 3.0, 5.0]
