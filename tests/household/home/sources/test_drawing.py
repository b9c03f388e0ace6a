"""Homes from drawings in text."""

import textwrap

import pytest

from household.errors import HouseholdError
from household.home.check import problems
from household.home.floorplan import Door, Wall
from household.home.sources.drawing import from_drawing

ROOM = """
    +----=====-----+
    |BBB       TTTT|
    |  ^           |
    |  s        w  |
    |              |
    |          BBBB|
    +--------------+
"""


@pytest.fixture
def room():
    return from_drawing(ROOM, furniture={"B": "box", "T": "desk"}, tall="T")


def test_a_drawn_home_has_no_fault(room):
    assert problems(room) == ()


def test_walls_run_through_the_middle_of_the_characters(room):
    assert room.lower.tolist() == [0.0, 0.0]
    assert room.upper.tolist() == [15 * 0.25, 6 * 0.5]


def test_a_door_takes_up_whole_characters_and_walls_go_up_to_it(room):
    assert room.doors == (Door(start=(1.125, 3.0), end=(2.375, 3.0), open=False),)
    assert Wall(start=(0.0, 3.0), end=(1.125, 3.0)) in room.walls
    assert Wall(start=(2.375, 3.0), end=(3.75, 3.0)) in room.walls
    assert len(room.walls) == 5


def test_a_wall_across_is_broken_by_an_open_door():
    plan = from_drawing(
        """
        +---------+---------+
        |         |         |
        |    p    :    w    |
        |         :         |
        |         |         |
        +---------+---------+
        """
    )
    assert plan.doors == (Door(start=(2.5, 1.75), end=(2.5, 0.75), open=True),)
    assert [region.name for region in plan.regions] == ["playing", "working"]


def test_people_look_to_where_an_arrow_stands_and_else_up(room):
    sleeping, working = room.regions
    assert sleeping.center == (0.75, 1.5)
    assert sleeping.facing == (0.75, 2.35)
    assert working.facing == (3.0, 2.35)


@pytest.mark.parametrize(
    ("arrow", "facing"), [(">", (2.1, 1.0)), ("<", (0.4, 1.0)), ("v", (1.25, 0.15))]
)
def test_arrows_point_in_all_directions(arrow, facing):
    around = {">": " p>", "<": "<p ", "v": " p "}[arrow]
    below = " v " if arrow == "v" else "   "
    plan = from_drawing(
        f"""
        +---------+
        |         |
        |   {around}   |
        |   {below}   |
        +---------+
        """
    )
    assert plan.regions[0].facing == pytest.approx(facing)


def test_what_there_is_several_of_is_numbered(room):
    assert [(box.name, box.tall) for box in room.furniture] == [
        ("box", False),
        ("desk", True),
        ("box 2", False),
    ]
    assert room.furniture[1].size == (1.0, 0.5)
    assert room.furniture[1].center == (3.125, 2.5)


def test_indentation_does_not_matter(room):
    again = from_drawing(
        textwrap.dedent(ROOM), furniture={"B": "box", "T": "desk"}, tall="T"
    )
    assert again == room


@pytest.mark.parametrize(
    ("drawing", "complaint"),
    [
        ("", "nothing in it"),
        ("+-+\n|?|\n+-+", "line 2, character 2: '?'; allowed"),
        (
            ROOM.replace("|BBB ", "|BBBB").replace("|  ^", "|BB^"),
            "B is no rectangle",
        ),
        (ROOM.replace("+--------------+\n", ""), "allowed"),
    ],
)
def test_what_cannot_be_a_home_is_explained_in_one_line(drawing, complaint):
    with pytest.raises(HouseholdError, match=r"^[^\n]*$") as error:
        from_drawing(drawing)
    assert complaint in str(error.value)
