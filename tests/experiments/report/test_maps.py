"""Maps and ablations are shown as far as they were run, in the report and on a page."""

import polars as pl
import pytest

from experiments.docs_tools.maps import page
from experiments.report.maps import ablation_tables, drawn_maps, teacher_table
from experiments.running.store import Results
from experiments.studies import teachers
from experiments.studies.ablations import ABLATIONS, OUTCOMES
from experiments.studies.maps import MAPS


@pytest.fixture(scope="module")
def mapped(tmp_path_factory, play_trial):
    """A directory with one map, one ablation, and one experiment's teachers.

    Trials of the teachers are of a toy home, the others' numbers are made up.
    """
    out = tmp_path_factory.mktemp("maps")
    attention, rates = MAPS["attention"], ABLATIONS["rate_representation"]
    for study, names in (
        (attention.study((0, 1)), attention.ids),
        (rates.study((0, 1)), OUTCOMES),
        (teachers.study(1, (0, 1)), ()),
    ):
        results = Results(out / study.name)
        results.prepare(study, {})
        for index, trial in enumerate(study.trials()):
            made = pl.DataFrame({name: [float(index % 2)] for name in names})
            results.write(trial, made if names else play_trial(trial, 60))
    return out


def test_a_map_is_drawn_with_a_column_for_each_claim(mapped):
    (drawn,) = drawn_maps(mapped)
    assert drawn.n_seeds == 2
    assert len(drawn.figure.svgs) == 2
    assert all(file.is_file() for file in drawn.figure.files)
    assert len(drawn.found) == 2 * len(drawn.mapped.cells)
    assert len(drawn.sentences) == 3


def test_an_ablation_has_a_table_of_means_and_one_of_effects(mapped):
    (summary,) = ablation_tables(mapped)
    assert summary.table.header[1:] == summary.effects.header[1:]
    assert [len(cells) for _, cells in summary.table.rows] == [len(OUTCOMES)] * 4
    assert [heading for heading, _ in summary.effects.rows] == [
        "rate: social instead of asynchronous",
        "situation: roles and attention instead of roles",
        "rate x situation: more together",
    ]


def test_claims_have_a_row_each_and_teachers_a_column(mapped):
    table = teacher_table(mapped)
    assert table.header == ("claim", *teachers.TEACHERS)
    assert [heading.partition(",")[0] for heading, _ in table.rows] == [
        *("1a", "1b", "1c"),
        *("1a", "1b", "1c"),
    ]
    for _, (own, *others) in table.rows:
        assert not own.marked
        for cell in others:
            assert cell.marked == (cell.text[-1] != own.text[-1])


def test_what_was_not_run_is_not_shown(tmp_path):
    assert drawn_maps(tmp_path) == ()
    assert ablation_tables(tmp_path) == ()
    assert teacher_table(tmp_path) is None


def test_the_page_shows_the_map_and_both_tables(mapped, tmp_path):
    page(mapped, tmp_path / "maps.md")
    text = (tmp_path / "maps.md").read_text("utf-8")
    assert "](pictures/map_attention.svg)" in text
    assert (tmp_path / "pictures" / "map_attention.svg").is_file()
    assert "## Other teachers" in text
    assert "### Experiments 1 and 2: rate x situation" in text
    assert "| rate: social instead of asynchronous |" in text
