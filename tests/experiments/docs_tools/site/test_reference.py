"""The API reference covers every room that users call, module by module."""

from experiments.docs_tools.site.reference import LEFT_OUT, rooms_of, write_reference


def test_every_room_is_a_page_or_left_out_on_purpose():
    rooms = rooms_of("household")
    assert rooms["household.scenario"][0] == "household.scenario"
    assert "household.scenario.family" in rooms["household.scenario"]
    assert {f"household.{name}" for name in LEFT_OUT["household"]} & set(rooms) == set()


def test_a_page_hands_each_module_to_sphinx(tmp_path):
    write_reference(tmp_path)
    page = (tmp_path / "learners.credit.md").read_text("utf-8")
    assert ".. automodule:: learners.credit.rules\n" in page
    index = (tmp_path / "index.md").read_text("utf-8")
    assert "| [learners.credit](learners.credit.md) |" in index
