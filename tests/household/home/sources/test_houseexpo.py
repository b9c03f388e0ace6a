"""Homes imported from files in HouseExpo's format, two of them made by hand."""

import json
from pathlib import Path

import numpy as np
import pytest

from household.errors import HouseholdError
from household.home.check import problems
from household.home.floorplan import load_floorplan
from household.home.saving import save_floorplan
from household.home.sources.houseexpo import load_houseexpo

FOLDER = Path(__file__).parent / "houseexpo"
ACTIVITIES = {"working", "reading", "sleeping", "playing", "entering", "calling"}


@pytest.fixture
def flat():
    return load_houseexpo(FOLDER / "flat.json")


@pytest.fixture
def written(tmp_path):
    """Writes a HouseExpo file with some fields changed, and gives its path."""

    def write(**changes):
        house = json.loads((FOLDER / "flat.json").read_text()) | changes
        path = tmp_path / "house.json"
        path.write_text(json.dumps({k: v for k, v in house.items() if v is not None}))
        return path

    return write


@pytest.mark.parametrize("name", ["flat", "unlabeled"])
def test_an_imported_home_has_no_fault_and_all_six_activities(name):
    plan = load_houseexpo(FOLDER / f"{name}.json")
    assert plan.name == f"houseexpo_{name}"
    assert problems(plan) == ()
    assert {region.activity for region in plan.regions} == ACTIVITIES


def test_activities_are_in_the_rooms_that_suit_them(flat):
    assert [(region.activity, region.name) for region in flat.regions] == [
        ("entering", "hallway entering"),
        ("sleeping", "bedroom sleeping"),
        ("working", "office working"),
        ("playing", "living room playing"),
        ("reading", "living room reading"),
        ("calling", "living room calling"),  # the hallway is full
    ]
    boxes = {room.name: room.corners for room in flat.rooms}
    for region in flat.regions:
        corners = boxes[region.name.removesuffix(f" {region.activity}")]
        assert (np.array(region.center) >= np.min(corners, axis=0)).all()
        assert (np.array(region.center) <= np.max(corners, axis=0)).all()


def test_the_contour_becomes_the_walls_without_its_idle_corners(flat):
    # Of 24 corners, one closes the contour, two lie on a straight wall and one bends
    # its wall by less than a centimeter.
    assert len(flat.walls) == 20
    for wall, onward in zip(flat.walls, (*flat.walls[1:], flat.walls[0]), strict=True):
        assert wall.end == onward.start


def test_an_open_contour_is_closed(flat, written):
    verts = json.loads((FOLDER / "flat.json").read_text())["verts"]
    assert load_houseexpo(written(verts=verts[:-1])).walls == flat.walls


def test_every_bedroom_gets_a_bed(written):
    halves = [[-1.0, 6.0, 1.5, 9.2], [1.5, 6.0, 4.05, 9.2]]
    rooms = {"Bedroom": halves, "Hallway": [[5.1, 5.4, 6.3, 6.2]]}
    plan = load_houseexpo(written(room_category=rooms))
    beds = [region.name for region in plan.regions if region.activity == "sleeping"]
    assert beds == ["bedroom sleeping", "bedroom 2 sleeping"]


def test_a_house_without_labels_has_its_activities_somewhere(written):
    plan = load_houseexpo(written(room_category={}))
    assert {region.activity for region in plan.regions} == ACTIVITIES
    assert {region.name.split()[0] for region in plan.regions} == {"home"}
    assert problems(plan) == ()


def test_boxes_that_are_reversed_or_empty_do_no_harm(written):
    rooms = {"Bedroom": [[4.05, 9.2, -1.0, 6.0], [2.0, 7.0, 2.0, 8.0]]}
    plan = load_houseexpo(written(room_category=rooms))
    assert [room.name for room in plan.rooms] == ["bedroom"]
    assert plan.rooms[0].corners[0] == (-1.0, 6.0)


def test_regions_keep_to_the_part_of_the_home_that_hangs_together(written):
    # A closet of 1 m x 3 m, joined by a slit of 0.3 m, is labeled as the bedroom.
    verts = [[0, 0], [6, 0], [6, 4], [6.2, 4], [6.2, 1], [7.2, 1], [7.2, 4.3]]
    verts += [[5.7, 4.3], [5.7, 4], [0, 4]]
    plan = load_houseexpo(
        written(verts=verts, room_category={"Bedroom": [[6.2, 1, 7.2, 4]]})
    )
    assert plan.region("sleeping").center[0] < 6.0


def test_an_imported_home_can_be_kept_as_toml(flat, tmp_path):
    save_floorplan(flat, tmp_path / "flat.toml")
    assert load_floorplan(str(tmp_path / "flat.toml")) == flat


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"verts": None}, "missing required field `verts`"),
        ({"id": 7}, "id: Expected `str`, got `int`"),
        ({"verts": [[0, 0], [1, 1]]}, "verts: Expected `array` of length >= 3"),
        (
            {"verts": [[0, 0], [4, 0], ["a", 4]]},
            "verts[2][0]: Expected `float`, got `str`",
        ),
        ({"verts": [[0, 0], [4, 0], [4]]}, "verts[2]: Expected `array` of length 2"),
        ({"verts": [[0, 0], [4, 4], [8, 8]]}, "verts: encloses nothing"),
        ({"verts": [[0, 0], [900, 0], [900, 700]]}, "verts: 900 m x 700 m is no home"),
        ({"verts": [[0, 0], [1e200, 0], [4, 4]]}, "verts: 1e+200 m x 4 m is no home"),
        ({"verts": [[0, 0], [2, 0], [2, 2], [0, 2]]}, "verts: no free place for "),
        (
            {"room_category": {"Bedroom": [[0, 1]]}},
            "room_category.Bedroom[0]: Expected",
        ),
        ({"room_category": []}, "room_category: Expected `object`, got `array`"),
        # These took a minute before their size was bounded.
        (
            {"verts": [[i / 1000, 10 * (i % 2)] for i in range(12_000)]},
            "verts: Expected `array` of length <= 2000",
        ),
        (
            {"room_category": {"Kitchen": [[0, 0, 9, 9]] * 9000}},
            "room_category.Kitchen: Expected `array` of length <= 500",
        ),
    ],
)
def test_a_damaged_file_is_refused_in_one_line(written, changes, message):
    path = written(**changes)
    with pytest.raises(HouseholdError) as caught:
        load_houseexpo(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b'{"id": "half',
        b"\xff\xfe",
        b"[1, 2]",
        b"[" * 10_000,
        b"1" * 5000,
        b" " * 2**20,
    ],
)
def test_a_file_that_is_no_object_is_refused_in_one_line(tmp_path, content):
    path = tmp_path / "broken.json"
    path.write_bytes(content)
    with pytest.raises(HouseholdError) as caught:
        load_houseexpo(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert "\n" not in str(caught.value)


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(HouseholdError, match=r"none\.json: No such file"):
        load_houseexpo(tmp_path / "none.json")
