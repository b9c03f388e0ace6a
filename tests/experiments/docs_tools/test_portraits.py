from pathlib import Path

import pytest

from experiments.docs_tools import portraits

PAGE = Path(__file__).parents[3] / "docs" / "people.md"


@pytest.mark.parametrize("persona", ["silent", "strict", "praising"])
def test_the_page_on_people_shows_what_comes_out_now(persona, monkeypatch):
    """For three of the personas; else `make golden` was forgotten."""
    monkeypatch.setattr(portraits, "shipped", lambda kind: [persona])
    header, _, row = portraits.table()
    lines = PAGE.read_text("utf-8").splitlines()
    assert header in lines
    assert row in lines


def test_renewing_a_page_changes_its_table_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.setattr(portraits, "shipped", lambda kind: ["strict"])
    page, table = tmp_path / "page.md", list(portraits.table())
    old = f"{portraits.HEADER}\n| --- |\n| gone | 1 |\n| gone | 2 |\n"
    page.write_text(f"Before\n\n{old}\nAfter\n", "utf-8")
    portraits.renew(page)
    assert page.read_text("utf-8").splitlines() == ["Before", "", *table, "", "After"]


def test_a_page_without_a_table_is_refused_and_left_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(portraits, "shipped", lambda kind: [])
    page = tmp_path / "page.md"
    page.write_text("nothing\n", "utf-8")
    with pytest.raises(ValueError, match="0 tables"):
        portraits.renew(page)
    assert page.read_text("utf-8") == "nothing\n"


def test_the_same_seed_gives_the_same_portrait():
    counts = portraits.watch("punisher", seed=4)
    assert counts == portraits.watch("punisher", seed=4)
    assert counts != portraits.watch("punisher", seed=5)


def test_who_only_punishes_is_pleased_and_never_caresses():
    counts = portraits.watch("punisher", seed=4)
    assert counts["pleased"] > 0
    assert counts["caresses"] == 0
    assert counts["annoyed"] > counts["taps"] > 0


def test_teachers_differ_as_the_page_says_of_them():
    lines = PAGE.read_text("utf-8").splitlines()
    cells = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines]
    rows = {row[0]: row for row in cells if len(row) == 7}
    praise = {name: float(rows[name][5]) for name in TEACHERS}
    sanction = {name: float(rows[name][6]) for name in TEACHERS}
    assert praise["fading"] < praise["praising"] < praise["skipping"]
    assert sanction["praising"] < sanction["fading"] < sanction["skipping"]
    assert praise["praising"] > sanction["praising"]
    assert all(praise[n] < sanction[n] for n in TEACHERS if n != "praising")
    assert praise["mistaken"] > praise["skipping"]  # some of its taps are caresses


TEACHERS = ("paper_actor", "praising", "fading", "mistaken", "skipping")
