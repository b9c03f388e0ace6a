"""Files that somebody else wrote: their digest is right, their content is anything."""

import hashlib
import json

import numpy as np
import pytest

from learners import CATALOG, load, make_learner
from learners.errors import LearnerError
from learners.saving import files


@pytest.fixture
def written(tmp_path):
    """Writes JSON as a saved learner whose digest is right; returns the file."""

    def write(payload):
        text = payload if isinstance(payload, str) else json.dumps(payload)
        digest = hashlib.sha256(text.encode()).hexdigest()
        header = {"format": files.FORMAT, "version": files.VERSION, "sha256": digest}
        path = tmp_path / "stranger.json"
        path.write_text(f"{json.dumps(header)}\n{text}\n", encoding="utf-8")
        return path

    return write


@pytest.fixture
def saved_learner(live, tmp_path):
    """The content of a saved learner that has lived."""
    learner = make_learner("q_social", 2, np.random.default_rng(1))
    live(learner, 30, np.random.default_rng(2))
    learner.save(tmp_path / "saved.json")
    return json.loads((tmp_path / "saved.json").read_text().splitlines()[1])


def refused(path):
    with pytest.raises(LearnerError) as caught:
        load(path)
    said = str(caught.value)
    assert "\n" not in said
    assert len(said) < len(str(path)) + 400
    return said


@pytest.mark.parametrize(
    "payload",
    [
        {"generator": "test", "state": 0},
        {"generator": "seed", "state": 0},
        {"generator": "__class__", "state": {}},
        {"array": ["os"], "dtype": "O"},
        {"array": [[1], [1, 2]], "dtype": "float64"},
        {"array": [1], "dtype": "no such"},
        {"object": "QLearner", "data": {}},
        {"object": "QLearner", "data": [1]},
        {"object": "QLearner", "data": {"n_behaviors": "three"}},
        {"object": "check_range", "data": {}},
        {"function": "system"},
        {"object": "Popen", "data": {"args": "true"}},
        {"unknown": 1},
        {},
        {"tuple": 1},
        {"set": [[1]]},
        {"dict": [[1]]},
        {"dict": [[[1], 2]]},
        "[" * 100_000,
        "9" * 10_000,
        '{"array": [1e999], "dtype": "int64"}',
    ],
    ids=str,
)
def test_what_is_no_learner_is_refused_in_one_line_and_nothing_is_run(written, payload):
    path = written(payload)
    assert str(path) in refused(path) or "needs" in refused(path)


def test_only_declared_fields_are_set(written, saved_learner):
    saved_learner["data"]["learn"] = 1
    saved_learner["data"]["__class__"] = 1
    learner = load(written(saved_learner))
    assert callable(learner.learn)
    assert type(learner).__name__ == "QLearner"


@pytest.mark.parametrize("other", ["Views", "AudibleViews", "NestedViews"])
def test_a_table_of_another_representation_is_refused_by_name(
    written, saved_learner, other
):
    saved_learner["data"]["representation"] = {"object": other, "data": {}}
    assert f"another representation than {other}" in refused(written(saved_learner))


def test_a_file_that_is_too_large_is_not_read(written, saved_learner, monkeypatch):
    path = written(saved_learner)
    monkeypatch.setattr(files, "LARGEST", 1000)
    assert "larger than 1000 bytes" in refused(path)


VALUES = (None, True, -1, 2**70, 1e308, "x", [], {}, {"tuple": []}, {"dict": []})


def mutated(data, rng):
    """The data with one part exchanged, dropped or doubled, somewhere inside."""
    if isinstance(data, dict) and data and rng.random() < 0.9:
        key = list(data)[rng.integers(len(data))]
        if rng.random() < 0.1:
            return {k: v for k, v in data.items() if k != key}
        return data | {key: mutated(data[key], rng)}
    if isinstance(data, list) and data and rng.random() < 0.9:
        at = int(rng.integers(len(data)))
        return [*data[:at], mutated(data[at], rng), *data[at + 1 :]]
    return VALUES[rng.integers(len(VALUES))]


def try_mutated(written, data, n):
    """How many mutated learners were loaded, and how many refused."""
    rng, counts = np.random.default_rng(3), [0, 0]
    for _ in range(n):
        path = written(mutated(data, rng))
        try:
            load(path)
            counts[0] += 1
        except LearnerError:
            counts[1] += 1
    return counts


def test_mutated_learners_are_loaded_or_refused(written, saved_learner):
    assert try_mutated(written, saved_learner, 200)[1] > 50


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOG)
def test_many_mutated_learners_of_every_kind_are_loaded_or_refused(
    written, name, attached, live, tmp_path
):
    learner = make_learner(name, 3, np.random.default_rng(1), **attached(name))
    live(learner, 30, np.random.default_rng(2))
    learner.save(tmp_path / "saved.json")
    data = json.loads((tmp_path / "saved.json").read_text().splitlines()[1])
    loaded, refusals = try_mutated(written, data, 500)
    print(f"\nmutated {name}: {loaded} loaded, {refusals} refused")
    assert refusals > 0
