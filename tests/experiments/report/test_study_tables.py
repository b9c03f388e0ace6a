"""What was run of the factorial and of the sensitivity table, for the report."""

from experiments.report.study_tables import summarize_factorial, summarize_sensitivity
from experiments.studies import sensitivity


def test_what_was_run_of_the_factorial_is_shown(stored):
    (shown,) = summarize_factorial(stored)
    assert (shown.number, shown.n_seeds) == (1, 2)
    assert len(shown.table.rows) == 9
    marked = [
        (heading, cell.text)
        for heading, cells in shown.table.rows
        for cell in cells
        if cell.marked
    ]
    assert marked == [("asynchronous, immediate", "52 %")]
    assert len(shown.findings) == len(shown.silence) == 2


def test_a_factorial_with_missing_trials_is_not_shown(stored):
    next((stored / "factorial").rglob("*.parquet")).unlink()
    assert summarize_factorial(stored) == ()


def test_the_sensitivity_table_marks_verdicts_that_change(
    stored, varied, plain_table, variants, monkeypatch
):
    monkeypatch.setattr(sensitivity, "variants", variants)
    frame = plain_table
    assert summarize_sensitivity(stored, {1: frame}).firm == ("1a", "1b", "1c")
    kept = stored / varied.name / "verdicts.json"
    held = sensitivity.holding(varied, frame, stored, (0, 1))
    word = str(held["1a"]).lower(), str(not held["1a"]).lower()
    kept.write_text(kept.read_text().replace(f'"1a": {word[0]}', f'"1a": {word[1]}'))
    shown = summarize_sensitivity(stored, {1: frame})
    assert shown.firm == ("1b", "1c")
    row = dict(shown.table.rows)["learner: gamma"]
    assert [cell.marked for cell in row] == [True, False, False]
    assert row[0].text == ("?|✗" if held["1a"] else "?|✓")
    assert list(dict(shown.table.rows)) == ["learner: gamma"]


def test_without_a_sensitivity_run_there_is_no_table(tmp_path):
    assert summarize_sensitivity(tmp_path, {}) is None
