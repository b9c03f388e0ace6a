import json
import os
import signal
from datetime import date

import polars as pl
import pytest

from experiments.errors import ExperimentError
from experiments.running.files import write_whole
from experiments.running.store import Results
from experiments.running.study import Condition, Study, Trial
from experiments.running.study_files import first_difference


def nothing(trial):
    return pl.DataFrame({"x": [trial.seed]})


def study(seeds=(0, 1), names=("a", "b")):
    conditions = tuple(Condition(name=n, scenario="s", learner="q") for n in names)
    return Study(name="test", conditions=conditions, seeds=seeds, run=nothing)


def filled(directory, wanted):
    results = Results(directory)
    results.prepare(wanted, {"rate": 0.8})
    for trial in wanted.trials():
        results.write(trial, nothing(trial))
    return results


def test_what_is_written_is_read_back_with_condition_and_seed(tmp_path):
    results = filled(tmp_path, study())
    frame = results.read(study())
    assert frame.columns == ["condition", "seed", "x"]
    assert frame.rows() == [("a", 0, 0), ("b", 0, 0), ("a", 1, 1), ("b", 1, 1)]


def test_only_trials_without_a_file_are_missing(tmp_path):
    results = filled(tmp_path, study())
    larger = study(seeds=(0, 1, 2))
    assert [str(t) for t in results.missing(larger.trials())] == [
        "a, seed 2",
        "b, seed 2",
    ]


def test_reading_an_unfinished_study_says_what_is_missing(tmp_path):
    results = filled(tmp_path, study())
    with pytest.raises(
        ExperimentError, match=r"2 of 6 trials are missing, e\.g\. a, seed"
    ):
        results.read(study(seeds=(0, 1, 2)))


def test_a_damaged_trial_is_named(tmp_path):
    results = filled(tmp_path, study())
    damaged = results.file(study().trials()[0])
    damaged.write_bytes(b"")
    with pytest.raises(ExperimentError, match=rf"{damaged.name}: damaged"):
        results.read(study())


def test_reading_takes_only_the_seeds_of_the_study(tmp_path):
    results = filled(tmp_path, study(seeds=(0, 1, 2)))
    assert results.read(study(seeds=(1,)))["seed"].to_list() == [1, 1]


def test_another_configuration_is_refused_and_nothing_is_touched(tmp_path):
    results = filled(tmp_path, study())
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    with pytest.raises(ExperimentError) as caught:
        results.prepare(study(), {"rate": 0.9})
    assert "rate: stored 0.8, asked for 0.9" in str(caught.value)
    assert "\n" not in str(caught.value)
    after = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    assert before == after


def test_more_seeds_are_the_same_configuration(tmp_path):
    results = filled(tmp_path, study())
    results.prepare(study(seeds=(0, 1, 2)), {"rate": 0.8})
    assert results.read_study()["seeds"] == [0, 1, 2]


def test_the_study_file_names_versions_and_commit(tmp_path):
    session = filled(tmp_path, study()).read_study()["sessions"]
    assert len(session) == 1
    assert {"python", "numpy", "polite-household"} <= set(session[0]["versions"])
    assert "commit" in session[0]


def test_factors_are_columns_of_the_table(tmp_path):
    conditions = tuple(
        Condition(name=f"{rate}", scenario="s", learner="q", factors={"rate": rate})
        for rate in ("slow", "fast")
    )
    wanted = Study(name="test", conditions=conditions, seeds=(0, 1), run=nothing)
    frame = filled(tmp_path, wanted).read(wanted)
    assert frame.columns == ["condition", "seed", "rate", "x"]
    assert frame.filter(rate="fast")["condition"].to_list() == ["fast", "fast"]


def test_results_of_an_older_format_are_refused_in_one_line(tmp_path):
    results = filled(tmp_path, study())
    older = {**results.read_study(), "format": 1}
    results.study_file.write_text(json.dumps(older))
    before = results.study_file.read_bytes()
    for refused in (results.read_study, lambda: results.prepare(study(), {})):
        with pytest.raises(ExperimentError) as caught:
            refused()
        assert "holds results in format 1, this version reads format 3" in str(
            caught.value
        )
        assert "Choose another --out, or delete" in str(caught.value)
        assert "\n" not in str(caught.value)
    assert results.study_file.read_bytes() == before


