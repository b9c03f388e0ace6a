"""Studies and what they leave on the disk."""

import json

import numpy as np
import polars as pl
import pytest
from hypothesis import strategies as st

from experiments.cli import main
from experiments.errors import ExperimentError
from experiments.running.store import Results
from experiments.running.study import Condition, Study
from experiments.running.trial import describe_condition, make_home, make_learner_of
from experiments.running.trial_files import decoded, encoded
from household.errors import HouseholdError
from learners.errors import LearnerError

from .plain_data import ODD, changed

REFUSALS = (ExperimentError, HouseholdError, LearnerError)


def said(error):
    text = str(error)
    assert 0 < len(text) < 4000
    assert "\n" not in text
    return text


USUAL = {
    "name": "social",
    "scenario": "experiment_1",
    "learner": "q_social",
    "scenario_overrides": {"max_cycles": 30, "heterogeneity": 0.5},
    "learner_overrides": {"gamma": 0.1, "rate": {"name": "social", "center": 1.1}},
    "factors": {"rate": "social"},
}


def test_a_condition_is_refused_in_one_line_or_described_and_made(explore):
    def check(data):
        if not isinstance(data, dict) or not all(isinstance(k, str) for k in data):
            return "no fields"
        try:
            condition = Condition(**data)
        except ExperimentError as error:
            said(error)
            return "refused"
        except TypeError:  # Python's own: such a field there is not.
            assert not {"name", "scenario", "learner"} <= set(data) <= set(USUAL)
            return "no such fields"
        try:
            assert json.dumps(describe_condition(condition))
            env = make_home(condition)
            make_learner_of(condition, len(env.behaviors), np.random.default_rng(0))
        except REFUSALS as error:
            said(error)
            return "refused"
        return "accepted"

    explore(changed(USUAL, None, 2), check, few=25)


def _nothing(trial):
    return pl.DataFrame({"x": [float(trial.seed)]})


@pytest.fixture
def stored(tmp_path):
    """A small study with its trials."""
    conditions = tuple(
        Condition(name=name, scenario="experiment_1", learner="q_social")
        for name in ("one", "two")
    )
    study = Study(name="toy", conditions=conditions, seeds=(0, 1), run=_nothing)
    results = Results(tmp_path / "toy")
    results.prepare(study, {"conditions": {"one": {}, "two": {}}})
    for trial in study.trials():
        results.write(trial, _nothing(trial))
    return study, results


def test_a_study_file_is_read_or_refused_in_one_line(explore, stored, capsys):
    study, results = stored
    original = json.loads(results.study_file.read_text(encoding="utf-8"))

    def check(data):
        try:
            results.study_file.write_text(json.dumps(data), encoding="utf-8")
        except (TypeError, ValueError):
            return "not JSON"
        status = main(["check", str(results.directory)])
        lines = capsys.readouterr().err.splitlines()
        assert status in (0, 2)
        assert all(len(line) < 4000 for line in lines)
        again = Results(results.directory)
        try:
            again.check({"conditions": {"one": {}, "two": {}}})
            again.read(study)
        except ExperimentError as error:
            text = said(error)
            assert str(results.directory) in text
            return "refused"
        return "accepted"

    explore(changed(original, None), check, few=25)


TABLES = st.dictionaries(
    st.sampled_from(("x", "seed", "condition", "", "a b", "\U0001f916")),
    st.sampled_from((1.0, "text", None, True, [1, 2], {"a": 1})),
    min_size=1,
).map(lambda columns: pl.DataFrame({name: [v] * 3 for name, v in columns.items()}))


def test_a_strangers_table_is_read_or_refused_in_one_line(explore, stored):
    """Whole tables of other columns, and damaged ones of the right columns."""
    study, results = stored
    first, *_ = study.trials()
    identity, path = results.identity(first), results.file(first)
    whole = path.read_bytes()

    def check(case):
        table, at, byte = case
        content = bytearray(whole if byte else encoded(table, identity))
        if byte:
            content[at % len(content)] ^= byte
        path.write_bytes(content)
        try:
            decoded(path, identity)
            Results(results.directory).read(study)
        except ExperimentError as error:
            text = said(error)
            assert str(results.directory) in text
            return "refused"
        return "accepted"

    explore(
        st.tuples(TABLES, st.integers(0, 10**6), st.integers(0, 255)), check, few=30
    )


def test_a_study_of_odd_seeds_is_refused_in_one_line(explore):
    condition = Condition(name="one", scenario="experiment_1", learner="q_social")

    def check(seeds):
        try:
            Study(name="toy", conditions=(condition,), seeds=seeds, run=_nothing)
        except ExperimentError as error:
            said(error)
            return "refused"
        return "accepted"

    explore(st.lists(st.integers(-1, 5) | ODD, max_size=3).map(tuple), check, few=30)
