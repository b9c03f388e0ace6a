"""The shipped homes, and the checks that every home has to pass."""

import math

import msgspec
import pytest

from household.errors import HouseholdError
from household.home.check import checked, problems
from household.home.floorplan import FloorPlan, Furniture, Wall, load_floorplan


@pytest.fixture
def smart_room():
    return load_floorplan("smart_room")


def changed(plan: FloorPlan, field: str, i: int, **changes: object) -> FloorPlan:
    """A copy of a plan in which one wall, door, region, ... is changed."""
    parts = list(getattr(plan, field))
    parts[i] = msgspec.structs.replace(parts[i], **changes)
    return msgspec.structs.replace(plan, **{field: tuple(parts)})


@pytest.mark.parametrize(
    ("field", "i", "changes", "fault"),
    [
        ("regions", 2, {"center": (9.0, 1.0)}, "regions[2].center: 'armchair' is outs"),
        (
            "regions",
            1,
            {"center": (0.5, 4.0)},
            "regions[1].center: 'sofa' is covered b",
        ),
        ("regions", 1, {"center": (0.2, 2.0)}, "regions[1].center: 'sofa' is where no"),
        ("regions", 1, {"center": (math.nan, 2.0)}, "regions[1].center[0]: nan is not"),
        (
            "regions",
            3,
            {"name": "phone"},
            "regions[4].name: 'phone' is also regions[3]",
        ),
        ("regions", 3, {"facing": (6.75, 3.9)}, "regions[3].facing: is the center its"),
        ("regions", 5, {"radius": 1.5}, "regions[5].radius: 1.5 m reaches into region"),
        ("regions", 3, {"radius": 1.5}, "regions[3].radius: 1.5 m takes in people beh"),
        ("furniture", 1, {"name": "sofa"}, "furniture[1].name: 'sofa' is also furnitu"),
        ("walls", 2, {"end": (8.0, 0.0)}, "walls[2]: has no length"),
        ("walls", 2, {"end": (800.0, 0.0)}, "walls: 800 m from end to end"),
        ("walls", 2, {"end": (8.0, 4.7)}, "regions[0].center: 'entrance' is outdoors"),
        ("doors", 0, {"open": True}, "doors[0].open: true, but it leads outdoors"),
        ("doors", 0, {"open": True, "end": (0.9, 0.0)}, "doors[0]: 0.50 m wide, nobod"),
        ("walls", 1, {"start": (0.4, 0.0)}, None),
    ],
)
def test_every_fault_is_named_with_its_path(smart_room, field, i, changes, fault):
    faults = problems(changed(smart_room, field, i, **changes))
    if fault is None:
        assert faults == ()
    else:
        assert any(line.startswith(fault) for line in faults), faults
        assert all("; allowed: " in line and "\n" not in line for line in faults)


def test_a_wall_across_an_open_door_is_a_fault(smart_room):
    walled = changed(smart_room, "walls", 1, start=(0.4, 0.0))
    faults = problems(changed(walled, "doors", 0, open=True))
    assert faults[0].startswith("doors[0]: walls[1] runs across it")


def test_a_region_that_nobody_can_walk_to_is_a_fault(smart_room):
    wall = Wall(start=(6.1, 0.0), end=(6.1, 5.0))
    split = msgspec.structs.replace(smart_room, walls=(*smart_room.walls, wall))
    assert [line.partition(";")[0] for line in problems(split)] == [
        "regions[3] 'desk': unreachable from region 'entrance'",
        "regions[4] 'phone': unreachable from region 'entrance'",
    ]


def test_furniture_may_stand_in_a_wall(smart_room):
    box = Furniture(name="fireplace", center=(8.0, 2.5), size=(0.4, 1.0), tall=True)
    pieces = (*smart_room.furniture, box)
    assert problems(msgspec.structs.replace(smart_room, furniture=pieces)) == ()


def test_a_checked_plan_is_returned_as_it_is(smart_room):
    assert checked(smart_room, "smart_room.toml") is smart_room


def test_the_first_fault_is_raised_in_one_line_with_the_file(smart_room):
    faulty = changed(smart_room, "regions", 2, center=(9.0, 1.0))
    with pytest.raises(HouseholdError) as caught:
        checked(faulty, "my.toml")
    assert str(caught.value) == (
        "my.toml: regions[2].center: 'armchair' is outside the plan; "
        "allowed: a place within the walls"
    )
