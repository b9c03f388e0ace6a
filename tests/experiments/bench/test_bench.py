import io
import json
from concurrent.futures import ThreadPoolExecutor

import pytest
from rich.console import Console

from experiments.bench.measurement import (
    Growth,
    Measurement,
    Settings,
    alternate,
    exponent,
)
from experiments.bench.report import tables
from experiments.commands.benchmarking import measure_all
from experiments.running import engine
from experiments.running.engine import Engine

TINY = Settings(
    repetitions=2,
    steps=2,
    people=(1, 2),
    robots=(1, 2),
    rooms=(1, 2),
    actors=(1, 2),
    company=(1, 2),
    situations=(5, 10),
    homes=(1, 2),
    trials=2,
    decisions=20,
    trial_decisions=20,
)


def threads(spec, workers):
    """Trials run at once, too, but nothing has to start; `test_engine` starts it."""
    return Engine(open=lambda: ThreadPoolExecutor(workers), window=workers)


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    out = tmp_path_factory.mktemp("bench")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine, "open_engine", threads)
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
        "largest household",
        "many homes, agent-decisions",
        "where a step goes",
        "recording",
        "trial of evening",
        "learner's update against actors",
        "update by views against people",
        "choice by views against people",
        "memory by views against people",
        "learner's update against situations visited",
        "learner's memory against situations visited",
        "start",
        "trials",
    }


def test_every_measure_was_repeated_and_is_a_positive_number(told):
    for measure in told["measures"]:
        if measure["hint"]:  # It is not installed.
            assert measure["values"] == []
            assert measure["hint"].startswith("pip install ")
            continue
        assert len(measure["values"]) == TINY.repetitions
        # What does not grow may come out with any power of n near 0.
        assert min(measure["values"]) > 0 or measure["name"] == "power of n"
        assert measure["median"] <= max(measure["values"])


def test_every_budget_that_can_be_checked_without_peers_is_there(told):
    checked = {m["name"] for m in told["measures"] if m["holds"] is not None}
    assert checked >= {
        "step / 10 x Space.step",
        "that / T",
        "that / T, never finishing",
        "that / 4 + 2",
        "that / 4 + 2, never finishing",
        "recorded step / plain step",
        "designated / bare",
        "hierarchical_thompson / bare",
        "import household",
        "household --help",
        "2 workers / 1 worker",
    }


def test_every_growth_has_its_power_of_n_and_what_it_may_be(told):
    allowed = {
        m["part"]: m["at_most"] for m in told["measures"] if m["name"] == "power of n"
    }
    assert allowed == {
        "step against people, with 2 robots": 2.0,
        "step against robots, with 4 people": 2.0,
        "step against walls, with 4 people + 2 robots": 1.0,
        "learner's update against actors": 2.0,
        "update by views against people": 1.2,
        "choice by views against people": 1.2,
        "memory by views against people": 1.2,
        "learner's update against situations visited": 0.2,
        "learner's memory against situations visited": 1.0,
    }


def test_the_parts_of_a_step_make_up_all_of_it(told):
    rounds = zip(
        *(m["values"] for m in told["measures"] if m["part"] == "where a step goes"),
        strict=True,
    )
    assert [sum(shares) for shares in rounds] == pytest.approx([100.0, 100.0])


def test_the_table_fits_80_columns_with_every_name_on_a_line_of_its_own(told):
    fields = ("part", "name", "unit", "values", "at_most", "at_least")
    # As wide as it gets: the longest names, large numbers and a budget missed.
    longest = Measurement(
        part="learner's memory against situations visited",
        name="observations, infos",
        unit="kB",
        values=(81_234.0, 91_234.0),
        at_most=1000.0,
    )
    measurements = [Measurement(**{f: m[f] for f in fields}) for m in told["measures"]]
    console = Console(width=80, file=io.StringIO())
    console.print(tables([*measurements, longest]))
    lines = console.file.getvalue().splitlines()
    assert max(map(len, lines)) <= 80
    for each in (*measurements, longest):
        assert any(line.startswith(f"  {each.name}  ") for line in lines)
        assert each.part in lines


def test_what_grows_with_the_pairs_grows_with_the_second_power():
    def found(*times):
        return [
            Measurement(
                part="p",
                name=str(n),
                unit="us",
                values=(t, 2 * t),
                growth=Growth(what="step", against="people", x=n),
            )
            for n, t in zip((1, 2, 4, 8), times, strict=True)
        ]

    # Only the upper half counts: what is there at the beginning does not hide it.
    pairs = exponent(found(900.0, 500.0, 16.0, 64.0), at_most=2.0)
    assert pairs.values == pytest.approx((2.0, 2.0))
    flat = exponent(found(1.0, 9.0, 5.0, 5.0), at_most=0.2)
    assert flat.values == pytest.approx((0.0, 0.0), abs=1e-9)


def test_the_growth_is_drawn(measured):
    assert (measured / "bench.svg").read_text().startswith("<?xml")


def test_a_budget_holds_up_to_its_bound_and_no_further():
    def holds(value, **bound):
        return Measurement(part="p", name="n", unit="x", values=(value,), **bound).holds

    assert holds(3.0, at_most=3.0)
    assert not holds(3.1, at_most=3.0)
    assert holds(10.0, at_least=10.0)
    assert not holds(9.9, at_least=10.0)
    assert holds(1.0) is None


def test_the_median_counts():
    measure = Measurement(part="p", name="n", unit="x", values=(9.0, 1.0, 2.0))
    assert measure.median == 2.0


def test_what_is_compared_is_called_in_turn():
    calls = []
    subjects = {name: lambda name=name: calls.append(name) for name in "ab"}
    times = alternate(subjects, repetitions=2, calls=2)
    assert "".join(calls) == "aabb" * 3
    assert [len(each) for each in times.values()] == [2, 2]
    calls.clear()
    alternate(subjects, repetitions=1, calls=4, turns=2)
    assert "".join(calls) == "aaaabbbb" + "aabb" * 2
