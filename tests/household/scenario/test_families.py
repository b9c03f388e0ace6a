"""Scenario families: households drawn by seed, one thing at a time."""

import re

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from household.config.toml import locate, shipped
from household.errors import HouseholdError
from household.scenario.family import MOST_PEOPLE, MOST_ROBOTS, Draw, draw, load_family
from household.scenario.files import check_file
from household.scenario.validation import problems

FAMILIES = tuple(shipped("family"))


def test_at_least_eight_families_say_in_one_line_what_they_demand():
    demands = [load_family(name).demand for name in FAMILIES]
    assert len(set(demands)) == len(FAMILIES) >= 8
    assert all(demand and "\n" not in demand for demand in demands)


@pytest.mark.parametrize("name", FAMILIES)
@settings(max_examples=6, deadline=None)
@given(
    seed=st.integers(0, 2**32),
    people=st.integers(1, MOST_PEOPLE),
    robots=st.integers(1, MOST_ROBOTS),
)
def test_whatever_is_drawn_is_a_scenario_without_faults(name, seed, people, robots):
    scenario = draw(name, Draw(seed=seed, n_people=people, n_robots=robots))
    assert tuple(problems(scenario)) == ()
    assert (len(scenario.people), len(scenario.robots)) == (people, robots)


def test_the_same_seed_draws_the_same_household():
    assert draw("party", 5) == draw("party", 5)
    assert draw("party", 5) != draw("party", 6)


def traits(scenario):
    return [(person.name, person.persona) for person in scenario.people]


def duties(scenario):
    return [tuple(person.schedule) for person in scenario.people]


@pytest.mark.parametrize("what", ["home", "people", "roles"])
def test_one_thing_changes_while_the_others_stay(what):
    family = load_family("family_evening")
    same = {"seed": 1, "home": 2, "people": 3, "roles": 4, "n_people": 6}
    one = draw(family, Draw(**same))
    others = [draw(family, Draw(**(same | {what: seed}))) for seed in range(10, 20)]
    changed = {
        "home": {other.home != one.home for other in others},
        "people": {traits(other) != traits(one) for other in others},
        "roles": {duties(other) != duties(one) for other in others},
    }
    assert True in changed.pop(what)
    assert all(each == {False} for each in changed.values())


def test_people_of_different_seeds_never_share_a_name():
    names = [
        {person.name for person in draw("party", Draw(people=seed)).people}
        for seed in range(20)
    ]
    assert sum(map(len, names)) == len(set().union(*names))


def test_robots_stand_in_the_open_whatever_the_home():
    for seed in range(20):
        scenario = draw("greeting", Draw(seed=seed, n_robots=MOST_ROBOTS))
        for robot in scenario.robots:
            x, y = robot.position
            gaps = [
                ((x - r.center[0]) ** 2 + (y - r.center[1]) ** 2) ** 0.5 - r.radius
                for r in scenario.plan.regions
            ]
            assert min(gaps) > 0.4


def test_heterogeneity_can_be_chosen_where_a_household_is_drawn():
    assert draw("phone", Draw(seed=1, heterogeneity=0.0)).heterogeneity == 0.0
    assert draw("phone", 1).heterogeneity == load_family("phone").heterogeneity


def test_a_family_that_does_not_exist_is_one_line_with_the_nearest_name():
    with pytest.raises(HouseholdError, match="party"):
        load_family("partty")


def test_a_family_that_cannot_be_placed_is_one_line(tmp_path):
    family = load_family("party")
    tight = msgspec.structs.replace(
        family, home=msgspec.structs.replace(family.home, room_area=(500.0, 600.0))
    )
    with pytest.raises(HouseholdError, match="room_area") as error:
        draw(tight, 1)
    assert "\n" not in str(error.value)


def test_a_persona_of_a_family_speaks_of_behaviors_that_there_are(tmp_path):
    path = tmp_path / "own.toml"
    text = locate("party", "family").read_text("utf-8")
    mine = '{name = "odd", preferences = {calling = {absorbed = {brak = 1.0}}}}'
    path.write_text(re.sub(r"personas = \[", f"personas = [{mine}, ", text, count=1))
    told = r"personas\[0\].preferences.calling.absorbed: unknown behavior 'brak'"
    with pytest.raises(HouseholdError, match=told):
        load_family(str(path))
    (line,) = check_file(path)
    assert re.search(told, line)
