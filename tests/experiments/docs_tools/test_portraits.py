from pathlib import Path

import pytest

from experiments.docs_tools import portraits

PAGE = Path(__file__).parents[3] / "docs" / "people.md"


@pytest.mark.parametrize("persona", ["silent", "strict"])
def test_the_page_on_people_shows_what_the_program_prints(persona, monkeypatch):
    """For two of the personas; the others take as long again each."""
    monkeypatch.setattr(portraits, "shipped", lambda kind: [persona])
    header, _, row = portraits.table()
    lines = PAGE.read_text("utf-8").splitlines()
    assert header in lines
    assert row in lines


def test_the_same_seed_gives_the_same_portrait():
    counts = portraits.watch("punisher", seed=4)
    assert counts == portraits.watch("punisher", seed=4)
    assert counts != portraits.watch("punisher", seed=5)


def test_who_only_punishes_is_pleased_and_never_caresses():
    counts = portraits.watch("punisher", seed=4)
    assert counts["pleased"] > 0
    assert counts["caresses"] == 0
    assert counts["annoyed"] > counts["taps"] > 0
