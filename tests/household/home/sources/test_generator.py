"""Generated homes: always sound, never twice the same, and kept as TOML."""

import math

import numpy as np
import pytest

from household.errors import HouseholdError
from household.home.check import problems
from household.home.navigation.routes import routes_of
from household.home.sources.furnishing import gap
from household.home.sources.generator import generate

ACTIVITIES = {"working", "reading", "sleeping", "playing", "entering", "calling"}


def area(plan) -> float:
    """Area within the outer walls, which are a rectangle [m2]."""
    return float(np.prod(plan.upper - plan.lower))


@pytest.mark.parametrize("block", range(10))
def test_any_seed_and_number_of_rooms_gives_a_home_without_fault(block):
    for seed in range(20 * block, 20 * block + 20):
        plan = generate(seed, rooms=1 + seed % 9)
        assert problems(plan) == ()
        assert {region.activity for region in plan.regions} == ACTIVITIES
        assert len(plan.rooms) == 1 + seed % 9


@pytest.mark.parametrize("seed", range(10))
def test_every_room_can_be_walked_into(seed):
    plan = generate(seed, rooms=8)
    routes = routes_of(plan)
    entrance = np.array(plan.region("entering").center)
    for room in plan.rooms:
        low, high = np.min(room.corners, axis=0), np.max(room.corners, axis=0)
        spots = np.argwhere(routes.free).tolist()
        centers = routes.centers().reshape(*routes.free.shape, 2)
        inside = [
            centers[i, j]
            for i, j in spots
            if (centers[i, j] > low).all() and (centers[i, j] < high).all()
        ]
        walkable = sum(routes.connects(entrance, spot) for spot in inside)
        assert walkable == len(inside) > 0, room.name


def test_the_same_seed_gives_the_same_home():
    assert generate(5, rooms=7) == generate(5, rooms=7)


def test_a_generator_gives_the_home_of_its_seed_under_a_plainer_name():
    drawn = generate(np.random.default_rng(5), rooms=3)
    assert drawn.name == "generated_3"
    assert generate(5, rooms=3).name == "generated_3_5"
    assert drawn.walls == generate(5, rooms=3).walls
    assert drawn.regions == generate(5, rooms=3).regions


def test_different_seeds_give_different_homes():
    homes = [generate(seed, rooms=4) for seed in range(30)]
    assert len({plan.walls for plan in homes}) == 30
    assert len({plan.regions for plan in homes}) == 30


def test_a_home_grows_with_the_area_of_its_rooms():
    # The shares of living room, bedroom, hall and study add up to 1.6 + 1.0 + 0.9 + 0.9
    # mean rooms.
    for room_area in (12.0, 30.0):
        plan = generate(1, rooms=4, room_area=room_area)
        assert area(plan) == pytest.approx(4.4 * room_area, rel=0.03)


def test_without_loops_the_doors_form_a_tree():
    for seed in range(10):
        assert len(generate(seed, rooms=6, loops=0.0).doors) == 6


def test_with_loops_there_are_several_ways_round():
    assert len(generate(0, rooms=6, loops=1.0).doors) > 6


def test_without_clutter_there_is_only_what_activities_need():
    plan = generate(2, rooms=6, clutter=0.0)
    regions = {region.name for region in plan.regions}
    assert {box.name for box in plan.furniture} <= regions


def test_people_can_pass_between_any_two_pieces_of_furniture_in_a_room():
    plan = generate(3, rooms=9, clutter=1.0)
    compared = 0
    for room in plan.rooms:
        bounds = [
            (*np.min(box.corners, axis=0), *np.max(box.corners, axis=0))
            for box in plan.furniture
            if box.name.startswith(f"{room.name} ")
        ]
        gaps = [gap(a, b) for i, a in enumerate(bounds) for b in bounds[:i]]
        assert min(gaps, default=1.0) >= 0.79, room.name
        compared += len(gaps)
    assert compared > 9


def test_a_large_villa_can_be_generated():
    plan = generate(0, rooms=16)
    assert len(plan.rooms) == 16
    assert {"bedroom", "bedroom 2"} <= {room.name for room in plan.rooms}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"rooms": 0}, "rooms: 0 is out of range; allowed: 1 to 16"),
        ({"rooms": 17}, "rooms: 17 is out of range; allowed: 1 to 16"),
        ({"room_area": 3.0}, "room_area: 3.0 is out of range; allowed: 10.0 to 40.0"),
        ({"clutter": 2.0}, "clutter: 2.0 is out of range; allowed: 0.0 to 1.0"),
        ({"loops": math.nan}, "loops: nan is out of range; allowed: 0.0 to 1.0"),
    ],
)
def test_arguments_out_of_range_are_refused_in_one_line(arguments, message):
    with pytest.raises(HouseholdError) as caught:
        generate(0, **arguments)
    assert str(caught.value) == message
