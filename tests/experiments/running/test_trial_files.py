"""A stored trial is believed only if it is whole and says that it is this trial."""

import shutil

import msgspec
import numpy as np
import polars as pl
import pytest
from polars.testing import assert_frame_equal
from pyarrow import parquet

from experiments.errors import ExperimentError
from experiments.running import trial_files
from experiments.running.store import Results
from experiments.running.study import Condition, Study
from experiments.running.trial_files import Identity, decoded, encoded, fault_of

ONE = Identity(study="toy", configuration="abc", condition="a", seed=3)


def frame(rows=500):
    rng = np.random.default_rng(0)
    return pl.DataFrame(
        {
            "x": rng.random(rows),
            "name": [f"row {i}" for i in range(rows)],
            "parts": [[{"a": i, "b": None}] * (i % 3) for i in range(rows)],
        }
    )


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "seed_0003.parquet"
    path.write_bytes(encoded(frame(), ONE))
    return path


def refused(path, identity=ONE):
    """What is said of a file that cannot be read."""
    with pytest.raises(ExperimentError) as caught:
        decoded(path, identity)
    said = str(caught.value)
    assert said.startswith(f"{path}: ")
    assert said.isprintable()
    return said


def test_a_table_is_read_back_as_it_was(file):
    assert fault_of(file, ONE) is None
    assert_frame_equal(decoded(file, ONE), frame())


def test_equal_trials_make_equal_files():
    assert encoded(frame(), ONE) == encoded(frame(), ONE)


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("seed", 4, "seed 3"),
        ("condition", "b", "condition 'a'"),
        ("study", "other", "study 'toy'"),
        ("configuration", "def", "of another configuration"),
    ],
)
def test_a_trial_of_something_else_is_refused(file, field, value, said):
    other = msgspec.structs.replace(ONE, **{field: value})
    assert f"holds another trial ({said})" in refused(file, other)


def test_a_table_without_rows_is_refused(tmp_path):
    path = tmp_path / "empty.parquet"
    path.write_bytes(encoded(frame(0), ONE))
    assert "holds no rows" in refused(path)


@pytest.mark.parametrize("name", ["plain", "strange"])
def test_a_file_that_is_none_of_ours_is_refused(tmp_path, name):
    path = tmp_path / "foreign.parquet"
    if name == "plain":
        frame().write_parquet(path)
    else:
        table = frame().to_arrow()
        parquet.write_table(
            table.replace_schema_metadata({b"household": b'{"seed": "three"}'}), path
        )
    assert fault_of(path, ONE) is not None
    refused(path)


def test_a_file_cut_at_every_tenth_byte_is_refused(file):
    whole = file.read_bytes()
    for length in range(0, len(whole), 10):
        file.write_bytes(whole[:length])
        assert fault_of(file, ONE) is not None, length
    refused(file)


def test_damage_to_any_byte_is_noticed(file):
    whole = file.read_bytes()
    for place in range(0, len(whole), 7):
        damaged = bytearray(whole)
        damaged[place] ^= 0x55
        file.write_bytes(damaged)
        assert fault_of(file, ONE) is not None, place


def test_how_much_a_file_holds_is_looked_up_before_it_is_read(file, monkeypatch):
    monkeypatch.setattr(trial_files, "MOST_VALUES", 100)
    assert "holds more than 100 values" in refused(file)
    monkeypatch.setattr(trial_files, "LARGEST", 100)
    assert "larger than 100 bytes" in refused(file)


def test_a_small_file_that_would_fill_the_memory_is_refused(tmp_path, monkeypatch):
    """A text that comes in all rows is stored once; of more rows, any amount comes."""
    monkeypatch.setattr(trial_files, "LARGEST_UNPACKED", 2**22)
    path = tmp_path / "seed_0003.parquet"
    path.write_bytes(encoded(pl.DataFrame({"x": ["a" * 10**5] * 300}), ONE))
    assert path.stat().st_size < 10**5
    assert f"holds more than {2**22} bytes when unpacked" in refused(path)


def test_a_table_that_could_be_too_large_and_is_not_is_read(file, monkeypatch):
    whole = decoded(file, ONE)
    monkeypatch.setattr(trial_files, "LARGEST_UNPACKED", 2**17)
    assert decoded(file, ONE).equals(whole)
    monkeypatch.setattr(trial_files, "LARGEST_UNPACKED", 2**10)
    assert "bytes when unpacked" in refused(file)


def toy(columns=()):
    conditions = tuple(Condition(name=n, scenario="s", learner="q") for n in "ab")
    return Study(
        name="toy", conditions=conditions, seeds=(0, 1), run=print, columns=columns
    )


@pytest.fixture
def results(tmp_path):
    results = Results(tmp_path)
    results.prepare(toy(), {"rate": 0.8})
    for trial in toy().trials():
        results.write(trial, pl.DataFrame({"x": [trial.seed]}))
    return results


def test_a_trial_copied_from_another_condition_counts_as_missing(results):
    one, other = toy().trials()[:2]
    shutil.copy(results.file(one), results.file(other))
    assert results.missing(toy().trials()) == (other,)
    with pytest.raises(ExperimentError, match="holds another trial"):
        results.read(toy())


def test_a_trial_copied_from_a_study_with_other_constants_counts_as_missing(
    results, tmp_path
):
    elsewhere = Results(tmp_path / "elsewhere")
    elsewhere.prepare(toy(), {"rate": 0.9})
    one = toy().trials()[0]
    elsewhere.write(one, pl.DataFrame({"x": [0]}))
    shutil.copy(elsewhere.file(one), results.file(one))
    assert results.missing(toy().trials()) == (one,)


def test_a_table_that_lacks_a_column_is_named(results):
    with pytest.raises(ExperimentError, match=r"parquet: has no column 'y'"):
        results.read(toy(columns=("x", "y")))


def test_a_table_with_other_columns_than_the_rest_is_named(results):
    last = toy().trials()[-1]
    results.write(last, pl.DataFrame({"x": ["text"]}))
    with pytest.raises(ExperimentError, match=r"seed_0001\.parquet: its columns are"):
        results.read(toy())
