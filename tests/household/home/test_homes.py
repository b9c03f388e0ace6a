"""The shipped homes, and the checks that every home has to pass."""

import math

import msgspec
import numpy as np
import pytest

from household.config.toml import shipped
from household.errors import HouseholdError
from household.home.check import checked, problems
from household.home.floorplan import FloorPlan, Furniture, Wall, load_floorplan
from household.home.geometry import distance_to_segments
from household.home.navigation.routes import routes_of
from household.perception.obstruction import between

HOMES = ("smart_room", "studio", "two_room_flat", "family_apartment", "villa")
ACTIVITIES = {"working", "reading", "sleeping", "playing", "entering", "calling"}


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
        (
            "regions",
            1,
            {"center": (math.nan, 2.0)},
            "regions[1].center[0]: nan; allowed",
        ),
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
        "regions[3].center: 'desk' is unreachable from region 'entrance'",
        "regions[4].center: 'phone' is unreachable from region 'entrance'",
    ]


@pytest.mark.parametrize(
    ("thickness", "faults"),
    [
        (0.02, ()),
        (0.3, ()),
        (0.7, ("wall_thickness: 0.7 m; allowed: at most 0.5 m",)),
    ],
)
def test_walls_may_be_thin_or_thick_within_reason(smart_room, thickness, faults):
    assert problems(msgspec.structs.replace(smart_room, wall_thickness=thickness)) == (
        faults
    )


def test_a_body_may_not_overlap_a_wall_although_its_cell_is_free(smart_room):
    """A cell is free if a body fits in its middle; elsewhere it may not, by an inch."""
    oblique = Wall(start=(4.0, 2.0), end=(5.0, 3.0))
    walls = (*smart_room.walls, oblique)
    plan = msgspec.structs.replace(smart_room, walls=walls, furniture=())
    routes = routes_of(plan)
    beside = [(4.5 - gap, 2.5 + gap) for gap in np.arange(0.15, 0.3, 0.002).tolist()]
    tight = [spot for spot in beside if routes.free[routes.cell(spot)]]
    too_tight = [spot for spot in tight if not routes.has_room(spot)]
    assert 0 < len(too_tight) < len(tight)
    for spot in too_tight:
        assert math.dist(spot, (4.5, 2.5)) < 0.3
        faults = problems(changed(plan, "regions", 2, center=spot))
        assert any("'armchair' is where no body fits" in fault for fault in faults)


def test_a_gap_that_only_looks_pass_is_a_fault_too(smart_room):
    slit = changed(smart_room, "walls", 2, end=(8.0, 4.8))
    assert problems(slit)[0].startswith("regions[0].center: 'entrance' is outdoors")
    assert problems(changed(smart_room, "walls", 2, end=(8.0, 4.95))) == ()


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


def test_every_shipped_home_is_tested_here():
    assert set(HOMES) == set(shipped("home"))


@pytest.mark.parametrize("name", HOMES)
def test_a_shipped_home_has_no_fault_and_all_six_activities(name):
    plan = load_floorplan(name)
    assert plan.name == name
    assert plan.description
    assert problems(plan) == ()
    assert {region.activity for region in plan.regions} == ACTIVITIES


@pytest.mark.parametrize("name", HOMES)
def test_people_enter_just_inside_a_front_door_that_stays_shut(name):
    plan = load_floorplan(name)
    front = next(door for door in plan.doors if not door.open)
    (entrance,) = (r for r in plan.regions if r.activity == "entering")
    middle = np.add(front.start, front.end) / 2
    assert 0.3 < math.dist(entrance.center, middle) < 1.0


@pytest.mark.parametrize("name", HOMES)
def test_two_people_pass_in_every_doorway(name):
    plan = load_floorplan(name)
    for door in plan.doors:
        if door.open:
            assert math.dist(door.start, door.end) - plan.wall_thickness >= 4 * 0.25


@pytest.mark.parametrize("name", HOMES)
def test_all_furniture_is_within_the_outer_walls(name):
    plan = load_floorplan(name)
    for box in plan.furniture:
        assert (np.array(box.corners) >= plan.lower).all(), box.name
        assert (np.array(box.corners) <= plan.upper).all(), box.name


@pytest.mark.parametrize(
    ("name", "rooms", "regions"),
    [("studio", 3, 6), ("two_room_flat", 5, 6), ("family_apartment", 8, 12)],
)
def test_homes_grow_with_the_people_in_them(name, rooms, regions):
    plan = load_floorplan(name)
    assert (len(plan.rooms), len(plan.regions)) == (rooms, regions)


def test_the_villa_has_twelve_rooms_and_only_its_storeroom_is_shut():
    plan = load_floorplan("villa")
    assert len(plan.rooms) == 12
    _, storeroom = (door for door in plan.doors if not door.open)
    assert storeroom.start == (5.0, 6.2)


@pytest.mark.parametrize("name", ["family_apartment", "villa"])
def test_each_of_two_parents_and_two_children_has_a_bed(name):
    plan = load_floorplan(name)
    beds = {r.name for r in plan.regions if r.activity == "sleeping"}
    assert beds == {f"{who}'s bed" for who in ("mother", "father", "son", "daughter")}


def sees(plan: FloorPlan, a: str, b: str) -> bool:
    """Whether the straight line between two regions' centers meets nothing opaque."""
    p, q = (np.array(plan.region(name).center) for name in (a, b))
    line = p + np.linspace(0.0, 1.0, 2000)[:, None] * (q - p)
    return bool(distance_to_segments(line, plan.opaque_segments).min() > 0.01)


@pytest.mark.parametrize(
    ("name", "a", "b", "visible"),
    [
        ("smart_room", "sofa", "phone", True),
        ("studio", "sofa", "bed", False),  # the bookshelf stands between them
        ("studio", "rug", "bed", True),
        ("two_room_flat", "bed", "kitchen phone", False),
        ("family_apartment", "entrance", "hall phone", True),
        ("family_apartment", "son's bed", "daughter's bed", False),
        ("villa", "entrance", "library", False),
        ("villa", "entrance", "rug", True),  # through two doorways in line
    ],
)
def test_walls_and_tall_furniture_hide_people_doorways_show_them(name, a, b, visible):
    assert sees(load_floorplan(name), a, b) is visible


@pytest.mark.parametrize("name", HOMES)
def test_what_can_stand_between_two_is_told_by_fewer_lines_and_the_same(name):
    """Inner walls instead of all, two diagonals instead of four sides of a box."""
    plan = load_floorplan(name)
    routes, entrance = routes_of(plan), np.array(plan.regions[0].center)
    inside = [spot for spot in routes.centers() if routes.connects(spot, entrance)]
    ends = np.random.default_rng(0).choice(inside, size=(2000, 2))

    def crossed(segments):
        columns = np.ascontiguousarray(segments.T)
        return np.array([between(pair, 0, 1, columns) for pair in ends])

    walls, sides = np.split(plan.opaque_segments, [len(plan.wall_segments)])
    assert len(plan.parting_walls) < len(walls)
    assert len(plan.tall_diagonals) == len(sides) / 2
    np.testing.assert_array_equal(crossed(plan.parting_walls), crossed(walls))
    hidden = crossed(sides) > 0
    np.testing.assert_array_equal(crossed(plan.tall_diagonals) > 0, hidden)
    assert hidden.any() != (name == "smart_room")  # its bookshelf is at a wall
