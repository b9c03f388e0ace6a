"""`household validate` says what is not as published, and counts the rest."""

from rich.console import Console

from experiments.analysis.statistics import mean
from experiments.commands.validating import Validate, _counts, _differences
from experiments.validation import results
from experiments.validation.figures import Published, finding, not_modeled
from experiments.validation.scenes import Scene

KNOWN = Published(
    name="a figure",
    unit="s",
    said="about 2",
    low=1.5,
    high=2.5,
    source="us",
    reading="",
)


def lines(table):
    console = Console(width=100)
    with console.capture() as text:
        console.print(table)
    return [line.split() for line in text.get().splitlines() if line.strip()]


def test_what_is_off_or_undecided_is_listed():
    found = {
        "Group": [
            finding(KNOWN, "fine", mean([2.0, 2.0])),
            finding(KNOWN, "wrong", mean([9.0, 9.0])),
            finding(KNOWN, "wide", mean([1.0, 3.0])),
            not_modeled(KNOWN),
        ]
    }
    rows = lines(_differences(found))[2:]
    assert [(row[0], row[-1]) for row in rows] == [
        ("wrong", "off"),
        ("wide", "undecided"),
    ]
    assert lines(_counts(found))[2] == ["Group", "1", "1", "1", "1"]


def test_it_stores_what_it_found_and_names_the_file(tmp_path, monkeypatch, capsys):
    scene = Scene(name="a scene", watch=_two, published=(KNOWN,), seeds=1)
    monkeypatch.setattr(results, "GROUPS", {"Delays": (scene,)})
    Validate(out=tmp_path / "new", workers=1).run()
    assert (tmp_path / "new" / "validation.json").is_file()
    assert "validation.json" in capsys.readouterr().out


def _two(seed):
    return {"a figure": 2.0 + 0.0 * seed}
