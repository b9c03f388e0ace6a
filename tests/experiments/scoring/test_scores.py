"""Probe scores and lived scores mean what they say."""

import math

import numpy as np
import pytest

import experiments
from experiments.errors import ExperimentError
from experiments.scoring.households import Task, score
from experiments.scoring.lookahead import deviation, played_out
from experiments.scoring.moments import Moment, probe_set, reference_walk
from experiments.scoring.policies import specification
from experiments.scoring.scores import live, probe_score
from household import household_v0
from household.scenario.family import Draw, draw
from learners.catalog import make_learner
from learners.errors import LearnerError


def moment_of(*truth):
    truth = np.array(truth)
    return Moment(
        agent="robot_0",
        situation="somewhere",
        observation=None,
        n_behaviors=len(truth),
        truth=truth,
        expected=truth,
    )


@pytest.fixture(scope="module")
def home():
    scenario = draw("play", Draw(seed=3, n_people=3, n_robots=2))
    return household_v0.parallel_env(scenario)


def test_the_best_choice_scores_1_and_an_average_one_0():
    moments = [moment_of(0.6, 0.0, -0.6), moment_of(-0.3, -0.1, -0.2)]
    assert probe_score([0, 1], moments) == pytest.approx(1.0)
    assert probe_score([1, 2], moments) == pytest.approx(0.0)
    assert math.isnan(probe_score([], []))


def test_choosing_at_random_scores_0_on_average():
    rng = np.random.default_rng(0)
    moments = [moment_of(*rng.uniform(-1, 1, 5)) for _ in range(200)] * 50
    choices = rng.integers(5, size=len(moments))
    assert abs(probe_score(choices.tolist(), moments)) < 0.05


def test_a_moment_at_which_nobody_would_perceive_the_robot_does_not_matter():
    assert not moment_of(0.0, 0.0, 0.0).matters
    assert not moment_of(-0.5, -0.5, -0.5).matters
    assert moment_of(0.0, -0.5, 0.0).matters


def test_a_probe_set_is_the_same_whoever_asks(home):
    one, again = (probe_set(home, [5, 6], 200) for _ in range(2))
    assert one.share == again.share
    assert 0 < one.share < 1
    assert [m.situation for m in one.moments] == [m.situation for m in again.moments]
    assert all(
        np.array_equal(a.truth, b.truth)
        for a, b in zip(one.moments, again.moments, strict=True)
    )


def test_robots_on_a_reference_walk_hold_behaviors_to_their_end(home):
    shortest = min(each.duration for each in home.scenario.repertoire)
    n = sum(1 for _ in reference_walk(home, 1, 300))
    assert n <= 2 * 300 / shortest


def test_the_persona_reference_is_right_at_every_moment_of_a_probe_set(home):
    moments = probe_set(home, [1], 200).moments
    assert probe_score([int(m.truth.argmax()) for m in moments], moments) == 1.0


def test_playing_behaviors_out_leaves_the_household_as_it_was(home):
    home.reset(seed=4)
    for _ in range(20):
        home.step({"robot_0": 0, "robot_1": 1})
    before = home.state()
    played = played_out(home, "robot_0")
    assert np.array_equal(home.state(), before)
    assert np.array_equal(played_out(home, "robot_0"), played)
    assert played.shape == (len(home.behaviors),)


def test_what_is_foretold_is_near_to_what_people_then_think(home):
    found = deviation(home, 2, 10, np.random.default_rng(0))
    assert found is not None
    assert found.moments == 10
    assert found.error < 0.1
    assert found.agreement > 0.5


def test_silence_earns_less_than_what_people_want(home):
    rng = np.random.default_rng(1)
    wanted = live(home, lambda now: int(now.truth.argmax()), 3, 300)
    any_ = live(home, lambda now: int(rng.integers(now.n_behaviors)), 3, 300)
    assert wanted.per_minute > any_.per_minute
    assert wanted.minutes == pytest.approx(2 * 300 / 60)


def always_first(observation, agent):
    return 0


def never_valid(observation, agent):
    return "hello"


def task(policy, **changes):
    usual = {"family": "elder_care", "seed": 2, "training": 100, "steps": 60}
    return Task(policy=policy, **(usual | changes))


def test_a_constant_scores_the_same_by_name_and_as_a_function():
    by_name = score(task("constant:sleep")).scores["policy"]
    by_function = score(task(always_first)).scores["policy"]
    assert by_name == by_function


def test_scoring_is_a_function_of_the_task_alone():
    assert str(score(task("designated"))) == str(score(task("designated")))


def test_a_saved_learner_is_scored_as_it_is(tmp_path):
    file = tmp_path / "learner.json"
    make_learner("designated", 6, np.random.default_rng(0)).save(file)
    before = file.read_bytes()
    assert score(task(str(file))).scores["policy"].probe_greedy < 0.9
    assert file.read_bytes() == before


@pytest.mark.parametrize(
    ("policy", "says"),
    [
        ("constant:slep", "sleep"),
        ("desiganted", "designated"),
        ("no_such_module:policy", "no_such_module"),
        (never_valid, "no behavior"),
        (3, "no policy"),
    ],
)
def test_a_policy_that_cannot_be_used_is_one_line(policy, says):
    with pytest.raises(ExperimentError, match=says) as error:
        score(task(policy))
    assert "\n" not in str(error.value)


def test_a_learner_with_other_behaviors_is_refused(tmp_path):
    file = tmp_path / "learner.json"
    make_learner("designated", 4, np.random.default_rng(0)).save(file)
    with pytest.raises(ExperimentError, match="chooses from 4 behaviors"):
        score(task(str(file)))


def test_a_file_that_is_no_learner_is_refused(tmp_path):
    (tmp_path / "bad.json").write_text("{}", encoding="utf-8")
    with pytest.raises(LearnerError, match="bad"):
        specification(str(tmp_path / "bad.json"))


def test_an_evaluation_shows_the_policy_beside_every_reference():
    done = experiments.evaluate("random", ["elder_care"], seeds=2, steps=60)
    (family,) = done.families
    assert {
        "policy",
        "random",
        "best constant",
        "population",
        "persona",
        "lookahead",
    } <= set(family.scores)
    assert family.scores["persona"].probe_greedy.value == pytest.approx(1.0)
    assert family.scores["policy"].probe_greedy.n == 2
    assert family.demand
