"""The pages on generalization say what the numbers say."""

import json

import pytest

from experiments.cli import main
from experiments.docs_tools.generalization import page
from experiments.generalization.learners import GRID
from experiments.report.generalization import context, grid


def estimate(value):
    return {"value": value, "low": value - 0.1, "high": value + 0.1, "n": 3}


def condition(learner, value, touches=0):
    return {
        "factors": {"learner": learner, "new": "swap"},
        "touches": touches,
        "greedy": estimate(value),
        "deployed": estimate(value),
        "best_constant": 0.25,
    }


@pytest.fixture
def stored(tmp_path):
    findings = {
        "study": "transfer",
        "question": "What is carried over?",
        "seeds": 3,
        "trials": 6,
        "conditions": [
            condition("canonical", 0.61),
            condition("canonical", 0.99, touches=5),
            condition("within hearing, full", 0.87),
        ],
        "contrasts": [{"adjusted": 0.01}, {"adjusted": 0.4}],
        "sentences": ["Views win. Found.", "Analogy wins. Not found.", "By the way."],
    }
    folder = tmp_path / "transfer"
    folder.mkdir()
    (folder / "findings.json").write_text(
        json.dumps({"format": 2, "findings": findings})
    )
    (folder / "figure.svg").write_text('<?xml version="1.0"?>\n<svg id="a">x</svg>')
    (folder / "figure.png").write_bytes(b"png")
    return tmp_path


def test_what_was_found_and_what_was_not_stand_apart(stored):
    (part,) = context(stored)["parts"]
    assert part.found == ("Views win. Found.",)
    assert part.not_found == ("Analogy wins. Not found.",)
    assert part.further == ("By the way.",)
    assert part.headline == "Views win. Found."


def test_the_table_of_results_has_each_learner_in_its_place(stored):
    pooling, table = context(stored)["grid"]
    full = pooling.index("full")
    assert table["whole situation"][full] == "0.61 [0.51, 0.71]"
    assert table["views within hearing"][full] == "0.87 [0.77, 0.97]"
    assert table["views within hearing"][pooling.index("none")] == ""
    assert len(table) == len({each for each, _ in GRID.values()})


def test_without_the_study_the_table_is_empty():
    assert not any("".join(row) for row in grid(None)[1].values())


def test_the_report_of_studies_is_one_file(stored, capsys):
    assert main(["report", str(stored)]) == 0
    text = (stored / "generalization.html").read_text()
    assert "Views win. Found." in text
    assert 'id="transfer-a"' in text
    assert "Not run, or not finished: heterogeneity" in text
    assert "src=" not in text
    assert "generalization.html" in capsys.readouterr().out


def test_a_study_of_ones_own_is_reported_after_ours_or_alone(stored):
    (stored / "mine").mkdir()
    found = json.loads((stored / "transfer" / "findings.json").read_text())
    found["findings"]["study"] = "mine"
    (stored / "mine" / "findings.json").write_text(json.dumps(found))
    assert [part.name for part in context(stored)["parts"]] == ["transfer", "mine"]
    (stored / "transfer" / "findings.json").unlink()
    alone = context(stored)
    assert [part.name for part in alone["parts"]] == ["mine"]
    assert not alone["missing"]


def test_studies_of_other_kinds_are_left_to_their_own_page(stored):
    (stored / "crowd").mkdir()
    (stored / "crowd" / "findings.json").write_text("{}")
    assert [part.name for part in context(stored)["parts"]] == ["transfer"]


def test_the_page_of_the_documentation_has_its_pictures(stored, tmp_path):
    out = tmp_path / "docs" / "generalization.md"
    out.parent.mkdir()
    page(stored, out)
    text = out.read_text()
    assert "](pictures/generalization_transfer.png)" in text
    assert (out.parent / "pictures" / "generalization_transfer.png").is_file()
    assert "- Analogy wins. Not found." in text
    assert "3 seeds, 6 trials" in text


def test_what_the_page_says_of_studies_that_lie_elsewhere_stays(stored, tmp_path):
    out = tmp_path / "generalization.md"
    page(stored, out)
    before = out.read_text()
    assert "Not run, or not finished: heterogeneity, actors," in before
    page(stored, out)
    assert out.read_text() == before

    other = tmp_path / "other" / "cross_play"
    other.mkdir(parents=True)
    text = (stored / "transfer" / "findings.json").read_text()
    text = text.replace('"transfer"', '"cross_play"').replace("Views win", "Play wins")
    (other / "findings.json").write_text(text)
    page(other.parent, out)
    after = out.read_text()
    missing = before[before.index("Not run") :].partition("\n")[0]
    assert missing.replace(" cross_play,", "") in after
    assert after.startswith(before.partition("Not run")[0])
    assert before[before.index("## ") :].strip() in after
    assert after.index("## Transfer") < after.index("## Cross play")
    assert "- Play wins. Found." in after


def test_findings_of_another_format_are_refused(stored, capsys):
    file = stored / "transfer" / "findings.json"
    file.write_text(file.read_text().replace('"format": 2', '"format": 1'))
    assert main(["report", str(stored)]) == 2
    assert "another format" in capsys.readouterr().err
