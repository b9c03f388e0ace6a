"""How the typical trials are watched: by commands that live through the same."""

import shlex

import pytest
import tyro

from experiments.commands.replaying import Replay
from experiments.commands.training import Train
from experiments.docs_tools.typical import Typical, typical
from experiments.paper import EXPERIMENTS
from experiments.running.store import Results
from experiments.running.trial import make_home


def trial_of(number, **more):
    usual = {"seed": 7, "caresses": 1, "taps": 2}
    return Typical(experiment=EXPERIMENTS[number], **(usual | more))


@pytest.mark.parametrize("number", EXPERIMENTS)
def test_the_command_lives_through_the_trial_of_the_experiment(number):
    program, command, *arguments = shlex.split(trial_of(number).commands[0])
    assert (program, command) == ("household", "train")
    trial = tyro.cli(Train, args=arguments)._trial()
    experiment = EXPERIMENTS[number]
    condition = experiment.condition(experiment.reference)
    assert trial.seed == 7
    assert trial.condition.learner == condition.learner
    assert not condition.learner_overrides
    assert make_home(trial.condition).scenario == make_home(condition).scenario


def test_the_replay_opens_at_a_touch_that_there_is():
    asked = [
        tyro.cli(Replay, args=shlex.split(trial_of(2, taps=n).commands[1])[2:])
        for n in (0, 3)
    ]
    assert [one.find for one in asked] == ["caress by", "tap by"]
    assert str(asked[0].path) == "runs/experiment_2"


def test_the_typical_trial_is_found_among_what_is_stored(tmp_path, play_trial):
    experiment = EXPERIMENTS[1]
    study, results = experiment.study((0, 1, 2)), Results(tmp_path / "experiment_1")
    results.prepare(study, {"made": "up"})
    tables = {}
    for trial in study.trials():
        table = play_trial(trial, steps=200)
        results.write(trial, table)
        if trial.condition.name == experiment.reference:
            tables[trial.seed] = table
    (one,) = typical(tmp_path)
    assert one.seed == sorted(tables, key=lambda k: tables[k]["reward"].sum())[1]
    values = [felt["value"] for row in tables[one.seed]["touches"] for felt in row]
    assert one.caresses == sum(value > 0.0 for value in values)
    assert one.taps == sum(value < 0.0 for value in values)
    assert one.caresses + one.taps > 0
    assert one.page == f"experiment_1_seed_{one.seed}.html"
