"""The claims as data, and what only single experiments need."""

import numpy as np
import polars as pl
import pytest

from experiments.analysis.claims import CEILING, FLOOR
from experiments.paper import EXPERIMENTS, reading_situations, table_1
from experiments.paper.e2 import lowest_mean
from experiments.running.trial import describe_condition
from experiments.running.trial_columns import SITUATION, TOUCH, situation_columns
from household.perception.situation import Situation

CLAIMED = {1: "abc", 2: "abcde", 3: "ab", 4: "abc", 5: "abcd"}


@pytest.mark.parametrize("number", range(1, 6))
def test_every_claim_of_the_paper_is_there(number):
    found = {claim.id for claim in EXPERIMENTS[number].claims}
    assert found == {f"{number}{letter}" for letter in CLAIMED[number]}


@pytest.mark.parametrize("number", range(2, 6))
def test_learning_without_silence_is_a_control_of_every_social_experiment(number):
    learners = {c.name: c.learner for c in EXPERIMENTS[number].conditions}
    assert learners["skip_silence"] == "skip_silence"


@pytest.mark.parametrize("number", range(1, 6))
def test_conditions_differ_in_their_learners_alone(number):
    found = [describe_condition(c) for c in EXPERIMENTS[number].conditions]
    for part in ("scenario", "home", "personas", "behaviors", "norms"):
        assert all(one[part] == found[0][part] for one in found)
    for name in ("exploration", "gamma", "initial", "horizon"):
        assert all(one["settings"][name] == found[0]["settings"][name] for one in found)
    settings = [one["settings"] for one in found]
    assert all(
        one != other for one in settings for other in settings if one is not other
    )


@pytest.mark.parametrize("number", range(1, 6))
def test_what_is_run_beside_has_names_of_its_own_and_can_be_described(number):
    experiment = EXPERIMENTS[number]
    names = [condition.name for condition in experiment.all_conditions]
    assert len(set(names)) == len(names)
    assert {FLOOR, CEILING} < set(names)
    for condition in experiment.beside:
        scenario = describe_condition(condition)["scenario"]
        assert scenario["name"] == experiment.name


def test_in_the_other_reading_of_experiment_5_everybody_looks_at_the_robot_at_times():
    found = describe_condition(EXPERIMENTS[5].condition("swap_watching"))
    stages = [stage for one in found["scenario"]["people"] for stage in one["script"]]
    assert len(stages) == 12
    assert {stage["look_at"] for stage in stages} == {"robot_0"}
    plain = describe_condition(EXPERIMENTS[5].condition("swap"))
    stages = [stage for one in plain["scenario"]["people"] for stage in one["script"]]
    assert [stage["look_at"] for stage in stages].count(None) == 2


@pytest.mark.parametrize("number", range(1, 6))
def test_figures_and_claims_name_conditions_that_are_run(number):
    experiment = EXPERIMENTS[number]
    names = {condition.name for condition in experiment.all_conditions}
    assert {figure.condition for figure in experiment.figures} <= names
    for claim in experiment.claims:
        bounds = map(claim.reference, (FLOOR, CEILING)) if claim.reference else ()
        for measure in (claim.measure, *claim.compared, *bounds):
            assert set(measure.conditions) <= names
            assert measure.conditions or measure.label == "no trials"


@pytest.mark.parametrize("number", range(1, 6))
def test_a_claim_that_is_a_share_says_of_what(number):
    for claim in EXPERIMENTS[number].claims:
        assert claim.is_share == claim.unit.startswith("share of ")


def test_table_1_comes_out_to_three_decimals():
    classic, heuristic = (column.round(3).tolist() for column in table_1.columns())
    assert classic == [1.0, 0.003, 0, 0, 0, 0, 0, 0]
    assert heuristic == [0, 0, 0, 0.003, 0.1, 1.0, 0, 0]
    assert table_1.agreement(pl.DataFrame()).tolist() == [1.0] * 16


def test_what_is_computed_has_no_interval():
    found = table_1.computed(np.array([1.0, 0.0]))
    assert (found.value, found.n, found.method) == (0.5, 2, "exact")
    assert np.isnan([found.low, found.high]).all()


@pytest.fixture
def life():
    """Returns a function that makes a table of situations and times, for seeds."""

    def make(**seeds):
        rows = [
            {"seed": seed, "time": time, **situation_columns(situation)}
            for seed, moments in seeds.items()
            for time, situation in moments
        ]
        schema = {"seed": pl.String, "time": pl.Float64, **SITUATION}
        return pl.DataFrame(rows, schema=schema, orient="row")

    return make


def test_the_28_situations_are_counted_by_who_reads(life):
    def moment(ann, bob, *watching):
        attends = [(person, "robot_0") for person in watching]
        return Situation.of({"ann": ann, "bob": bob}, attends)

    frame = life(
        a=[
            (0, moment("reading", "entering")),
            (5, moment("reading", "entering", "bob")),
            (9, moment("reading", "reading", "ann")),
            (20, moment("reading", "reading", "ann")),
            (30, moment("unknown", "working", "ann")),
            (40, moment("calling", "reading", "bob")),
        ],
        b=[(0, moment("reading", "entering"))],
    )
    counts = reading_situations.reached(frame, 10.0)
    assert dict(counts) == {
        ("ann", "entering", False): 2,
        ("ann", "entering", True): 1,
        ("ann", "reading", False): 1,
        ("bob", "reading", True): 1,
        ("bob", "calling", False): 1,
    }
    seeds = reading_situations.seeds_reaching(frame, 10.0)
    assert seeds["ann", "entering", False] == 2
    assert len(set(reading_situations.SITUATIONS)) == 28


def test_the_lowest_mean_is_found_over_all_seeds_together(table):
    def trial(seed, *values):
        felt = [
            {"time": 2.0 * i + 1.0, "value": value} for i, value in enumerate(values)
        ]
        touches = [[dict.fromkeys(names) | one] for one in felt]
        playing = Situation.of({"ann": "playing"})
        frame = table([(playing, "play", 1.0)] * len(felt), touches=touches)
        return frame.select(
            pl.lit("a").alias("condition"), pl.lit(seed).alias("seed"), pl.all()
        )

    names = [field.name for field in TOUCH.fields]
    frame = pl.concat([trial(0, -1.0, 0.5, 0.5), trial(1, 0.5, -1.0, 0.5)])
    # means after each touch: -0.25, -0.5, 0
    assert lowest_mean(frame, "a").tolist() == [-0.5, -0.5]
