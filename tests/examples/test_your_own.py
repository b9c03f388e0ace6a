"""The examples of what users write themselves do what they say."""


def test_a_policy_of_ones_own_is_scored_beside_references(run, capsys):
    made = run("evaluate_a_policy")
    scores = made["evaluation"].families[0].scores
    assert -1.0 <= scores["policy"].probe_greedy.value <= 1.0
    assert scores["policy"].verdicts_per_minute != scores["random"].verdicts_per_minute
    assert "lookahead" in capsys.readouterr().out
