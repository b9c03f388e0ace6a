"""Query: a recording's frames hold what the episode held, and what results hold."""

import polars as pl
import pytest

from experiments.running.study import Condition, Trial
from experiments.running.trial import play
from experiments.running.trial_table import TrialTable
from household import household_v0
from household.errors import HouseholdError
from household.replay import RecordEpisodes, read
from policies.recording import RecordingObserver

NEVER_BELIEVED = ("credited_behavior", "credited_time", "share")


@pytest.fixture(scope="module")
def trial(tmp_path_factory):
    """A learner's evening: the table of its results, and the frames of its replay."""
    path = tmp_path_factory.mktemp("trial") / "evening.rrd"
    condition = Condition(
        name="a",
        scenario="evening",
        scenario_overrides={"max_cycles": 900},
        learner="designated",
    )
    table = TrialTable()
    play(Trial(condition=condition, seed=2), [table, RecordingObserver(path)])
    return table.frame(), read(path)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two recorded episodes without a learner, the second in a folder of its own."""
    place = tmp_path_factory.mktemp("folder")
    for seed, where in ((1, place), (2, place / "later")):
        where.mkdir(exist_ok=True)
        base = household_v0.parallel_env("experiment_1", max_cycles=120)
        env = RecordEpisodes(base, str(where))
        env.reset(seed=seed)
        while env.agents:
            env.step(dict.fromkeys(env.agents, env.decision // 7 % 2))
        env.close()
    return place


def in_order(frame, *columns):
    return frame.select(columns).sort(columns)


def test_touches_are_those_of_the_results(trial):
    table, found = trial
    results = (
        table.explode("touches").drop_nulls("touches").unnest("touches", separator=".")
    )
    names = ("time", "giver", "value", "attending", "cause_robot", "cause_behavior")
    results = results.select(
        "robot",
        *(pl.col(f"touches.{name}").alias(name) for name in names),
        pl.col("touches.cause_bout").alias("cause_bout"),
        pl.col("touches.credited_behavior").alias("credited_behavior"),
    )
    assert len(results) > 10
    columns = results.columns
    assert in_order(found.touches, *columns).equals(in_order(results, *columns))


def test_choices_are_those_of_the_results(trial):
    table, found = trial
    chosen = table.filter("chosen").select("robot", "decision", "time", "behavior", "q")
    assert len(chosen) > 50
    own = in_order(found.choices, "robot", "decision", "time", "behavior", "value")
    results = chosen.sort("robot", "decision")
    assert own.drop("value").equals(results.drop("q"))
    expected = [row["q"][row["behavior"]] for row in results.iter_rows(named=True)]
    assert own["value"].to_list() == expected


def test_all_touches_are_felt_in_some_choice(trial):
    _, found = trial
    assert found.choices["reward"].sum() == pytest.approx(found.touches["value"].sum())
    felt = found.choices["caresses"].sum() + found.choices["taps"].sum()
    assert felt == len(found.touches)


def test_situations_are_those_of_the_results_whenever_a_choice_is_made(trial):
    table, found = trial
    rows = (
        table.filter("chosen")
        .explode("roles")
        .unnest("roles")
        .select("robot", "decision", "actor", "role", "attention")
    )
    attends = [
        {"observer": row["actor"], "target": row["robot"]} in row["attention"]
        for row in rows.iter_rows(named=True)
    ]
    results = rows.with_columns(attends=pl.Series(attends)).sort("decision")
    seen = found.situations.rename({"person": "actor"}).sort("decision")
    joined = results.join_asof(
        seen,
        on="decision",
        by=["robot", "actor"],
        suffix="_seen",
        check_sortedness=False,  # Both are.
    )
    assert len(joined) > 200
    assert joined["role"].to_list() == joined["role_seen"].to_list()
    assert joined["attends"].to_list() == joined["attends_seen"].to_list()


def test_stretches_of_a_situation_follow_each_other_without_a_gap(trial):
    _, found = trial
    for _, own in found.situations.group_by("robot", "person"):
        own = own.sort("time")
        assert own["until"][:-1].to_list() == own["time"][1:].to_list()


def test_a_folder_is_read_whole_with_the_name_of_each_file(folder):
    found = read(folder)
    names = ["episode_00000.rrd", "later/episode_00000.rrd"]
    assert found.choices["recording"].unique(maintain_order=True).to_list() == names
    alone = read(folder / "later" / "episode_00000.rrd")
    later = found.choices.filter(pl.col("recording") == names[1])
    assert later.drop("recording").equals(alone.choices.drop("recording"))
    assert alone.choices["recording"].unique().to_list() == ["episode_00000.rrd"]


def test_without_a_learner_nothing_is_believed_or_expected(folder):
    found = read(folder)
    assert found.touches.select(NEVER_BELIEVED).null_count().row(0) == (
        len(found.touches),
    ) * len(NEVER_BELIEVED)
    assert found.choices["value"].null_count() == len(found.choices) > 20


def test_an_empty_folder_is_refused_by_name(tmp_path):
    with pytest.raises(HouseholdError, match="no recordings in this folder"):
        read(tmp_path)
