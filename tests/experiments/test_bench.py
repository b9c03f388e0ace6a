import json

import pytest

from experiments.bench.measure import Measure, Settings, alternate
from experiments.commands.benchmarking import measure_all

TINY = Settings(
    repetitions=2,
    steps=2,
    people=(1, 2),
    robots=(1, 2),
    rooms=(1, 2),
    actors=(1, 2),
    situations=(5, 10),
    trials=2,
)


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    out = tmp_path_factory.mktemp("bench")
    measure_all(TINY, out)
    return out


@pytest.fixture(scope="module")
def told(measured):
    return json.loads((measured / "bench.json").read_text())


def test_the_file_tells_machine_versions_and_settings(told):
    assert set(told) == {"machine", "versions", "commit", "settings", "measures"}
    assert int(told["machine"]["cores"]) >= 1
    assert told["settings"]["people"] == [1, 2]
    assert "pymunk" in told["versions"]


def test_every_part_is_measured(told):
    parts = {measure["part"] for measure in told["measures"]}
    assert parts == {
        "step",
        "agent-seconds per second",
        "physics",
        "step against people, with 2 robots",
        "step against robots, with 4 people",
        "step against walls, with 4 people + 2 robots",
        "growth",
        "recording",
        "learner's update against actors",
        "learner's update against situations visited",
        "learner's memory against situations visited",
        "start",
        "trials",
    }


def test_every_measure_was_repeated_and_is_a_positive_number(told):
    for measure in told["measures"]:
        few = 1 if measure["part"] == "trials" else TINY.repetitions
        assert len(measure["values"]) == few
        assert min(measure["values"]) > 0
        assert measure["median"] <= max(measure["values"])


def test_every_budget_that_can_be_checked_without_peers_is_there(told):
    checked = {m["name"] for m in told["measures"] if m["holds"] is not None}
    assert checked >= {
        "step / Space.step",
        "2 people + 2 robots / 4 people + 2 robots",
        "recorded step / plain step",
        "import household",
        "household --help",
        "2 workers / 1 worker",
    }


def test_the_growth_is_drawn(measured):
    assert (measured / "bench.svg").read_text().startswith("<?xml")


def test_a_budget_holds_up_to_its_bound_and_no_further():
    def holds(value, **bound):
        return Measure(part="p", name="n", unit="x", values=(value,), **bound).holds

    assert holds(3.0, at_most=3.0)
    assert not holds(3.1, at_most=3.0)
    assert holds(10.0, at_least=10.0)
    assert not holds(9.9, at_least=10.0)
    assert holds(1.0) is None


def test_the_median_counts():
    measure = Measure(part="p", name="n", unit="x", values=(9.0, 1.0, 2.0))
    assert measure.median == 2.0


def test_what_is_compared_is_called_in_turn():
    calls = []
    subjects = {name: lambda name=name: calls.append(name) for name in "ab"}
    times = alternate(subjects, repetitions=2, calls=2)
    assert "".join(calls) == "ab" + "aabb" * 2
    assert [len(each) for each in times.values()] == [2, 2]
