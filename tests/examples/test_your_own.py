"""The examples of what users write themselves do what they say."""

from household.home.check import problems
from household.home.floorplan import load_floorplan


def test_a_drawn_home_is_lived_in_and_kept(run):
    made = run("draw_a_home")
    assert load_floorplan("drawn_flat.toml") == made["plan"]
    assert problems(made["plan"]) == ()
    assert made["touches"]


def test_a_person_of_ones_own_taps_until_it_has_had_enough(run):
    made = run("write_a_person")
    hers = [touch for touch in made["touches"] if touch.giver == "mother"]
    assert 3 <= len(hers) <= 11
    assert {touch.kind for touch in hers} == {"tap"}
    assert {touch.strength for touch in hers} == {0.5}
    assert "mother sleeping" in str(made["env"].situation("robot_0"))


def test_a_behavior_of_ones_own_pleases_who_plays_and_annoys_who_calls(run):
    touches = run("own_behavior")["touches"]
    kinds = {
        activity: {
            kind for situation, kind in touches if f"actor {activity}" in situation
        }
        for activity in ("playing", "calling")
    }
    assert kinds == {"playing": {"caress"}, "calling": {"tap"}}


def test_a_learner_of_ones_own_learns_and_comes_back(run):
    made = run("write_a_learner")
    values = {
        str(state): made["learner"].q_values(state) for state in made["learner"].table
    }
    play, sleep = values["actor playing, actor > robot_0"]
    assert play > sleep
    assert len(made["again"].table) == len(values)


def test_a_policy_of_ones_own_is_scored_beside_references(run, capsys):
    made = run("evaluate_a_policy")
    scores = made["evaluation"].families[0].scores
    assert -1.0 <= scores["policy"].probe_greedy.value <= 1.0
    assert scores["policy"].verdicts_per_minute != scores["random"].verdicts_per_minute
    assert "lookahead" in capsys.readouterr().out


def test_a_study_of_ones_own_tells_learners_apart(run):
    made = run("run_a_study")
    assert len(made["rewards"]) == 15
    assert made["found"]["designated"].low > made["found"]["random"].high