def test_a_damaged_study_file_is_named(tmp_path):
    (tmp_path / "study.json").write_text('{"format": 1, "stu')
    with pytest.raises(ExperimentError, match=r"study\.json: damaged"):
        Results(tmp_path).read_study()


def test_an_output_directory_that_is_a_file_is_refused_and_left_alone(tmp_path):
    file = tmp_path / "out"
    file.write_text("precious")
    for directory in (file, file / "inside"):
        with pytest.raises(ExperimentError, match="is a file, must be a directory"):
            Results(directory).prepare(study(), {})
    assert file.read_text() == "precious"


def test_an_output_directory_that_cannot_be_written_to_is_named(tmp_path, monkeypatch):
    def refuse(*args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.touch", refuse)
    with pytest.raises(ExperimentError, match=r"cannot be written to \(Permission"):
        Results(tmp_path).prepare(study(), {})


def test_a_write_that_fails_leaves_neither_file_nor_remains(tmp_path):
    def half(path):
        path.write_text("half")
        raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"):
        write_whole(tmp_path / "whole", half)
    assert list(tmp_path.iterdir()) == []


def test_an_error_file_goes_when_its_trial_succeeds(tmp_path):
    results = Results(tmp_path)
    results.prepare(study(), {})
    trial = study().trials()[0]
    path = results.write_error(trial, ValueError("no"))
    assert "ValueError: no" in path.read_text()
    results.write(trial, nothing(trial))
    assert not path.exists()


@pytest.mark.parametrize(
    ("stored", "asked", "said"),
    [
        ({"a": {"b": 1}}, {"a": {"b": 2}}, "a.b: stored 1, asked for 2"),
        ({"a": [1, 2]}, {"a": [1, 3]}, "a[1]: stored 2, asked for 3"),
        ({}, {"new": "x"}, 'new: stored null, asked for "x"'),
        ({"a": [1]}, {"a": [1]}, None),
        ({"a\nb": 1}, {}, r"'a\nb': stored 1, asked for null"),
    ],
)
def test_a_difference_is_told_by_its_path(stored, asked, said):
    assert first_difference(stored, asked) == said


def test_a_difference_is_told_in_one_short_line_whatever_differs():
    said = first_difference({"a" * 5000: "\u2028"}, {})
    assert said.endswith(r': stored "\u2028", asked for null')
    assert len(said) < 300


KILLED = """
    import os, sys
    from pathlib import Path
    import polars as pl
    from experiments.running.files import write_whole

    def slowly(path):
        whole = b"x" * 1000
        with path.open("wb") as file:
            file.write(whole[:500]); file.flush()
            print("half", flush=True)
            sys.stdin.read()

    write_whole(Path(sys.argv[1]), slowly)
"""


def test_a_process_killed_while_writing_leaves_no_file_of_that_name(program, tmp_path):
    target = tmp_path / "results" / "seed_0001.parquet"
    target.parent.mkdir()
    process = program(KILLED, target)
    assert process.stdout.readline() == "half\n"
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert not target.exists()
    assert len(list(target.parent.iterdir())) == 1  # the remains, under another name
    Results(target.parent).prepare(study(), {})
    assert [path.name for path in target.parent.iterdir()] == ["study.json"]


def test_a_condition_name_that_cannot_be_a_folder_is_refused():
    with pytest.raises(ExperimentError, match="condition name 'a/b'"):
        Condition(name="a/b", scenario="s", learner="q")


@pytest.mark.parametrize("level", [date(2026, 1, 1), None, ("social",)])
def test_a_level_that_is_neither_text_nor_a_number_is_refused(level):
    with pytest.raises(ExperimentError, match="of factor 'rate' is neither text nor"):
        Condition(
            name="a",
            scenario="experiment_1",
            learner="q_social",
            factors={"rate": level},
        )


def test_a_study_pairs_every_condition_with_every_seed():
    assert [str(t) for t in study().trials()] == [
        "a, seed 0",
        "b, seed 0",
        "a, seed 1",
        "b, seed 1",
    ]
    assert Trial(condition=study().conditions[0], seed=3).seed == 3
