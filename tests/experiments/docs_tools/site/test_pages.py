"""What generated pages share: tables of other pages, areas, titles."""

import pytest

from experiments.docs_tools.site.pages import area, table_under, words
from experiments.errors import ExperimentError
from household.home.floorplan import Room


def test_the_table_under_a_heading_is_read_row_by_row(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "# A\n\n| x | y |\n| --- | --- |\n| 1 | 2 |\n\n## B\n\ntext\n\n"
        "| x | y |\n| --- | --- |\n| 3 | `4` |\n|  | 5 |\n",
        "utf-8",
    )
    assert table_under(page, "B") == [{"x": "3", "y": "`4`"}, {"x": "", "y": "5"}]
    with pytest.raises(ExperimentError, match="no table under 'C'"):
        table_under(page, "C")


def test_an_l_shaped_room_has_the_area_of_its_two_parts():
    corners = ((0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3))
    assert area(Room(name="hall", corners=corners)) == pytest.approx(8.0)


def test_a_name_of_the_code_becomes_a_title():
    assert words("quiet_work") == "Quiet work"
