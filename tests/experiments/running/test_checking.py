"""`household check` reads whole studies."""

import json
import shutil

import polars as pl
import pytest

from experiments.cli import main
from experiments.running.store import Results
from experiments.running.study import Condition, Study


def toy(name):
    conditions = tuple(Condition(name=n, scenario="s", learner="q") for n in "ab")
    return Study(name=name, conditions=conditions, seeds=(0, 1, 2), run=print)


@pytest.fixture
def studies(tmp_path):
    for name in ("one", "two"):
        results = Results(tmp_path / name)
        results.prepare(toy(name), {"conditions": {"a": {}, "b": {}}})
        for trial in toy(name).trials():
            results.write(trial, pl.DataFrame({"x": [trial.seed]}))
    return tmp_path


def test_faultless_studies_are_said_to_be_so(studies, capsys):
    assert main(["check", str(studies)]) == 0
    said = capsys.readouterr().out
    assert said == f"{studies}: correct; studies: 2, trials: 12.\n"
    assert main(["check", str(studies / "one" / "study.json")]) == 0


def test_all_faults_of_all_studies_are_told_at_once(studies, capsys):
    trials = studies / "one" / "trials"
    (trials / "a" / "seed_0000.parquet").unlink()
    (trials / "a" / "seed_0001.parquet").write_bytes(b"half")
    shutil.copy(trials / "b" / "seed_0000.parquet", trials / "b" / "seed_0001.parquet")
    document = json.loads((studies / "two" / "study.json").read_text())
    del document["seeds"]
    (studies / "two" / "study.json").write_text(json.dumps(document))
    assert main(["check", str(studies)]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 4
    assert "1 of 6 trials are missing, e.g. a, seed 0" in lines[0]
    assert "seed_0001.parquet: damaged" in lines[1]
    assert "holds another trial (seed 0)" in lines[2]
    assert "two/study.json: damaged (Object missing required field `seeds`" in lines[3]


def test_a_study_whose_conditions_lead_elsewhere_is_refused(studies, capsys):
    file = studies / "one" / "study.json"
    document = json.loads(file.read_text())
    for conditions in ({"../../etc": {}}, ["a"]):
        document["configuration"]["conditions"] = conditions
        file.write_text(json.dumps(document))
        assert main(["check", str(file)]) == 2
        assert "one/study.json: " in capsys.readouterr().err


def test_a_directory_without_studies_is_refused(tmp_path, capsys):
    assert main(["check", str(tmp_path)]) == 2
    assert "no study.json there" in capsys.readouterr().err
