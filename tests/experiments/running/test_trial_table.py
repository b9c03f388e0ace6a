from dataclasses import replace

import polars as pl
import pytest

from experiments.analysis.measures import touches
from experiments.running.study import Condition, Trial
from experiments.running.trial_columns import key_of, schema
from experiments.running.trial_table import TrialTable
from household.perception.situation import Situation
from learners.learner import Credit
from policies.learning import LearningRobot, run_episode

PLAY = Situation.of({"ann": "playing"})


@pytest.fixture
def trial():
    condition = Condition(name="a", scenario="toy", learner="q_asynchronous")
    return Trial(condition=condition, seed=5)


def test_a_table_has_exactly_the_documented_columns(play_trial, trial):
    frame = play_trial(trial)
    assert frame.schema == schema(("bark", "play"))
    assert set(frame.columns) == set(schema(()).names())


def test_entries_follow_one_another_without_gap_until_the_end(play_trial, trial):
    frame = play_trial(trial, steps=101)
    assert frame["time"].to_list() == [2.0 * n for n in range(51)]
    assert frame["next_time"].to_list()[:-1] == frame["time"].to_list()[1:]
    assert frame["next_time"][-1] == 101.0


def test_the_cumulative_reward_is_the_sum_of_all_touches(play_trial, trial):
    frame = play_trial(trial)
    felt = touches(frame)
    assert len(felt) > 20
    assert frame["cumulative"][-1] == pytest.approx(felt["value"].sum())
    assert frame["cumulative"].to_list() == pytest.approx(
        frame["reward"].cum_sum().to_list()
    )


def test_each_touch_knows_the_bout_that_it_is_truly_about(play_trial, trial):
    felt = touches(play_trial(trial))
    assert (felt["cause_bout"] == felt["time"] - 2).all()
    taps = felt.filter(pl.col("value") < 0)
    assert set(taps["cause_behavior"]) == {"bark"}
    assert set(felt["cause_situation"]) == {key_of(PLAY)}


def test_immediate_credit_of_a_prompt_touch_hits_the_true_bout(play_trial, trial):
    felt = touches(play_trial(trial))
    assert (felt["credited_bout"] == felt["cause_bout"]).all()
    assert (felt["credited_behavior"] == felt["cause_behavior"]).all()


def test_updates_lead_from_each_rows_values_to_the_next_ones(play_trial, trial):
    frame = play_trial(trial)
    values = dict(frame["q"][0])
    for row in frame.iter_rows(named=True):
        assert values == row["q"]
        values |= {u["behavior"]: u["value"] for u in row["updates"]}
    assert values["play"] != 0.0


def test_the_same_seed_gives_the_same_table(play_trial, trial):
    assert play_trial(trial).equals(play_trial(trial))


def test_a_table_survives_the_disk(play_trial, trial, tmp_path):
    frame = play_trial(trial)
    frame.write_parquet(tmp_path / "x.parquet")
    assert pl.read_parquet(tmp_path / "x.parquet").equals(frame)


class Believer:
    """Learns nothing and believes that every touch is about the first entry."""

    n_behaviors = 2
    credits = ()

    def act(self, state):
        return 0

    def start_episode(self):
        pass

    def q_values(self, state):
        return pl.Series([0.0, 0.0]).to_numpy()

    def learn(self, experience):
        first = replace(experience, action=1, time=0.0)
        other = replace(experience, action=0, time=experience.time)
        self.credits = tuple(
            Credit(reward=reward, shares=((first, 1.0), (other, 0.2)), designated=None)
            for reward in experience.rewards
        )


def test_without_a_designated_pair_the_largest_share_counts(play_home):
    table = TrialTable()
    robots = {"robot_0": LearningRobot(Believer())}
    run_episode(play_home(60), robots, seed=0, observers=[table])
    felt = touches(table.frame())
    assert len(felt) > 3
    assert set(felt["credited_bout"]) == {0}
    assert set(felt["credited_behavior"]) == {"play"}


class Unbelieving(Believer):
    def learn(self, experience):
        self.credits = ()


def test_a_touch_that_nobody_credited_is_kept_without_a_pair(play_home):
    table = TrialTable()
    robots = {"robot_0": LearningRobot(Unbelieving())}
    run_episode(play_home(60), robots, seed=0, observers=[table])
    felt = touches(table.frame())
    assert felt["credited_behavior"].null_count() == len(felt) > 3


def test_roles_and_attention_are_data_beside_their_key(play_home):
    seen = Situation.of(
        {"ann": "playing", "bob": "calling"}, [("bob", "ann"), ("ann", "robot_0")]
    )

    class Home(play_home):
        def situation(self, agent):
            return PLAY if self.decision < 10 else seen

    table = TrialTable()
    robots = {"robot_0": LearningRobot(Believer())}
    run_episode(Home(20), robots, seed=0, observers=[table])
    frame = table.frame()
    first, last = frame.row(0, named=True), frame.row(-1, named=True)
    assert first["roles"] == [{"actor": "ann", "role": "playing"}]
    assert first["attention"] == []
    assert last["roles"] == [
        {"actor": "ann", "role": "playing"},
        {"actor": "bob", "role": "calling"},
    ]
    assert last["attention"] == [
        {"observer": "ann", "target": "robot_0"},
        {"observer": "bob", "target": "ann"},
    ]
    assert frame["situation"].unique(maintain_order=True).to_list() == [
        key_of(PLAY),
        key_of(seen),
    ]


def test_what_people_want_is_kept_where_a_behavior_was_chosen(play_home):
    class Home(play_home):
        def situation(self, agent):
            return Situation.of({"ann": f"role {self.decision}"})

    table = TrialTable()
    robots = {"robot_0": LearningRobot(Believer())}
    run_episode(Home(20), robots, seed=0, observers=[table])
    frame = table.frame()
    assert 0 < frame["chosen"].sum() < len(frame)
    known = frame.select(pl.col("appropriateness").is_not_null()).to_series()
    assert (known == frame["chosen"]).all()
