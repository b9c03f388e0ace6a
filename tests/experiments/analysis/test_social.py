import math

import pytest

from experiments.analysis import measures, social
from experiments.running.trial_columns import key_of
from household.perception.situation import Situation

PLAYING, CALLING, WORKING = (
    Situation.of({"ann": role}) for role in ("playing", "calling", "working")
)
PLAY, CALL = key_of(PLAYING), key_of(CALLING)


def entries(*behaviors):
    return [(PLAYING, behavior, 1.0) for behavior in behaviors]


def update(value, behavior="play", situation=PLAY):
    return [{"situation": situation, "behavior": behavior, "value": value}]


def q(play):
    return {"bark": 0.0, "play": play}


def touch(time=1.0, value=-1.0, cause=(PLAY, "bark"), credited=(PLAY, "bark")):
    return {
        "time": time,
        "giver": "ann",
        "value": value,
        "attending": True,
        "cause_robot": "robot_0",
        "cause_bout": 0,
        "cause_situation": cause[0],
        "cause_behavior": cause[1],
        "credited_bout": 0,
        "credited_situation": credited[0],
        "credited_behavior": credited[1],
    }


@pytest.mark.parametrize(
    ("behaviors", "after"),
    [
        (["play"] * 4, 0),
        (["bark", "bark", "play", "play"], 2),
        (["bark"] + ["play"] * 9, 0),  # nine of ten are enough from the start
        (["bark"] * 2 + ["play"] * 9, 1),
        (["play", "play", "bark"], 3),  # never
        ([], 0),
    ],
)
def test_settling_takes_until_nine_of_ten_that_follow_are_right(
    table, behaviors, after
):
    assert social.settled_after(table(entries(*behaviors)), PLAY) == after


def test_wrong_choices_are_counted_among_the_first_ten(table):
    behaviors = ["bark", "play"] * 4 + ["bark", "bark"] + ["bark"] * 5
    assert social.wrong_among_first(table(entries(*behaviors)), PLAY) == 6.0
    assert math.isnan(social.wrong_among_first(table(entries(*behaviors[:9])), PLAY))


@pytest.mark.parametrize(
    ("behaviors", "after"),
    [
        (["play"] * 5, 0),
        (["bark", "play", "bark"] + ["play"] * 6, 3),
        (["play"] * 4 + ["bark"] + ["play"] * 4, 9),  # never
        ([], 0),
    ],
)
def test_the_first_run_is_of_five_right_ones(table, behaviors, after):
    assert social.first_run(table(entries(*behaviors)), PLAY) == after


def test_what_a_learner_knows_shows_in_its_greedy_choice_and_in_the_order_of_q(table):
    knows = table(entries(*["bark"] * 4), q=[q(0.5)] * 4)
    errs = table(entries(*["play"] * 4), q=[q(-0.5)] * 4)
    blank = table(entries(*["play"] * 4), q=[q(0.0)] * 4)
    found = [social.greedy_right(trial, PLAY) for trial in (knows, errs, blank)]
    assert found == [1.0, 0.0, 0.5]
    assert [social.ordered(trial, PLAY) for trial in (knows, errs, blank)] == [
        True,
        False,
        False,
    ]
    assert math.isnan(social.greedy_right(knows, CALL))
    assert not social.ordered(knows, CALL)


def test_the_right_share_is_that_of_the_last_quarter(table):
    frame = table(entries(*["bark"] * 6, "play", "bark"))
    assert social.right_share(frame, PLAY) == 0.5
    assert math.isnan(social.right_share(frame, CALL))


def test_silent_loss_counts_untouched_choices_at_a_positive_value(table):
    frame = table(
        entries("play", "play", "play", "bark", "play"),
        q=[q(0.8), q(0.6), q(0.5), q(0.5), q(-0.2)],
        updates=[update(0.6), update(0.5), update(0.1), update(0.4), update(-0.1)],
        touches=[[], [], [touch()], [], []],
    )
    # (0.8 - 0.6 + 0.6 - 0.5) / (0.8 + 0.6)
    assert social.silent_loss(frame, PLAY, "play") == pytest.approx(0.3 / 1.4)


def test_a_value_that_silence_does_not_move_loses_nothing(table):
    frame = table(entries("play"), q=[q(0.5)])
    assert social.silent_loss(frame, PLAY, "play") == 0.0


def test_without_a_value_to_lose_the_loss_is_not_known(table):
    assert math.isnan(social.silent_loss(table(entries("play")), PLAY, "play"))


def test_the_pull_is_compared_between_the_halves_of_the_touched_entries(table):
    frame = table(
        entries("play", "play", "play", "play"),
        q=[q(0.0), q(0.5), q(0.4), q(0.7)],
        updates=[update(0.5), update(0.4), update(0.7), update(0.5)],
        touches=[[touch()], [], [touch()], [touch(), touch()]],
    )
    # 0.5 in the first half; 0.3 and, of two touches, 0.2 / 2 in the second
    assert social.pull_fades(frame) == pytest.approx(0.5 - 0.2)


def test_one_touch_tells_nothing_of_how_its_pull_fades(table):
    frame = table(entries("play"), touches=[[touch()]])
    assert math.isnan(social.pull_fades(frame))


def test_an_update_of_another_pair_is_not_an_entrys_own(table):
    other = update(0.9, behavior="bark") + update(0.9, situation=CALL)
    before, after = social.own_values(
        table(entries("play"), q=[q(0.2)], updates=[other])
    )
    assert before.tolist() == after.tolist() == [0.2]


def test_credit_is_right_if_situation_and_behavior_are_the_true_ones(table):
    felt = [
        touch(cause=(CALL, "play"), credited=(CALL, "play")),
        touch(cause=(CALL, "play"), credited=(PLAY, "play")),
        touch(cause=(CALL, "play"), credited=(CALL, "bark")),
        touch(cause=(CALL, "play"), credited=(None, None)),
        touch(),
    ]
    frame = table(entries("play"), touches=[felt])
    assert social.credit_accuracy(frame) == pytest.approx(2 / 5)
    assert social.credit_accuracy(frame, CALL) == pytest.approx(1 / 4)
    assert math.isnan(social.credit_accuracy(frame, key_of(WORKING)))


def test_the_positive_share_is_that_of_the_touches_within_the_times(table):
    felt = [touch(1.0, 0.5), touch(2.0, -0.5), touch(3.0, 0.5), touch(4.0, 0.1)]
    frame = table(entries("play"), touches=[felt])
    assert social.positive_share(frame, 0.0, 3.0) == 0.5
    assert social.positive_share(frame, 3.0, math.inf) == 1.0
    assert math.isnan(social.positive_share(frame, 5.0, math.inf))


def test_only_situations_with_enough_decisions_count_as_learned_or_not(table):
    learned = [(CALLING, "play", 1.0)] * 8
    frame = table(
        learned + entries(*["bark"] * 8) + [(WORKING, "play", 1.0)] * 7,
        updates=[update(0.5, situation=CALL)] + [[]] * 22,
    )
    assert measures.learned_share(frame) == 0.5
    assert math.isnan(measures.learned_share(frame, least=9))
