"""A study file that cannot be used is one line, before any work."""

import json

import pytest

from experiments.errors import ExperimentError
from experiments.running import study_files
from experiments.running.study_files import read_study_file
from experiments.running.trial_files import FORMAT

RIGHT = {
    "format": FORMAT,
    "study": "toy",
    "seeds": [0, 1],
    "sessions": [{"versions": {"python": "3.11"}, "commit": None}],
    "configuration": {"conditions": {}},
}

WRONG = [
    *({"seeds": value} for value in ([], [-1], [0, 0], ["a"], [0.5], "0", None, {})),
    *({"sessions": value} for value in ([], [1], [{}], [{"versions": 1}], "x", None)),
    *({"configuration": value} for value in ([], "x", None, 1)),
    *({"study": value} for value in (1, None, [])),
    *({"format": value} for value in (FORMAT - 1, str(FORMAT), None, 10**400)),
]


def refused(path, content):
    path.write_text(content)
    with pytest.raises(ExperimentError) as caught:
        read_study_file(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 500 + 2 * len(str(path))


def test_a_right_file_is_read(tmp_path):
    path = tmp_path / "study.json"
    path.write_text(json.dumps(RIGHT))
    assert read_study_file(path) == RIGHT


@pytest.mark.parametrize("field", RIGHT)
def test_a_file_that_lacks_a_field_is_refused(tmp_path, field):
    lacking = {name: value for name, value in RIGHT.items() if name != field}
    refused(tmp_path / "study.json", json.dumps(lacking))


@pytest.mark.parametrize("wrong", WRONG, ids=json.dumps)
def test_a_file_with_a_mistyped_field_is_refused(tmp_path, wrong):
    refused(tmp_path / "study.json", json.dumps(RIGHT | wrong))


@pytest.mark.parametrize(
    "content", ["", "{", "[]", "1", "[" * 5000, '{"a":' * 5000, "\ud800", "9" * 5000]
)
def test_what_is_no_study_file_is_refused(tmp_path, content):
    path = tmp_path / "study.json"
    path.write_bytes(content.encode("utf-8", "surrogatepass"))
    with pytest.raises(ExperimentError, match=r"study\.json: "):
        read_study_file(path)


def test_a_file_cut_anywhere_is_refused(tmp_path):
    whole = json.dumps(RIGHT)
    for length in range(0, len(whole), 10):
        refused(tmp_path / "study.json", whole[:length])


def test_a_file_that_is_too_large_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr(study_files, "LARGEST", 100)
    refused(tmp_path / "study.json", json.dumps(RIGHT))
